#pragma once
// Selects the joints of a URDF that belong to the arm: those on the chain from its base link to its tip link.
// Any other joint on the arm's moving links must be held at a fixed position by UrdfOptions::held. If it is
// not, urdf_arm.hpp refuses the file. Joints on links that the arm does not move are ignored.

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

struct UrdfSelection {
  std::string base;  ///< name of the base link
  /// Names of the joints from base to tip, if has_tip. Otherwise every joint after the base is part of the
  /// arm.
  std::set<std::string> on_the_way;
  bool has_tip = false;  ///< true if a moving joint lies between the base and a known tip
};

/// Returns a joint's lower and upper position limit [rad, m]; those of the options replace those of the file.
/// Returns no value if there are no limits, or if both are equal. Both are zero if the file gives only
/// velocity and effort limits, because urdfdom then sets them so.
std::optional<std::pair<double, double>> position_range(const UrdfJoint& joint, const UrdfOptions& options);

/// Selects the joints of the arm. `tree` must pass require_tree. Throws InputError, with a message that
/// begins with `source`, if the options name a link or joint that the tree does not have, hold a joint
/// outside its limits, or name a base and a tip without a chain from one to the other. For an unknown name,
/// the message suggests the nearest known one.
UrdfSelection select_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source);

}  // namespace armtune::internal
