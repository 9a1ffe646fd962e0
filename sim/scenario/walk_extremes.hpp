#pragma once
// Collects the worst values of a walk, in which an arm follows a task by inverse kinematics (path_walk.hpp).
// They show where the arm comes closest to singularities, joint limits, the floor and itself, and where
// holding it still takes the most torque.

#include <limits>
#include <optional>
#include <vector>

#include "core/control/measured_arm.hpp"
#include "sim/cell/clearance_watch.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// A value of a walk, with the time and the point of the path at which it occurred.
struct WalkPlace {
  double time = 0.0;         ///< [s]
  Vec3 tool = Vec3::Zero();  ///< position on the path, base frame [m]
  double value = 0.0;
};

/// The extremes of one walk.
struct PathWalk {
  /// The initial value of a minimum.
  static constexpr double kUnseen = std::numeric_limits<double>::infinity();

  WalkPlace left;   ///< first place where the tool is more than 1 mm off the path; value 0: there is none
  WalkPlace error;  ///< largest distance of the tool from the path [m]
  WalkPlace manipulability{0.0, Vec3::Zero(), kUnseen};  ///< smallest, for the task (NOTATION.md, equation 4)
  WalkPlace margin{0.0, Vec3::Zero(),
                   kUnseen};  ///< smallest distance to a joint limit, as a share of the joint's range
  WalkPlace sight{0.0, Vec3::Zero(),
                  kUnseen};  ///< smallest distance of the active target from the path point [m]
  WalkPlace low{0.0, Vec3::Zero(),
                kUnseen};  ///< smallest height of the tool and of the third and later joints [m]
  WalkPlace fold{0.0, Vec3::Zero(),
                 kUnseen};  ///< smallest distance of the tool from lines joining the first n - 2 joints [m]
  /// Smallest distances of the arm from itself and its cell; infinite in a scenario without a cell.
  LeastClearances nearest;
  std::vector<LeastClearance> too_near;  ///< pairs nearer than required, each at its smallest distance
  WalkPlace load;  ///< largest holding torque of a joint, as a fraction of its effort limit
  double largest_manipulability = 0.0;
  int joint = 0;       ///< index of the joint with the smallest margin
  int loaded = 0;      ///< index of the joint with the largest load
  long steps = 0;      ///< number of steps of the walk
  double ended = 0.0;  ///< time at which the walk ended [s]
};

/// Returns the height of a point above the origin of the base frame, measured opposite to gravity [m]. point:
/// in the base frame [m].
double height_of(const Vec3& point, const RobotModel& robot);

/// Replaces `found` by `place` if the value of `place` is smaller, or if either value is NaN.
void take_smaller(const WalkPlace& place, WalkPlace& found);

/// Updates the extremes of a walk in each of its steps.
class WalkExtremes {
 public:
  /// off_path: distance from the path [m] above which the tool counts as off it. required: distances of
  /// scenario.clearance's pairs below which they are too near [m]; empty: none. The scenario's robot must
  /// outlive this object.
  WalkExtremes(const Scenario& scenario, double off_path, const std::vector<double>& required);

  /// Updates `walk` with one step. arm: kinematics at joint positions q (n), reached at `time` [s]. tool:
  /// desired position on the path at that time [m].
  void see(double time, const Vec3& tool, const MeasuredArm& arm, const JointVector& q, PathWalk& walk);

  /// Adds to `walk` what is known at its end: the pairs that came too near.
  void finish(PathWalk& walk) const;

 private:
  const RobotModel& robot_;
  double off_path_;
  std::optional<ClearanceWatch> cell_;
  Chain loaded_;
  JointVector efforts_;
  JointVector gravity_;
};

}  // namespace armtune::internal
