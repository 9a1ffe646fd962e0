#pragma once
// Selects the joints of a URDF that belong to the arm: those on the chain from its base link to its tip link.
// Other joints on its moving links must be held at a fixed position by request; urdf_arm.hpp refuses them
// otherwise. Joints on links that the arm does not move are ignored.

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
/// No value if there are none, or if they are equal: urdfdom leaves zeros if the file gives velocity and
/// effort only.
std::optional<std::pair<double, double>> position_range(const UrdfJoint& joint, const UrdfOptions& options);

/// Selects the joints of the arm. `tree` must pass require_tree. Throws InputError, beginning with `source`,
/// for a link, joint or value that the tree does not have; the message suggests the nearest name.
UrdfSelection select_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source);

}  // namespace armtune::internal
