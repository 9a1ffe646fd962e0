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
  std::vector<std::string> unknown;  ///< links with a shape that could not be read, and bodies without any
  std::vector<std::string> meshes;   ///< files that shapes were read from, each once
  std::vector<std::string> unread;   ///< shapes that could not be read, with why: "NAME: no such file ..."
};

/// Returns the solids of the arm, one for each shape. The shapes of a link are its collision geometry, or its
/// visual geometry if it has none. Meshes become their convex hulls; they must be binary STL files that
/// mesh_path() finds. If the tool frame lies off the last body's shapes, a thin rod named "tool", of 1 mm
/// radius, connects them to its origin.
ArmSolids arm_solids(const RobotModel& robot);

}  // namespace armtune::internal
