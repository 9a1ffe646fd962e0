#pragma once
// The surroundings of the arm: a floor and convex parts, which rest or move without turning.

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
  Path path;                 ///< of the origin of the solid's frame, base frame
  bool is_obstacle = false;  ///< one of the scenario's obstacles, which are listed apart in scenario files
};

struct Cell {
  std::optional<double> floor;  ///< height above the base frame's origin, against gravity [m]
  std::vector<CellPart> parts;
};

}  // namespace armtune::internal
