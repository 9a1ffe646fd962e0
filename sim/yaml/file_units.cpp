#include "sim/yaml/file_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal::yaml {
namespace {

struct Unit {
  const char* key;
  const char* name;
  double factor;
};
constexpr std::array kUnits = {Unit{"time", "s", 1.0},     Unit{"time", "ms", 1e-3},
                               Unit{"time", "us", 1e-6},   Unit{"time", "ns", 1e-9},
                               Unit{"length", "m", 1.0},   Unit{"length", "cm", 1e-2},
                               Unit{"length", "mm", 1e-3}, Unit{"length", "in", 0.0254},
                               Unit{"angle", "rad", 1.0},  Unit{"angle", "deg", std::numbers::pi / 180.0},
                               Unit{"torque", "N m", 1.0}, Unit{"torque", "mN m", 1e-3}};

bool is_allowed(std::string_view key, std::string_view allowed) {
  return (" " + std::string(allowed) + " ").find(" " + std::string(key) + " ") != std::string::npos;
}

double factor_of(const Node& node, const char* key) {
  std::vector<std::string> known;
  for (const Unit& unit : kUnits) {
    if (std::string_view(unit.key) != key) continue;
    if (node.is_word(unit.name)) return unit.factor;
    known.emplace_back(unit.name);
  }
  node.fail_choice(known);
}

}  // namespace

FileUnits read_file_units(const Node& node, const char* allowed) {
  MapReader map(node);
  FileUnits units;
  for (const auto& [key, value] : {std::pair{"time", &units.time}, std::pair{"length", &units.length},
                                   std::pair{"angle", &units.angle}, std::pair{"torque", &units.torque}}) {
    if (!is_allowed(key, allowed)) continue;
    if (const Node* unit = map.optional(key)) *value = factor_of(*unit, key);
  }
  map.finish();
  return units;
}

bool check_unit(const std::string& unit, const FileUnits& units, const InputPlace& column) {
  const auto found =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return unit == u.name; });
  if (found == kUnits.end()) return false;
  const std::string_view key = found->key;
  const double said = key == "time"     ? units.time
                      : key == "length" ? units.length
                      : key == "angle"  ? units.angle
                                        : units.torque;
  if (said == found->factor) return true;
  throw InputError(
      column,
      fmt::format(
          "column {} has the unit {}; declare this unit together with the file's name: {{file: ..., units: {{{}: "
          "{}}}}}",
          shown(column.key), unit, found->key, unit))
      .with_value(unit, "the declared unit");
}

}  // namespace armtune::internal::yaml
