#include "sim/controller_files/gain_map.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
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

constexpr std::size_t kDigits = 6;    // of an index
constexpr double kSlowest = 10.0;     // Hz
constexpr double kFastest = 10000.0;  // Hz
constexpr double kLeastFactor = 1e-9;
constexpr double kMostFactor = 1e9;

/// Throws InputError about the map. key: the place or the gain that is wrong. value, limit: see InputError.
[[noreturn]] void fail(const RosController& controller, const std::string& key, const std::string& what,
                       const std::string& value = {}, const std::string& limit = {}) {
  throw InputError(InputPlace{controller.map_file, 0, key}, what).with_value(value, limit);
}

/// Returns the value of a list or a map whose index or key is the beginning of `path`, and removes this
/// beginning from `path`. Returns null if there is none. A key may itself contain '/'; throws InputError if
/// two keys fit.
const PlacedValue* next_value(const PlacedValue& from, std::string_view& path,
                              const RosController& controller) {
  const PlacedValue* found = nullptr;
  std::string_view used;
  const auto fits = [&path](std::string_view key) {
    return path.starts_with(key) && (path.size() == key.size() || path[key.size()] == '/');
  };
  for (const yaml::PlacedEntry& entry : from.entries) {
    if (!fits(entry.key)) continue;
    if (found != nullptr)
      fail(
          controller, std::string(path),
          fmt::format("the entry '{2}' of the map matches two keys of the file, '{0}' and '{1}', but it must "
                      "match one; rename one of them in the file",
                      used, entry.key, path),
          fmt::format("{}, {}", used, entry.key), "one key");
    found = entry.value.get();
    used = entry.key;
  }
  const std::string index(path.substr(0, path.find('/')));
  for (std::size_t k = 0; k < from.items.size() && found == nullptr && index.size() < kDigits; ++k) {
    if (index != fmt::to_string(k)) continue;
    found = from.items[k].value.get();
    used = index;
  }
  // A '/' at the end remains, and fits no key.
  if (found != nullptr) path.remove_prefix(used.size() + (path.size() > used.size() + 1 ? 1 : 0));
  return found;
}

/// Returns the value at a path, or null if there is none.
const PlacedValue* value_at(const RosController& controller, std::string_view path) {
  const PlacedValue* value = controller.all.get();
  do {
    value = next_value(*value, path, controller);
  } while (value != nullptr && !path.empty());
  return value;
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
                 const RosController& controller) {
  const auto slash = gain.find('/');
  const std::string name = gain.substr(0, slash);
  for (const GainField& field : fields_of(gains)) {
    if (name != field.name || !std::holds_alternative<OwnGain>(field.member)) continue;
    const std::vector<std::string> parts = component_names(field, joints);
    if (slash == std::string::npos) return {&field, 0, parts.size()};
    const std::string part = gain.substr(slash + 1);
    const auto found = std::find(parts.begin(), parts.end(), part);
    if (found == parts.end() || parts.size() == 1)
      fail(controller, gain,
           fmt::format("gain '{}': {} has no '{}'{}", gain, name, part,
                       parts.size() == 1 ? std::string() : suggestion(part, parts)),
           part, parts.size() == 1 ? std::string() : fmt::format("one of: {}", fmt::join(parts, ", ")));
    return {&field, static_cast<std::size_t>(found - parts.begin()), 1};
  }
  const std::vector<std::string> names = own_names(gains);
  fail(controller, gain,
       fmt::format("controller '{}' has no such gain of its own: '{}'{}; it has: {}", gains.controller, gain,
                   suggestion(name, names), fmt::join(names, ", ")),
       gain, fmt::format("one of: {}", fmt::join(names, ", ")));
}

/// Calls `see` with every number of the file that the map names: its gain, place, name and index in the gain.
template <typename See>
void for_each_number(const RosController& controller, const std::string& file, const Gains& gains,
                     const std::vector<std::string>& joints, const See& see) {
  const ParameterReader reader(controller, file);
  for (const GainPlace& place : controller.places) {
    const Target target = target_of(gains, place.gain, joints, controller);
    const PlacedValue* value = value_at(controller, place.path);
    if (value == nullptr)
      fail(controller, place.path, fmt::format("there is nothing at '{}' in {}", place.path, file),
           place.path);
    const bool is_list = value->kind == PlacedValue::Kind::kSequence;
    const std::size_t count = is_list ? value->items.size() : 1;
    if (count != target.count)
      reader.fail(
          value->line,
          fmt::format("'{}' has {} number{}, but {} has {}; bind a list of the same length, or each number "
                      "of the gain alone, such as '{}/{}'",
                      place.path, count, count == 1 ? "" : "s", place.gain, target.count, target.field->name,
                      component_names(*target.field, joints).front()),
          fmt::to_string(count), fmt::to_string(target.count));
    for (std::size_t k = 0; k < count; ++k)
      see(reader, is_list ? *value->items[k].value : *value, *target.field, target.first + k, place);
  }
}

/// Returns the names of the gains that are bound to one place: one, or several.
std::vector<std::string> gains_of(const yaml::Node& node) {
  if (node.kind() != yaml::Node::Kind::kSequence) return {node.as_string()};
  if (node.items().empty()) node.fail("the list names no gain; name at least one", "at least one gain");
  return node.as_strings();
}

