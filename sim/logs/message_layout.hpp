#pragma once
// Checks whether the bytes of a message fit a definition.

#include <cstddef>
#include <optional>
#include <span>

#include "sim/logs/cdr_reader.hpp"
#include "sim/logs/message_definition.hpp"

namespace armtune::internal {

/// How the middleware serialises a wstring: Fast DDS gives the number of characters and uses four bytes for
/// each, Cyclone DDS gives the number of bytes and uses two for each character.
enum class WstringForm : std::uint8_t { kFourBytes, kTwoBytes };

/// Most bytes that may follow the last value: serialised messages can be padded to a multiple of four bytes.
inline constexpr std::size_t kMostPadding = 3;

/// Passes over `count` elements of a field whose kind is not kStruct.
void skip_values(CdrReader& reader, const MessageField& field, std::size_t count, WstringForm form);

/// Passes over a field of a type of the definition, its length included.
void skip_field(CdrReader& reader, const MessageDefinition& definition, const MessageField& field,
                WstringForm form);

/// Passes over the values of a type of the definition.
void skip_struct(CdrReader& reader, const MessageDefinition& definition, std::size_t type, WstringForm form);

/// Returns the number of elements of a field. For a sequence, reads it at the current place of the message.
inline std::size_t element_count(CdrReader& reader, const MessageField& field) {
  if (field.shape == FieldShape::kSingle) return 1;
  return field.shape == FieldShape::kArray ? field.size : reader.length(field.size);
}

/// Returns the number of bytes that follow the last value of the message; nothing if the message ends before
/// it or is invalid. The message fits the definition if this is at most kMostPadding.
std::optional<std::size_t> surplus(std::span<const std::byte> message, const MessageDefinition& definition,
                                   WstringForm form);

/// True if the definition contains a wstring.
bool has_wstring(const MessageDefinition& definition);

}  // namespace armtune::internal
