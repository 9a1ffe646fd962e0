#pragma once
// What is found on a walk along a task: where it comes closest to singularities, joint limits, the floor, the
// arm itself, and what holding the arm still takes.

#include <limits>
#include <optional>

#include "core/control/measured_arm.hpp"
#include "sim/cell/clearance_watch.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// A moment of a walk.
struct WalkPlace {
  double time = 0.0;         ///< [s]
  Vec3 tool = Vec3::Zero();  ///< of the path, base frame [m]
  double value = 0.0;
};

struct PathWalk {
  /// The value of a smallest one before any was seen.
  static constexpr double kUnseen = std::numeric_limits<double>::infinity();

  WalkPlace left;   ///< first time off the path by more than a millimetre; value 0: never
  WalkPlace error;  ///< largest distance of the tool from the path [m]
  WalkPlace manipulability{0.0, Vec3::Zero(), kUnseen};  ///< smallest, of the task's components (equation 4)
  WalkPlace margin{0.0, Vec3::Zero(),
                   kUnseen};  ///< smallest share of a joint's range that is left to its limit
  WalkPlace sight{0.0, Vec3::Zero(),
                  kUnseen};  ///< smallest distance from the path to the target looked at [m]
  WalkPlace low{0.0, Vec3::Zero(),
                kUnseen};  ///< least height of the tool and of the third and later joints [m]
  WalkPlace fold{0.0, Vec3::Zero(),
                 kUnseen};  ///< least distance of the tool from the arm's first n - 2 joints [m]
  /// Smallest distances of the arm from itself and its cell; infinite in a scenario without a cell.
  LeastClearances nearest;
  WalkPlace load;  ///< largest share of a joint's effort limit that holding the arm still takes
  double largest_manipulability = 0.0;
  int joint = 0;       ///< whose margin it is
  int loaded = 0;      ///< joint whose load it is
  long steps = 0;      ///< that were gone
  double ended = 0.0;  ///< [s]
};

/// Height of a point of the base frame above that frame's origin, against gravity [m].
double height_of(const Vec3& point, const RobotModel& robot);

/// Keeps `found` the smaller of both values. A value that is not a number is kept.
void take_smaller(const WalkPlace& place, WalkPlace& found);

/// Finds the extremes of a walk, place by place.
class WalkExtremes {
 public:
  /// Distances from the path that are larger than `off_path` [m] count as off it. The robot outlives it.
  WalkExtremes(const Scenario& scenario, double off_path);

  /// arm: measured at joint positions q (n) at `time` [s]; tool: where the path has it then [m].
  void see(double time, const Vec3& tool, const MeasuredArm& arm, const JointVector& q, PathWalk& walk);

 private:
  const RobotModel& robot_;
  double off_path_;
  std::optional<ClearanceWatch> cell_;
  Chain loaded_;
  JointVector efforts_;
  JointVector gravity_;
};

}  // namespace armtune::internal