/// Reads an entry of `map`.
void add_places(const std::string& path, const yaml::Node& node, std::vector<GainPlace>& places) {
  double factor = 1.0;
  std::vector<std::string> gains;
  if (node.kind() == yaml::Node::Kind::kMap) {
    yaml::MapReader map(node);
    gains = gains_of(map.required("gain"));
    factor = map.number_in("factor", 1.0, kLeastFactor, kMostFactor);
    map.finish();
  } else {
    gains = gains_of(node);
  }
  for (std::string& gain : gains) places.push_back({path, std::move(gain), factor});
}

GainName name_of(const GainField& field, std::size_t k, const std::vector<std::string>& joints) {
  const std::vector<std::string> parts = component_names(field, joints);
  return {std::string(field.name), parts.size() == 1 ? "" : parts[k]};
}

}  // namespace

bool is_gain_map(const std::string& text, const std::string& path) {
  if (!may_hold_map(text)) return false;
  const yaml::Placed root = yaml::read_placed(text, path);
  const auto has = [&root](const char* key, PlacedValue::Kind kind) {
    const PlacedValue* value = root->find(key);
    return value != nullptr && value->kind == kind;
  };
  return has("controller", PlacedValue::Kind::kScalar) && has("file", PlacedValue::Kind::kScalar) &&
         has("map", PlacedValue::Kind::kMap);
}

GainMap gain_map(const std::string& text, const std::string& path) {
  const yaml::Node root = yaml::parse_text(text, path);
  yaml::MapReader map(root);
  GainMap read;
  RosController& controller = read.controller;
  controller.layout = GainLayout::kMapped;
  controller.name = std::filesystem::path(path).filename().string();
  controller.map_file = path;
  const yaml::Node& kind = map.required("controller");
  controller.kind = kind.as_string();
  const std::vector<std::string> kinds = motion_controllers();
  if (std::find(kinds.begin(), kinds.end(), controller.kind) == kinds.end())
    kind.fail(fmt::format("'{}' is not a controller that a map can name{}; these are: {}", controller.kind,
                          suggestion(controller.kind, kinds), fmt::join(kinds, ", ")));
  const yaml::Node& named = map.required("file");
  const std::filesystem::path file = named.as_string();
  if (file.empty()) named.fail("the name of the file is empty");
  read.file = (std::filesystem::path(path).parent_path() / file).string();
  controller.ros2 = !map.boolean("ros1", false);
  const yaml::Node& places = map.required("map");
  if (places.kind() != yaml::Node::Kind::kMap || places.entries().empty())
    places.fail("expected at least one line 'PLACE: GAIN'");
  for (const auto& [place, gain] : places.entries()) add_places(place, gain, controller.places);
  if (map.has("rate")) controller.rate = map.number_in("rate", kSlowest, kSlowest, kFastest);
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
      fail(controller, name,
           fmt::format("{} has {} numbers here, but the gain has {}", name, values.size(), own_values.size()),
           fmt::to_string(values.size()), fmt::format("1 or {}", own_values.size()));
    for (Eigen::Index k = 0; k < own_values.size(); ++k)
      own_values[k] = values.size() == 1 ? values[0] : values[static_cast<std::size_t>(k)];
  }
  std::set<std::pair<std::string, std::size_t>> given;
  for_each_number(controller, file, gains, joints,
                  [&](const ParameterReader& reader, const PlacedValue& value, const GainField& field,
                      std::size_t k, const GainPlace& place) {
                    if (!given.emplace(field.name, k).second)
                      reader.fail(value.line,
                                  fmt::format("the map gives {} twice, the second time at '{}'",
                                              words(name_of(field, k, joints)), place.path),
                                  place.path, "one place for each number");
                    numbers(gains, field)[k] =
                        place.factor * reader.finite(value, fmt::format("'{}'", place.path));
                  });
  for (const GainField& field : fields_of(gains)) {
    if (!std::holds_alternative<OwnGain>(field.member)) continue;
    const auto& others = controller.others;
    const bool has_value = std::any_of(others.begin(), others.end(),
                                       [&field](const auto& other) { return other.first == field.name; });
    std::vector<std::string> without;
    for (std::size_t k = 0; k < numbers(gains, field).size(); ++k) {
      if (!given.contains({field.name, k})) without.push_back(words(name_of(field, k, joints)));
    }
    if (has_value && without.empty())
      fail(controller, field.name,
           fmt::format("{} is bound to the file and has a value here as well; remove one of the two",
                       field.name));
    if (!has_value && !without.empty() &&
        (field.search != SearchRange::kNone || without.size() < numbers(gains, field).size()))
      fail(controller, field.name,
           fmt::format("there is no value for {}; bind it to a number of the file, or give '{}: VALUE' here",
                       fmt::join(without, ", "), field.name),
           "", fmt::format("{}", fmt::join(without, ", ")));
  }
  return gains;
}

std::vector<PlacedGain> placed_mapped_gains(const RosController& controller, const std::string& file,
                                            const Gains& gains, const std::vector<std::string>& joints) {
  std::vector<PlacedGain> placed;
  const GainPlace* last = nullptr;  // gains of one place follow each other
  bool same_place = false;
  for_each_number(controller, file, gains, joints,
                  [&](const ParameterReader&, const PlacedValue& value, const GainField& field, std::size_t k,
                      const GainPlace& place) {
                    if (last != &place) same_place = last != nullptr && last->path == place.path;
                    last = &place;
                    const GainName name = name_of(field, k, joints);
                    placed.push_back({&value, name, numbers(gains, field)[k] / place.factor,
                                      name.part.empty() ? name.gain : name.gain + "/" + name.part,
                                      place.factor, same_place});
                  });
  return placed;
}

}  // namespace armtune::internal
