#pragma once
// Which joints of a URDF's tree move the arm: those on the way from its base link to its tip link. Others are
// held by request, or hang on what the arm stands on and do not matter to it.

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

struct UrdfSelection {
  std::string base;  ///< link
  /// Names of the joints from base to tip; empty without a tip: every joint behind the base is the arm's.
  std::set<std::string> on_the_way;
  bool has_tip = false;
};

/// A joint's lower and upper position limit [rad, m], of the options in place of the file's. None: it has
/// none, or they are equal, as urdfdom leaves them where the file gives velocity and effort alone.
std::optional<std::pair<double, double>> position_range(const UrdfJoint& joint, const UrdfOptions& options);

/// The tree must be one: every link reached from the root by one way. Throws InputError, beginning with
/// `source`, for a link, joint or value that the tree does not have; with the nearest name it has.
UrdfSelection select_arm(const UrdfTree& tree, const UrdfOptions& options, const std::string& source);

}  // namespace armtune::internal
