#pragma once
// Represents the links and the tool of an arm by convex shapes, called solids. Distances between solids show
// whether the arm touches itself or its surroundings. Links that are fixed to each other form one rigid body,
// which has the index of the joint that moves it.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/cell/closest.hpp"

namespace armtune::internal {

struct ArmSolid {
  int body = -1;     ///< index of its rigid body; -1: the base
  std::string link;  ///< name of its link, or "tool"
  PlacedSolid placed;
  bool drawn = false;  ///< true: visual geometry, because its link has no collision geometry
};

struct ArmSolids {
  std::vector<ArmSolid> solids;
  /// Links with an unreadable shape, and one link of every rigid body without any shape.
  std::vector<std::string> unknown;
  std::vector<std::string> meshes;  ///< mesh files from which shapes were read, without duplicates
  std::vector<std::string> unread;  ///< unreadable shapes, with the reason: "NAME: no such file ..."
};

/// Returns the solids of the arm, one for each shape. The shapes of a link are its collision geometry, or its
/// visual geometry if it has none. A mesh is replaced by its convex hull. It must be an STL or OBJ file
/// (mesh_file.hpp) that mesh_path() finds. If the origin of the tool frame lies outside the shapes of the
/// last rigid body, a thin rod connects this origin to the nearest of these shapes. The rod is named "tool"
/// and has a radius of 1 mm.
ArmSolids arm_solids(const RobotModel& robot);

/// Returns the links whose solids are visual geometry, without duplicates. A drawn shape may be smaller than
/// the link.
std::vector<std::string> drawn_links(const ArmSolids& arm);

}  // namespace armtune::internal
