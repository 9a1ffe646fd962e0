#pragma once
// Describes the robot cell, that is, the surroundings of the arm: a floor and convex parts, which rest or
// move without rotating. Simulations check that the arm does not touch them.

#include <optional>
#include <string>
#include <vector>

#include "core/trajectory/path.hpp"
#include "sim/cell/solid.hpp"

namespace armtune::internal {

struct CellPart {
  std::string name;
  Solid solid;
  Mat3 R_0S = Mat3::Identity();
  Path path;                 ///< motion of the origin of the solid's frame, base frame
  bool is_obstacle = false;  ///< true for an obstacle, which scenario files list outside the key `cell`
};

struct Cell {
  std::optional<double> floor;  ///< height above the base frame's origin, measured opposite to gravity [m]
  std::vector<CellPart> parts;
};

}  // namespace armtune::internal
