#include "sim/scenario/name_key.hpp"

#include <fmt/format.h>

#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {

std::string read_name(yaml::MapReader& map) {
  const yaml::Node& node = map.required("name");
  std::string name = node.as_string();
  if (name.empty()) node.fail("the name is empty; give one", "a name");
  if (is_printable(name)) return name;
  node.fail(
      fmt::format("the name {} contains a control character or a line separator; rename it", shown(name)),
      "a printable name");
}

}  // namespace armtune::internal
