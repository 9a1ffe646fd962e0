#include "core/robot/urdf_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"

namespace armtune::internal {
namespace {

template <typename Map>
std::vector<std::string> names_of(const Map& map) {
  std::vector<std::string> names;
  names.reserve(map.size());
  for (const auto& [name, value] : map) names.push_back(name);
  return names;
}

/// key: the key of a robot YAML that names the link, such as `tip_link` or `inertia/forearm`.
void require_link(const UrdfTree& tree, const std::string& name, const std::string& key, const char* what,
                  const std::string& source) {
  if (tree.links.contains(name)) return;
  throw InputError(InputPlace{source, 0, key}, fmt::format("{} '{}': there is no such link{}", what, name,
                                                           suggestion(name, names_of(tree.links))))
      .with_value(name, "the name of a link");
}

void require_joint(const UrdfTree& tree, const std::string& name, const char* what,
                   const std::string& source) {
  if (tree.joints.contains(name)) return;
  throw InputError(
      InputPlace{source, 0, fmt::format("{}/{}", what, name)},
      fmt::format("{}: there is no joint '{}'{}", what, name, suggestion(name, names_of(tree.joints))))
      .with_value(name, "the name of a joint");
}

void check_held(const UrdfJoint& joint, double value, const UrdfOptions& options, const std::string& source) {
  const InputPlace place{source, 0, "hold/" + joint.name};
  if (joint.motion == UrdfMotion::kFixed || joint.motion == UrdfMotion::kOther) {
    throw InputError(place,
                     fmt::format("hold: joint '{}' is fixed, floating or planar; leave it out", joint.name))
        .with_value(joint.name, "a revolute, continuous or prismatic joint");
  }
  const auto [lower, upper] = position_range(joint, options).value_or(std::pair(-HUGE_VAL, HUGE_VAL));
  if (std::isfinite(value) && value >= lower && value <= upper) return;
  throw InputError(place,
                   fmt::format("hold: joint '{}' at {} {} is outside its limits {} .. {}", joint.name, value,
                               joint.motion == UrdfMotion::kPrismatic ? "m" : "rad", lower, upper))
      .with_value(fmt::to_string(value), fmt::format("{} to {}", lower, upper));
}

bool moves(const UrdfJoint& joint, const UrdfOptions& options) {
  return joint.motion != UrdfMotion::kFixed && !options.held.contains(joint.name);
}

/// Returns true if some link has more than one child joint that moves or leads to a moving joint.
bool branches(const UrdfTree& tree, const UrdfOptions& options) {
  std::map<std::string, const UrdfJoint*> to;  // by link: the joint that leads to it
  for (const auto& [name, joint] : tree.joints) to.emplace(joint.child, &joint);
  std::set<std::string> leading;       // joints that move or lead to a moving joint
  std::map<std::string, int> ways_on;  // by link: the number of its child joints in `leading`
  for (const auto& [name, moving] : tree.joints) {
    if (!moves(moving, options)) continue;
    for (const UrdfJoint* joint = &moving; joint != nullptr && leading.insert(joint->name).second;) {
      if (++ways_on[joint->parent] > 1) return true;
      const auto before = to.find(joint->parent);
      joint = before == to.end() ? nullptr : before->second;
    }
  }
  return false;
}

/// Finds the joints from the base to the tip. Returns false if no chain leads from the base to the tip.
bool find_way(const UrdfTree& tree, const std::string& base, const std::string& tip,
              std::set<std::string>& way) {
  std::map<std::string, const UrdfJoint*> to;  // by link: the joint that leads to it
  for (const auto& [name, joint] : tree.joints) to.emplace(joint.child, &joint);
  way.clear();
  for (std::string link = tip; link != base;) {
    const auto joint = to.find(link);
    if (joint == to.end()) return false;
    way.insert(joint->second->name);
    link = joint->second->parent;
  }
  return true;
}

}  // namespace

std::optional<std::pair<double, double>> position_range(const UrdfJoint& joint, const UrdfOptions& options) {
  const auto found = options.limits.find(joint.name);
  const GivenLimits given = found == options.limits.end() ? GivenLimits{} : found->second;
  const bool said = joint.limits && joint.motion != UrdfMotion::kContinuous;
  if (!said && !(given.lower && given.upper)) return {};
  const UrdfJoint::Limits file = joint.limits.value_or(UrdfJoint::Limits{});
  const std::pair range(given.lower.value_or(file.lower), given.upper.value_or(file.upper));
  // urdfdom returns two zeros for a limit element without lower and upper.
  if (range.first == range.second) return {};
  return range;
}

UrdfSelection select_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source) {
  for (const auto& [joint, value] : options.held) {
    require_joint(tree, joint, "hold", source);
    check_held(tree.joints.at(joint), value, options, source);
  }
  for (const auto& [joint, limits] : options.limits) require_joint(tree, joint, "limits", source);
  for (const auto& [link, inertia] : options.inertia) {
    require_link(tree, link, "inertia/" + link, "inertia of link", source);
  }
  if (!options.base_link.empty()) require_link(tree, options.base_link, "base_link", "base_link", source);

  UrdfSelection selection;
  selection.base = options.base_link.empty() ? tree.root : options.base_link;
  const bool asked = !options.tip_link.empty();
  const std::string tip = asked ? options.tip_link : "tool0";
  // A missing tip link is normally reported by the arm's builder, which knows the links that can carry the
  // tool. In a branching tree it is reported here, because the builder would first ask which arm is meant.
  if (asked && !tree.links.contains(tip) && branches(tree, options))
    require_link(tree, tip, "tip_link", "tip_link", source);
  if (!tree.links.contains(tip)) return selection;
  const bool behind = find_way(tree, selection.base, tip, selection.on_the_way);
  if (asked && !behind) {
    throw InputError(
        InputPlace{source, 0, "tip_link"},
        fmt::format("no chain of joints leads from base_link '{}' to tip_link '{}'; choose two links on "
                    "the same chain, the tip_link after the base_link",
                    selection.base, tip))
        .with_value(tip, fmt::format("a link on a chain from '{}'", selection.base));
  }
  selection.has_tip =
      behind && std::any_of(selection.on_the_way.begin(), selection.on_the_way.end(),
                            [&](const std::string& joint) { return moves(tree.joints.at(joint), options); });
  return selection;
}

}  // namespace armtune::internal
