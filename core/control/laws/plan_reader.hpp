#pragma once
// Reads the planned joint motion of each control period for the law of one arm.

#include "core/control/control_output.hpp"
#include "core/control/gains.hpp"
#include "core/control/laws/planned_joints.hpp"

namespace armtune::internal {

class PlanReader {
 public:
  /// n: number of joints; period: control period [s]. The gains determine the velocity for the feed-forward:
  /// that of this period or, for some controllers, that of the next period (feeds_next_velocity).
  PlanReader(int n, const Gains& gains, double period);

  /// Returns the planned motion of the control period that begins at `time` [s]. It is not active in states
  /// other than followPlan. The result is valid until the next call. Allocates nothing.
  const PlannedJoints& read(const ControlOutput& control, const Scene& scene, double time);

 private:
  bool ahead_;
  double period_;
  PlannedJoints planned_;
};

}  // namespace armtune::internal
