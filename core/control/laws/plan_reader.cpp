#include "core/control/laws/plan_reader.hpp"

#include "core/control/laws/joint_trajectory_law.hpp"

namespace armtune::internal {

PlanReader::PlanReader(int n, const Gains& gains, double period)
    : ahead_(feeds_next_velocity(gains)), period_(period), planned_(n) {}

const PlannedJoints& PlanReader::read(const ControlOutput& control, const Scene& scene, double time) {
  planned_.active = control.state == ControlState::kFollowPlan;
  if (!planned_.active) return planned_;
  planned_.position = control.planned.position;
  planned_.velocity = control.planned.velocity;
  if (!ahead_) {
    planned_.fed_velocity = planned_.velocity;
  } else if (scene.holds_plan && time + period_ > scene.plan->end()) {
    planned_.fed_velocity.setZero();
  } else {
    planned_.fed_velocity = scene.plan->at(time + period_).velocity;
  }
  return planned_;
}

}  // namespace armtune::internal
