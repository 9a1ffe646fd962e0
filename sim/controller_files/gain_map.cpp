#include "sim/controller_files/gain_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/first_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_reader.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

/// Returns the value at the rest of a path, or null if there is none. A key may itself contain '/'.
const PlacedValue* value_at(const PlacedValue& from, std::string_view path) {
  const auto below = [path](std::string_view key, const PlacedValue& value) -> const PlacedValue* {
    if (path == key) return &value;
    const bool is_above = path.size() > key.size() && path.starts_with(key) && path[key.size()] == '/';
    return is_above ? value_at(value, path.substr(key.size() + 1)) : nullptr;
  };
  for (const yaml::PlacedEntry& entry : from.entries) {
    if (const PlacedValue* found = below(entry.key, *entry.value)) return found;
  }
  for (std::size_t k = 0; k < from.items.size(); ++k) {
    if (const PlacedValue* found = below(fmt::to_string(k), *from.items[k].value)) return found;
  }
  return nullptr;
}

/// A number of a gain: the field, and the place of the number in it.
struct Target {
  const GainField* field;
  std::size_t first;
  std::size_t count;
};

std::vector<std::string> own_names(const Gains& gains) {
  std::vector<std::string> names;
  for (const GainField& field : fields_of(gains)) {
    if (std::holds_alternative<OwnGain>(field.member)) names.emplace_back(field.name);
  }
  return names;
}

Target target_of(const Gains& gains, const std::string& gain, const std::vector<std::string>& joints,
                 const ParameterReader& reader) {
  const auto slash = gain.find('/');
  const std::string name = gain.substr(0, slash);
  for (const GainField& field : fields_of(gains)) {
    if (name != field.name || !std::holds_alternative<OwnGain>(field.member)) continue;
    const std::vector<std::string> parts = component_names(field, joints);
    if (slash == std::string::npos) return {&field, 0, parts.size()};
    const std::string part = gain.substr(slash + 1);
    const auto found = std::find(parts.begin(), parts.end(), part);
    if (found == parts.end() || parts.size() == 1)
      reader.fail(1, fmt::format("the map names gain '{}', but {} has no '{}'{}", gain, name, part,
                                 parts.size() == 1 ? std::string() : suggestion(part, parts)));
    return {&field, static_cast<std::size_t>(found - parts.begin()), 1};
  }
  const std::vector<std::string> names = own_names(gains);
  reader.fail(
      1, fmt::format("the map names gain '{}', but controller '{}' has no such gain of its own{}; it has: {}",
                     gain, gains.controller, suggestion(name, names), fmt::join(names, ", ")));
}

/// Calls `see` with every number of the file that the map names: its gain, place, name and index in the gain.
template <typename See>
void for_each_number(const RosController& controller, const std::string& file, const Gains& gains,
                     const std::vector<std::string>& joints, const See& see) {
  const ParameterReader reader(controller, file);
  for (const GainPlace& place : controller.places) {
    const Target target = target_of(gains, place.gain, joints, reader);
    const PlacedValue* value = value_at(*controller.all, place.path);
    if (value == nullptr)
      reader.fail(1, fmt::format("there is nothing at '{}', which the map names", place.path));
    const bool is_list = value->kind == PlacedValue::Kind::kSequence;
    const std::size_t count = is_list ? value->items.size() : 1;
    if (count != target.count)
      reader.fail(value->line,
                  fmt::format("'{}' has {} number{}, but {} has {}; name each joint: '{}/JOINT'", place.path,
                              count, count == 1 ? "" : "s", place.gain, target.count, target.field->name));
    for (std::size_t k = 0; k < count; ++k)
      see(reader, is_list ? *value->items[k].value : *value, *target.field, target.first + k, place.path);
  }
}

std::string name_of(const GainField& field, std::size_t k, const std::vector<std::string>& joints) {
  const std::vector<std::string> parts = component_names(field, joints);
  return parts.size() == 1 ? std::string(field.name) : fmt::format("{} of {}", field.name, parts[k]);
}

}  // namespace

std::optional<GainMap> gain_map(const std::string& text, const std::string& path) {
  const yaml::Node root = yaml::parse_text(text, path);
  if (root.kind() != yaml::Node::Kind::kMap || root.find("map") == nullptr) return std::nullopt;
  yaml::MapReader map(root);
  GainMap read;
  RosController& controller = read.controller;
  controller.layout = GainLayout::kMapped;
  controller.name = std::filesystem::path(path).filename().string();
  const yaml::Node& kind = map.required("controller");
  controller.kind = kind.as_string();
  const std::vector<std::string> kinds = joint_motion_controllers();
  if (std::find(kinds.begin(), kinds.end(), controller.kind) == kinds.end())
    kind.fail(fmt::format("'{}' is not a controller that a map can name{}; these are: {}", controller.kind,
                          suggestion(controller.kind, kinds), fmt::join(kinds, ", ")));
  const std::filesystem::path file = map.required("file").as_string();
  read.file = (std::filesystem::path(path).parent_path() / file).string();
  controller.ros2 = !map.boolean("ros1", false);
  const yaml::Node& places = map.required("map");
  if (places.kind() != yaml::Node::Kind::kMap || places.entries().empty())
    places.fail("expected at least one line 'PLACE: GAIN'");
  for (const auto& [place, gain] : places.entries()) controller.places.push_back({place, gain.as_string()});
  const Gains gains = joint_motion_gains(controller.kind, 1);
  for (const std::string& name : own_names(gains)) {
    const yaml::Node* value = map.optional(name);
    if (value == nullptr) continue;
    const bool is_list = value->kind() == yaml::Node::Kind::kSequence;
    controller.others.emplace_back(name, is_list ? value->as_numbers() : std::vector{value->as_number()});
  }
  map.finish();
  return read;
}

Gains mapped_gains(const RosController& controller, const std::string& file,
                   const std::vector<std::string>& joints) {
  Gains gains = joint_motion_gains(controller.kind, static_cast<Eigen::Index>(joints.size()));
  without_velocity_limits(gains);
  for (const auto& [name, values] : controller.others) {
    JointVector& own_values = own(gains, name);
    if (values.size() != 1 && values.size() != static_cast<std::size_t>(own_values.size()))
      ParameterReader(controller, file)
          .fail(1, fmt::format("the map gives {} numbers for {}, which has {}", values.size(), name,
                               own_values.size()));
    for (Eigen::Index k = 0; k < own_values.size(); ++k)
      own_values[k] = values.size() == 1 ? values[0] : values[static_cast<std::size_t>(k)];
  }
  std::set<std::pair<std::string, std::size_t>> given;
  for_each_number(controller, file, gains, joints,
                  [&](const ParameterReader& reader, const PlacedValue& value, const GainField& field,
                      std::size_t k, const std::string& place) {
                    if (!given.emplace(field.name, k).second)
                      reader.fail(value.line, fmt::format("the map gives {} twice, the second time at '{}'",
                                                          name_of(field, k, joints), place));
                    numbers(gains, field)[k] = reader.finite(value, fmt::format("'{}'", place));
                  });
  return gains;
}

std::vector<PlacedGain> placed_mapped_gains(const RosController& controller, const std::string& file,
                                            const Gains& gains, const std::vector<std::string>& joints) {
  std::vector<PlacedGain> placed;
  for_each_number(controller, file, gains, joints,
                  [&](const ParameterReader&, const PlacedValue& value, const GainField& field, std::size_t k,
                      const std::string&) {
                    placed.push_back({&value, name_of(field, k, joints), numbers(gains, field)[k]});
                  });
  return placed;
}

}  // namespace armtune::internal
