#include "sim/controller_files/ros_controllers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "core/common/message_text.hpp"
#include "sim/controller_files/ros_nodes.hpp"

namespace armtune::internal {
namespace {

using yaml::PlacedValue;

constexpr const char* kRos2Parameters = "ros__parameters";
constexpr std::string_view kDottedType = ".type";

bool is_map(const PlacedValue* value) {
  return value != nullptr && value->kind == PlacedValue::Kind::kMap;
}

bool has_gains(const PlacedValue& map) {
  const PlacedValue* gains = map.find("gains");
  if (!is_map(gains) || gains->entries.empty()) return false;
  return std::any_of(gains->entries.begin(), gains->entries.end(), [](const yaml::PlacedEntry& joint) {
    const PlacedValue& own = *joint.value;
    return is_map(&own) && (own.find("p") != nullptr || own.find("i") != nullptr || own.find("d") != nullptr);
  });
}

bool has_impedance(const PlacedValue& map) {
  const auto is_list = [&map](const char* key) {
    const PlacedValue* list = map.find(key);
    return list != nullptr && list->kind == PlacedValue::Kind::kSequence;
  };
  return is_list("k_gains") && is_list("d_gains");
}

/// True for a joint trajectory controller, with or without gains.
bool is_trajectory_controller(const PlacedValue& map, const std::string& type) {
  if (!type.empty()) return type.ends_with("JointTrajectoryController");
  return map.find("joints") != nullptr && map.find("command_interfaces") != nullptr;
}

/// Calls `see` for every map, with the keys above it.
void walk(const yaml::Placed& value, std::vector<std::string>& keys,
          const std::function<void(const yaml::Placed&, const std::vector<std::string>&)>& see) {
  if (value->kind != PlacedValue::Kind::kMap) return;
  see(value, keys);
  for (const yaml::PlacedEntry& entry : value->entries) {
    if (entry.alias) continue;  // visited at the place where it is written
    keys.push_back(entry.key);
    walk(entry.value, keys, see);
    keys.pop_back();
  }
}

std::string scalar_at(const PlacedValue& map, const char* key) {
  const PlacedValue* value = map.find(key);
  return value != nullptr && value->kind == PlacedValue::Kind::kScalar ? value->text : std::string();
}

/// Adds to each controller the names of the others of its file. types: names and types, as the controller
/// manager lists them.
void add_neighbours(std::vector<RosController>& all,
                    const std::vector<std::pair<std::string, std::string>>& types) {
  std::vector<std::string> names;
  for (const RosController& controller : all) names.push_back(controller.name);
  for (const auto& [name, type] : types) {
    if (type.find('/') == std::string::npos) continue;  // not the class of a plugin
    const bool known = std::any_of(names.begin(), names.end(), [&name = name](const std::string& other) {
      return other.substr(other.find_last_of('/') + 1) == name;
    });
    if (!known) names.push_back(one_line(name));
  }
  for (RosController& controller : all) {
    controller.neighbours = names;
    std::erase(controller.neighbours, controller.name);
  }
}

bool has_numbers(const PlacedValue& map) {
  return has_gains(map) || has_impedance(map);
}

RosController controller_of(std::string name, const yaml::Placed& parameters, bool ros2) {
  RosController controller;
  controller.layout = has_impedance(*parameters) ? GainLayout::kImpedance : GainLayout::kPidByJoint;
  controller.ros2 = ros2;
  controller.name = std::move(name);
  controller.type = scalar_at(*parameters, "type");
  controller.parameters = parameters;
  return controller;
}

/// Returns the controllers with gains, and the joint trajectory controllers without.
std::vector<RosController> controllers_of_file(const yaml::Placed& root, const std::string& file) {
  std::vector<RosController> found;
  for (const RosNode& node : ros2_nodes(*root, file))
    found.push_back(controller_of(node.name, node.parameters, true));
  std::vector<std::pair<std::string, std::string>> types;  // (name, type), as in the controller manager
  std::vector<std::string> keys;
  walk(root, keys, [&](const yaml::Placed& map, const std::vector<std::string>& above) {
    const std::string type = scalar_at(*map, "type");
    if (!type.empty() && !above.empty()) types.emplace_back(above.back(), type);
    if (!above.empty() && above.back() == kRos2Parameters) {
      for (const yaml::PlacedEntry& entry : map->entries) {
        if (entry.key.ends_with(kDottedType))
          types.emplace_back(entry.key.substr(0, entry.key.size() - kDottedType.size()), entry.value->text);
      }
      return;
    }
    const bool in_ros2 = std::find(above.begin(), above.end(), kRos2Parameters) != above.end();
    if (!has_numbers(*map) && (in_ros2 || !is_trajectory_controller(*map, type))) return;
    std::vector<std::string> name = above;
    std::erase(name, kRos2Parameters);
    found.push_back(controller_of(one_line(fmt::format("{}", fmt::join(name, "/"))), map, false));
  });
  for (RosController& controller : found) {
    controller.all = root;
    const std::string last = controller.name.substr(controller.name.find_last_of('/') + 1);
    for (const auto& [name, type] : types) {
      if (controller.type.empty() && name == last) controller.type = type;
    }
  }
  add_neighbours(found, types);
  return found;
}

/// Returns true if the text goes on at `after` like behind a key: with ':', or with ".REST:".
bool ends_key(std::string_view text, std::size_t after) {
  if (after < text.size() && text[after] == '.')
    after = std::min(text.find_first_of(":,#}\n", after), text.size());
  return after < text.size() && text[after] == ':';
}

/// Returns true if the text has a key of this name, or with this name before a dot, outside of comments.
bool has_key(std::string_view text, std::string_view key) {
  constexpr std::string_view kQuotes = "'\"";
  for (auto at = text.find(key); at != std::string_view::npos; at = text.find(key, at + 1)) {
    auto before = at, after = at + key.size();
    if (before > 0 && kQuotes.find(text[before - 1]) != std::string_view::npos) --before;
    if (after < text.size() && kQuotes.find(text[after]) != std::string_view::npos) ++after;
    const std::string_view line =
        text.substr(0, before).substr(text.substr(0, before).find_last_of('\n') + 1);
    const bool commented = line.find('#') != std::string_view::npos;
    const bool begins = line.empty() || std::string_view(" \t{,").find(line.back()) != std::string_view::npos;
    after = std::min(text.find_first_not_of(" \t", after), text.size());
    if (begins && !commented && ends_key(text, after)) return true;
  }
  return false;
}

}  // namespace

bool may_hold_controllers(std::string_view text) {
  return has_key(text, "gains") || has_key(text, "k_gains");
}

bool may_hold_map(std::string_view text) {
  return has_key(text, "controller") && has_key(text, "file") && has_key(text, "map");
}

std::vector<RosController> ros_controllers(const std::string& text, const std::string& file) {
  std::vector<RosController> all = controllers_of_file(yaml::read_placed(text, file), file);
  std::erase_if(all, [](const RosController& controller) { return !has_numbers(*controller.parameters); });
  return all;
}

std::vector<RosController> controllers_without_gains(const yaml::Placed& root, const std::string& file) {
  std::vector<RosController> all = controllers_of_file(root, file);
  std::erase_if(all, [](const RosController& controller) {
    return has_numbers(*controller.parameters) ||
           !is_trajectory_controller(*controller.parameters, controller.type);
  });
  return all;
}

}  // namespace armtune::internal
