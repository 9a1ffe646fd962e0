#include "sim/rollout/applies.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

bool has_position_limits(const RobotModel& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const JointInfo& joint) { return joint.limits.has_position; });
}

bool has_acceleration_limits(const RobotModel& robot) {
  return std::any_of(robot.joints.begin(), robot.joints.end(),
                     [](const JointInfo& joint) { return std::isfinite(joint.limits.acceleration); });
}

}  // namespace

bool applies(Metric metric, const Scenario& scenario) {
  const bool step = scenario.stimulus && std::holds_alternative<Step>(scenario.stimulus->shape);
  switch (metric) {
    case Metric::kObstacleMinClearance:
      return !scenario.obstacles.empty();
    case Metric::kClearanceSelf:
      return scenario.clearance && scenario.clearance->has(Clearance::kSelf);
    case Metric::kClearanceCell:
      return scenario.clearance && scenario.clearance->has(Clearance::kCell);
    case Metric::kClearanceFloor:
      return scenario.clearance && scenario.clearance->has(Clearance::kFloor);
    case Metric::kJointPositionMinMargin:
      return has_position_limits(*scenario.robot);
    case Metric::kJointAccelerationMaxRatio:
      return has_acceleration_limits(*scenario.robot);
    case Metric::kGazeRms:
    case Metric::kGazeMax:
    case Metric::kGazeRateErrorRms:
    case Metric::kGazeRateErrorMax:
    case Metric::kGazeTimeOutside:
      return !scenario.holds_end;
    case Metric::kReacquisitionTime:
      return scenario.switches_target();
    case Metric::kJointErrorRms:
    case Metric::kJointErrorMax:
    case Metric::kToolErrorRms:
    case Metric::kToolErrorMax:
      return scenario.planned != nullptr;
    case Metric::kGoalSettlingTime:
    case Metric::kGoalOvershoot:
      return scenario.holds_goal();
    case Metric::kPositionXMax:
    case Metric::kPositionYMax:
    case Metric::kPositionZMax:
    case Metric::kPositionRms:
    case Metric::kPositionMax:
    case Metric::kLinearVelocityRms:
    case Metric::kLinearVelocityMax:
      return scenario.has_task();
    case Metric::kOrientationXMax:
    case Metric::kOrientationYMax:
    case Metric::kOrientationZMax:
    case Metric::kOrientationRms:
    case Metric::kOrientationMax:
    case Metric::kAngularVelocityRms:
    case Metric::kAngularVelocityMax:
      return scenario.has_task() && tracks_orientation(scenario.mask);
    case Metric::kResponseRiseTime:
    case Metric::kResponseOvershoot:
    case Metric::kResponseSettlingTime:
    case Metric::kResponseSteadyStateError:
      return step;
    case Metric::kResponseBandwidth:
      return scenario.stimulus && !step;
    default:
      return true;
  }
}

}  // namespace armtune::internal
