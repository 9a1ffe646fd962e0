#pragma once
// Represents the links and the tool of an arm by convex bodies, called solids here. Distances between these
// bodies show whether the arm touches itself or its surroundings.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/cell/closest.hpp"

namespace armtune::internal {

struct ArmSolid {
  int body = -1;     ///< index of the joint that moves it; -1: the base
  std::string link;  ///< name of its link, or "tool"
  PlacedSolid placed;
};

struct ArmSolids {
  std::vector<ArmSolid> solids;
  std::vector<std::string> unknown;  ///< links with an unreadable shape, and links of bodies without a shape
  std::vector<std::string> meshes;   ///< mesh files from which shapes were read, without duplicates
  std::vector<std::string> unread;   ///< unreadable shapes, with the reason: "NAME: no such file ..."
};

/// Returns the solids of the arm, one for each shape. The shapes of a link are its collision geometry, or its
/// visual geometry if it has none. Meshes become their convex hulls; they must be binary STL files that
/// mesh_path() finds. If the origin of the tool frame lies outside the shapes of the last body, a thin rod
/// connects this origin to the nearest shape. The rod is named "tool" and has a radius of 1 mm.
ArmSolids arm_solids(const RobotModel& robot);

}  // namespace armtune::internal
