#pragma once
// Holds the points of a joint motion that was read from a user's file. The values of each point are in the
// order of the arm's joints.

#include <string>
#include <vector>

#include "core/common/input_place.hpp"
#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/ros_segments.hpp"

namespace armtune::internal {

struct MotionPoints {
  std::vector<double> time;                      ///< increasing, the first one is not negative [s]; empty:
                                                 ///< the file gives joint goals, but no times
  std::vector<MotionPoint<JointVector>> points;  ///< n joints each [rad or m, and per s, per s^2]
  PointsGive given = PointsGive::kPositions;     ///< quantities in the file; all others are zero
  std::string file;                              ///< name of the file in messages
  std::vector<std::size_t> lines;                ///< line of each point in the file

  /// Returns the place of a value of a point in the file. key: name of the value.
  InputPlace where(std::size_t point, std::string key) const {
    return at_line(file, lines[point], std::move(key));
  }
};

}  // namespace armtune::internal
