#pragma once
// Parses one line of a .msg file.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "sim/logs/message_definition.hpp"

namespace armtune::internal {

/// Says what is wrong with a line. The caller adds the place.
class DefinitionFault : public std::invalid_argument {
 public:
  explicit DefinitionFault(InputFault fault)
      : std::invalid_argument(fault.problem), fault_(std::move(fault)) {}
  const InputFault& fault() const noexcept { return fault_; }

 private:
  InputFault fault_;
};

/// A field as its line declares it. A struct type is given by its name alone.
struct DeclaredField {
  MessageField field;
  std::string type;  ///< of kStruct: as written, such as "Point" or "geometry_msgs/Point"
};

/// Returns the field that the line declares; nothing for an empty line, a comment or a constant. Default
/// values are ignored, because serialised messages contain every value. Throws DefinitionFault if
/// the line is not in the .msg format.
std::optional<DeclaredField> parse_definition_line(std::string_view line);

}  // namespace armtune::internal
