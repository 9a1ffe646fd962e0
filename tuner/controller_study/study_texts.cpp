#include "tuner/controller_study/study_texts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "core/common/file_path.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "sim/scenario/trajectory_message.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kScenario = R"(description: {description}
robot: {robot}
{motion}control_period: {period}   # s
theta_start: {{model_scale: 1.0}}   # {masses}
{cell}
# Noise and delay of the real arm. Replace these values by those of your arm.
plant:
  position_noise: 0.0001     # rad, m
  velocity_noise: 0.005      # rad/s, m/s
  torque_delay_periods: 1
)";

constexpr const char* kJointMotion = R"(planned: {{file: {file}, segments: {segments}{units}{speed}}}
hold_end: 0.5              # s, time after the motion, in which the joints settle
)";

constexpr const char* kToolMotion =
    R"(planned: {{file: {start}}}   # joint positions at the start, where the controller takes over
path: {{waypoints: {path}}}
{orientation}duration: {duration:.9g}   # s
)";

constexpr const char* kStudy = R"(description: {description}
gains: {gains}   # start gains; their objective is 1
{node}{distro}scenarios: [{scenarios}]

# These gains are tuned from a fifth to five times their start value, unless bounds are given. To give other
# bounds, write {{name: ..., lower: ..., upper: ...}}. With a d of 0, the start gains do not damp the joint.
parameters:
{parameters}
objective:
{terms}  - {{metric: effort_rate/rms, weight: 0.2}}

constraints:
  - {{metric: joint_velocity/max_ratio, at_most: 0.9}}
  - {{metric: joint_effort/max_ratio, at_most: 0.9}}
{more}
# Robust gains: every metric is the worst over the arm and six random arms. For each stability margin, one
# more rollout with extra delay, gain, noise or a lower rate must keep the limits.
robust: {{samples: 6, measure: worst}}
margins: {{delay_periods: 2, gain: 1.5, noise: 2, rate: 0.8}}

search:
  engine: native      # Simbody checks the best gains found
  max_evaluations: 400
  seed: 1
)";

/// Returns the lines of a scenario that describe a motion of the joints.
std::string joint_motion_lines(const StudyMotion& move, const ControllerStudyInputs& inputs,
                               const ControllerInFile& from) {
  const bool degrees = inputs.degrees && move.message.empty() && !is_trajectory_message(move.file);
  return fmt::format(
      kJointMotion, fmt::arg("file", yaml::quoted(move.reference)),
      fmt::arg("segments", jumps_between_points(from.controller) ? "next_point" : "as_ros"),
      fmt::arg("units", degrees ? ", units: {angle: deg}" : ""),
      fmt::arg("speed",
               inputs.speed == 1.0 || !move.message.empty() ? "" : fmt::format(", speed: {}", inputs.speed)));
}

/// Returns the lines of a scenario that describe a path of the tool.
std::string tool_motion_lines(const StudyMotion& move) {
  const std::string path = yaml::quoted(move.reference);
  return fmt::format(
      kToolMotion, fmt::arg("start", yaml::quoted(move.start_reference)), fmt::arg("path", path),
      fmt::arg("orientation",
               move.path->turns
                   ? fmt::format("orientation: {{waypoints: {}}}\ntask_mask: pose\n", path)
                   : "task_mask: position   # the file gives no orientation of the tool\n"
                     "targets: [{name: none, center: [0, 0, 10]}]   # no effect with this task_mask\n"),
      fmt::arg("duration", move.path->duration));
}

/// Returns the terms of the objective that say how far the motions are missed.
std::string error_terms(const std::vector<StudyMotion>& moves) {
  std::string text;
  const auto add = [&text](Metric metric, const std::string& where = "") {
    text += fmt::format("  - {{metric: {}, weight: 1{}}}\n", name(metric), where);
  };
  if (moves.front().path) {
    for (const Metric metric : {Metric::kPositionRms, Metric::kPositionMax}) add(metric);
    std::vector<std::string> turning;
    for (const StudyMotion& move : moves) {
      if (move.path->turns) turning.push_back(yaml::quoted(move.name));
    }
    if (turning.empty()) return text;
    for (const Metric metric : {Metric::kOrientationRms, Metric::kOrientationMax})
      add(metric,
          turning.size() == moves.size() ? "" : fmt::format(", scenarios: [{}]", fmt::join(turning, ", ")));
    return text;
  }
  for (const Metric metric : {Metric::kJointErrorRms, Metric::kJointErrorMax}) add(metric);
  std::vector<std::string> of_tool;
  for (const StudyMotion& move : moves) {
    if (move.of_tool) of_tool.push_back(yaml::quoted(move.name));
  }
  if (of_tool.empty()) return text;
  for (const Metric metric : {Metric::kToolErrorRms, Metric::kToolErrorMax})
    add(metric,
        of_tool.size() == moves.size() ? "" : fmt::format(", scenarios: [{}]", fmt::join(of_tool, ", ")));
  return text;
}

}  // namespace

std::string scenario_yaml(const StudyMotion& move, const StudyArm& arm, const ControllerStudyInputs& inputs,
                          const ControllerInFile& from, double period) {
  return fmt::format(
      kScenario,
      fmt::arg("description", yaml::quoted(fmt::format("{} follows {} under {}", arm.model->name,
                                                       std::filesystem::path(move.file).filename().string(),
                                                       from.controller.name))),
      fmt::arg("robot", yaml::quoted(arm.reference)),
      fmt::arg("motion", move.path ? tool_motion_lines(move) : joint_motion_lines(move, inputs, from)),
      fmt::arg("period", period),
      fmt::arg("masses",
               from.gains.controller == kJointTrajectoryController && !arm.model->compensates_gravity
                   ? "no effect: this controller uses no masses"
                   : "the robot's own model of the arm, from which it computes gravity torques"),
      fmt::arg("cell",
               arm.touches_itself() && !arm.has_cell
                   ? "\n# The arm must not touch itself. Describe its surroundings here too: floor, parts.\n"
                     "cell: {}\n"
                   : ""));
}

std::string controller_study_yaml(const std::vector<StudyMotion>& moves, const StudyArm& arm,
                                  const ControllerStudyInputs& inputs, const std::string& controller,
                                  const std::string& parameters) {
  const bool own_file = !inputs.controllers.empty();
  std::vector<std::string> scenarios;
  scenarios.reserve(moves.size());
  for (const StudyMotion& move : moves) scenarios.push_back(yaml::quoted(move.name + ".yaml"));
  return fmt::format(
      kStudy,
      fmt::arg("description", yaml::quoted(fmt::format("gains of {} for {}", controller, arm.model->name))),
      fmt::arg("gains", own_file ? yaml::quoted(absolute_path(inputs.controllers)) : kStartGainsFile),
      fmt::arg("node", inputs.node.empty() ? "" : fmt::format("node: {}\n", yaml::quoted(inputs.node))),
      fmt::arg("distro", inputs.distro.empty() ? "" : fmt::format("distro: {}\n", inputs.distro)),
      fmt::arg("scenarios", fmt::join(scenarios, ", ")), fmt::arg("parameters", parameters),
      fmt::arg("terms", error_terms(moves)), fmt::arg("more", constraints_of(arm)));
}

}  // namespace armtune::internal
