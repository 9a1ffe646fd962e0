#include "sim/logs/message_layout.hpp"

#include <algorithm>

namespace armtune::internal {
namespace {

/// Returns the size of a number [byte]. Time and Duration are two numbers of four bytes.
std::size_t size_of(FieldKind kind) {
  switch (kind) {
    case FieldKind::kBool:
    case FieldKind::kInt8:
    case FieldKind::kUint8:
      return 1;
    case FieldKind::kInt16:
    case FieldKind::kUint16:
      return 2;
    case FieldKind::kInt64:
    case FieldKind::kUint64:
    case FieldKind::kFloat64:
      return 8;
    default:
      return 4;
  }
}

void skip_wstring(CdrReader& reader, WstringForm form) {
  const std::size_t length = reader.length(0);
  if (form == WstringForm::kFourBytes) return reader.skip(length, 4);
  reader.skip(length);
}

}  // namespace

void skip_values(CdrReader& reader, const MessageField& field, std::size_t count, WstringForm form) {
  const FieldKind kind = field.kind;
  if (kind == FieldKind::kString || kind == FieldKind::kWstring) {
    for (std::size_t i = 0; i < count && reader.fault() == CdrFault::kNone; ++i) {
      kind == FieldKind::kString ? static_cast<void>(reader.string(field.string_size))
                                 : skip_wstring(reader, form);
    }
    return;
  }
  const bool is_time = kind == FieldKind::kTime || kind == FieldKind::kDuration;
  reader.skip(is_time ? 2 * count : count, size_of(kind));
}

void skip_field(CdrReader& reader, const MessageDefinition& definition, const MessageField& field,
                WstringForm form) {
  const std::size_t count = element_count(reader, field);
  if (field.kind != FieldKind::kStruct) return skip_values(reader, field, count, form);
  for (std::size_t i = 0; i < count && reader.fault() == CdrFault::kNone; ++i)
    skip_struct(reader, definition, field.type, form);
}

void skip_struct(CdrReader& reader, const MessageDefinition& definition, std::size_t type, WstringForm form) {
  for (const MessageField& field : definition.types[type].fields) {
    if (reader.fault() != CdrFault::kNone) return;
    skip_field(reader, definition, field, form);
  }
}

std::optional<std::size_t> surplus(std::span<const std::byte> message, const MessageDefinition& definition,
                                   WstringForm form) {
  CdrReader reader(message);
  skip_struct(reader, definition, 0, form);
  if (reader.fault() != CdrFault::kNone) return std::nullopt;
  return reader.rest();
}

bool has_wstring(const MessageDefinition& definition) {
  const auto is_wstring = [](const MessageField& field) { return field.kind == FieldKind::kWstring; };
  return std::any_of(definition.types.begin(), definition.types.end(), [&](const MessageType& type) {
    return std::any_of(type.fields.begin(), type.fields.end(), is_wstring);
  });
}

}  // namespace armtune::internal
