#pragma once
// The definition of a ROS 2 message type: its fields in the order in which they are serialised, and those of
// the types that it contains. It is parsed from text in the .msg format of ROS 2
// (https://docs.ros.org/en/rolling/Concepts/Basic/About-Interfaces.html).

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "armtune/error.hpp"

namespace armtune::internal {

/// The type of one element of a field. kTime and kDuration are builtin_interfaces/Time and Duration: int32
/// sec and uint32 nanosec. The types byte and char are kUint8, as in ROS 2.
enum class FieldKind : std::uint8_t {
  kBool,
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kTime,
  kDuration,
  kString,
  kWstring,
  kStruct
};

/// The number of elements of a field: one, a fixed number, or any number.
enum class FieldShape : std::uint8_t { kSingle, kArray, kSequence };

struct MessageField {
  std::string name;
  FieldKind kind = FieldKind::kFloat64;
  FieldShape shape = FieldShape::kSingle;
  std::size_t size = 0;  ///< of kArray: the number of elements; of kSequence: the most, 0 without bound
  std::size_t string_size = 0;  ///< of strings: the most characters, 0 without bound
  std::size_t type = 0;         ///< of kStruct: an index in MessageDefinition::types
};

struct MessageType {
  std::string name;  ///< "PACKAGE/TYPE", without "/msg"
  std::vector<MessageField> fields;
};

/// A type with all that it contains. No type contains itself.
struct MessageDefinition {
  std::vector<MessageType> types;  ///< at least one: the first is the type of the message
};

inline constexpr std::size_t kMostDefinitionBytes = 4U << 20U;  ///< longest text of a definition [byte]
inline constexpr std::size_t kMostMessageTypes = 1000;          ///< most types of a definition
inline constexpr std::size_t kMostFields = 20'000;              ///< most fields of all types of a definition
inline constexpr std::size_t kDeepestType = 32;                 ///< deepest nesting of types
inline constexpr std::size_t kLargestArray = 1U << 24U;         ///< largest array of a fixed size

/// The text that defines one type.
struct DefinitionText {
  std::string text;
  /// Where the text is. If it has a line, then text is a .msg file, and errors name its lines. Otherwise the
  /// text is part of another file, and errors name the lines of the text.
  InputPlace place;
};

/// Returns the text that defines the type "PACKAGE/TYPE"; nothing if it is not known.
using DefinitionLookup = std::function<std::optional<DefinitionText>(const std::string& type)>;

/// Returns the definition of the type. `find` gives its text, and the texts of the types that it contains.
/// `place` is where the type is asked for. Throws InputError for a type that is unknown or contains itself,
/// for a line that is not in the .msg format, for two fields of one name, and if a limit above is exceeded.
MessageDefinition build_definition(const std::string& type, const DefinitionLookup& find,
                                   const InputPlace& place);

/// Returns the definition in a schema of the encoding "ros2msg": the text of the type itself, then those of
/// the types in it, each after a line of 80 '=' and a line "MSG: PACKAGE/TYPE". builtin_interfaces may be
/// missing. Throws InputError as build_definition does, with `place`.
MessageDefinition parse_ros2msg(const std::string& schema, const std::string& type, const InputPlace& place);

/// Returns "PACKAGE/TYPE" for "PACKAGE/msg/TYPE"; any other text unchanged.
std::string short_type(const std::string& type);

}  // namespace armtune::internal
