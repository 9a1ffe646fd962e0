#include "tuner/planning/tasks/plan_start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/scenario/data_files.hpp"
#include "tuner/planning/tasks/tool_motion.hpp"

namespace armtune::internal {
namespace {

constexpr double kLeadIn = 3.0;  // s on the path before the start, in which the inverse kinematics settles

StartState given_start(const PlanTask& task, const RobotModel& robot, const ControllerMotion* controller) {
  StartState state;
  if (controller != nullptr) {
    state.position = controller->motion.position.col(0);
    state.velocity = controller->motion.velocity.col(0);
    return state;
  }
  state.velocity = JointVector::Zero(robot.n());
  if (task.start.position.size() > 0) {
    state.position = task.start.position;
    if (task.start.velocity.size() > 0) state.velocity = task.start.velocity;
    state.acceleration = task.start.acceleration;
    return state;
  }
  if (task.kind == PlanKind::kMove) {
    state.position = task.scenario.start_position;
    state.acceleration = JointVector::Zero(robot.n());
    return state;
  }
  const Scenario& scenario = task.scenario;
  const double from = task.at - kLeadIn;
  // At a switch, this is the target that the gaze leaves.
  const Path& target =
      scenario.targets[scenario.active_target(std::max(0.0, task.at - scenario.control_period))].path;
  const Vec3 tool = scenario.path.at(from).position;
  const auto pose = pose_at(robot, tool, target.at(from).position, scenario.start_position,
                            BestPose::kLargestManipulability);
  if (!pose) {
    const std::string point = fmt::format("({:.4g}, {:.4g}, {:.4g}) m", tool.x(), tool.y(), tool.z());
    throw OutOfReach(
        InputPlace{shown_path(task.source), 0, "scenario"},
        InputFault{.problem = fmt::format(
                       "within its joint limits, {} cannot place its tool at {} with the tool's z axis on "
                       "the gaze target; move the path, or give a 'start'",
                       robot.name, point),
                   .value = point});
  }
  TimeGrid lead_in;
  lead_in.start = from;
  lead_in.phases = {{"lead-in", 30, kLeadIn, false}};
  const Trajectory motion = follow(
      robot, *pose, lead_in, [&](double t) { return scenario.path.at(t); },
      [&](double t) { return target.at(t); });
  state.position = motion.position.col(30);
  if (task.kind != PlanKind::kFastest) state.velocity = motion.velocity.col(30);  // kFastest begins at rest
  return state;
}

}  // namespace

StartState start_state(const PlanTask& task, const RobotModel& robot, const ControllerMotion* controller) {
  StartState state = given_start(task, robot, controller);
  if (state.acceleration.size() == 0 && state.velocity.isZero())
    state.acceleration = acceleration_at_rest(task);
  return state;
}

JointVector acceleration_at_rest(const PlanTask& task) {
  return JointVector::Zero(task.limits.jerk.size());
}

}  // namespace armtune::internal
