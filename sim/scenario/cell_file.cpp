#include "sim/scenario/cell_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/common/message_text.hpp"
#include "sim/scenario/name_key.hpp"
#include "sim/scenario/path_file.hpp"
#include "sim/scenario/solid_keys.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kFloorName = "the floor";

constexpr double kFarthest = 1000.0;  // m

}  // namespace

Cell read_cell(const yaml::Node& node, std::vector<std::string>& inputs) {
  yaml::MapReader map(node);
  Cell cell;
  if (map.has("floor")) cell.floor = map.number_in("floor", 0.0, -kFarthest, kFarthest);
  if (const yaml::Node* parts = map.optional("parts")) {
    for (const yaml::Node& item : parts->items()) {
      yaml::MapReader part(item);
      const std::string name = read_name(part);
      const bool known = std::any_of(cell.parts.begin(), cell.parts.end(),
                                     [&name](const CellPart& other) { return other.name == name; });
      const yaml::Node& named = part.required("name");
      if (known)
        named.fail(fmt::format("two parts have the name {}; rename one of them", shown(name)),
                   "another name");
      if (name == kFloorName)
        named.fail(fmt::format("the name '{}' is reserved for the floor; rename the part", kFloorName),
                   "another name");
      const Solid solid = read_solid(part);
      const Mat3 R_0S = read_turn(part);
      cell.parts.push_back({name, solid, R_0S, read_path(part, inputs)});
      part.finish();
    }
  }
  map.finish();
  return cell;
}

}  // namespace armtune::internal
