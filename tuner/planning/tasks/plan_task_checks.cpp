#include "tuner/planning/tasks/plan_task_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

/// check_position() and check_size() throw InputError if a joint position, velocity or acceleration violates
/// its limits. Otherwise, only the solver would find this.
void check_position(const yaml::Node& node, const JointVector& values, const RobotModel& robot) {
  for (int i = 0; i < robot.n(); ++i) {
    const JointInfo& joint = robot.joints[static_cast<std::size_t>(i)];
    if (!joint.limits.has_position || (values[i] >= joint.limits.lower && values[i] <= joint.limits.upper))
      continue;
    const std::string limits = cell(joint.limits.lower) + " .. " + cell(joint.limits.upper);
    node_of_joint(node, i, joint_names(robot))
        .fail(fmt::format("{} is {}; its limits are {}", joint.name, cell(values[i]), limits), limits);
  }
}

void check_size(const yaml::Node& node, const JointVector& values, const JointVector& limits,
                const RobotModel& robot) {
  for (Eigen::Index i = 0; i < std::min(values.size(), limits.size()); ++i) {
    if (!(std::abs(values[i]) <= limits[i]))
      node_of_joint(node, i, joint_names(robot))
          .fail(fmt::format("{} is {}; its limit is {}", robot.joints[static_cast<std::size_t>(i)].name,
                            cell(values[i]), cell(limits[i])),
                fmt::format("at most {} in size", cell(limits[i])));
  }
}

void check_start_and_goal(yaml::MapReader& map, const PlanTask& task) {
  const RobotModel& robot = *task.scenario.robot;
  if (task.goal.size() > 0) check_position(map.required("goal"), task.goal, robot);
  const yaml::Node* start = map.optional("start");
  if (start == nullptr || task.start.position.size() == 0) return;
  check_position(*start->find("position"), task.start.position, robot);
  if (task.start.velocity.size() > 0)
    check_size(*start->find("velocity"), task.start.velocity, task.limits.velocity * robot.velocity_limits(),
               robot);
  if (task.start.acceleration.size() > 0)
    check_size(*start->find("acceleration"), task.start.acceleration, acceleration_limits(task), robot);
}

/// Returns the keys that have an effect in this task, but not in every task.
std::vector<std::string> special_keys(const PlanTask& task) {
  switch (task.kind) {
    case PlanKind::kMove:
      return {"goal"};
    case PlanKind::kTrack:
      return {};
    case PlanKind::kSwitch:
      if (task.least_error) return {"least_error", "path_tolerance"};
      return {"least_error", "path_tolerance", "gaze_threshold", "hold"};
    case PlanKind::kReturn:
      if (task.end_gaze) return {"end_gaze", "gaze_threshold"};
      return {"end_gaze"};
    case PlanKind::kFastest:
      return {"path_tolerance"};
  }
  return {};
}

void refuse_idle_keys(yaml::MapReader& map, const PlanTask& task) {
  for (const char* key : {"goal", "least_error", "path_tolerance", "gaze_threshold", "hold", "end_gaze"}) {
    if (has_effect(key, task) || !map.has(key)) continue;
    const bool would = std::string(key) == "gaze_threshold" || std::string(key) == "hold";
    map.required(key).fail(fmt::format("has no effect in a {} task{}; leave it out", name(task.kind),
                                       would && task.kind == PlanKind::kSwitch   ? " with least_error"
                                       : would && task.kind == PlanKind::kReturn ? " without end_gaze"
                                                                                 : ""));
  }
}

/// Throws InputError for a task at whose start, the node, the target does not switch. The message names the
/// switch times.
[[noreturn]] void refuse_no_switch(const yaml::Node& node, const PlanTask& task) {
  constexpr std::size_t kNamed = 4;
  const Scenario& scenario = task.scenario;
  std::vector<std::string> times;
  double at = scenario.next_switch(0.0);
  while (at < scenario.duration && times.size() <= kNamed) {
    times.push_back(times.size() < kNamed ? fmt::format("{}", at) : "...");
    at = scenario.next_switch(at);
  }
  if (times.empty()) node.fail(scenario.name + " never switches its target; choose another scenario");
  const std::string limit = fmt::format("one of its switch times: {} s", fmt::join(times, ", "));
  node.fail(fmt::format("{} does not switch its target at {} s; give {}", scenario.name, task.at, limit),
            limit);
}

}  // namespace

bool has_effect(const std::string& key, const PlanTask& task) {
  const std::vector<std::string> keys = special_keys(task);
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

const yaml::Node& node_of_joint(const yaml::Node& node, Eigen::Index i,
                                const std::vector<std::string>& joints) {
  const auto at = static_cast<std::size_t>(i);
  return node.kind() == yaml::Node::Kind::kMap ? *node.find(joints[at]) : node.items()[at];
}

void check_task_scenario(const yaml::Node& scenario, const PlanTask& task) {
  if (task.scenario.orientation && task.kind != PlanKind::kMove)
    scenario.fail(
        "the scenario gives the tool's orientation, but plans support gaze targets only; give a scenario "
        "with targets",
        "a scenario with gaze targets");
  if (!tracks_orientation(task.scenario.mask) && task.kind != PlanKind::kMove)
    scenario.fail(
        "the scenario controls the tool position only, but every task except 'move' also needs a gaze "
        "target; give 'task: move', or a scenario with gaze targets",
        "a scenario that controls more than the tool position");
}

void check_plan_task(yaml::MapReader& map, const PlanTask& task) {
  const yaml::Node& kind = map.required("task");
  if (task.kind == PlanKind::kMove && task.goal.size() == 0)
    kind.fail("a move needs a goal; give the joint positions at its end as 'goal'", "the key 'goal'");
  refuse_idle_keys(map, task);
  check_start_and_goal(map, task);
  if (task.kind == PlanKind::kReturn && task.start.position.size() == 0 && task.start.rollout.empty())
    kind.fail("a return needs a start state off the path; give start: {position: [...]} or {rollout: FILE}",
              "the key 'start'");
  if (task.kind == PlanKind::kTrack && !task.duration)
    kind.fail("a track task needs a duration; give 'duration' [s]", "the key 'duration'");
  if (task.least_error && !task.duration)
    kind.fail("least_error needs a duration; give 'duration' [s]", "the key 'duration'");
  if (task.kind == PlanKind::kSwitch &&
      task.scenario.active_target(task.at + task.scenario.control_period) ==
          task.scenario.active_target(std::max(0.0, task.at - task.scenario.control_period)))
    refuse_no_switch(map.required("at"), task);
}

}  // namespace armtune::internal
