#include "tuner/controller_study/controller_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/position_streaming_law.hpp"
#include "core/control/laws/velocity_drive.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/controller_study/controller_in_file.hpp"
#include "tuner/controller_study/controller_rate.hpp"
#include "tuner/controller_study/study_motions.hpp"
#include "tuner/first_task/estimated_robot.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kGainsFile = "gains.yaml";
constexpr double kFastDrive = 1.0;  // above, a velocity error changes its sign in every period of the drive

constexpr const char* kScenario = R"(description: {description}
robot: {robot}
planned: {{file: {motion}, segments: as_ros{units}{speed}}}
hold_end: 0.5              # s, time at the end of the motion, in which the joints settle
control_period: {period}   # s
theta_start: {{model_scale: 1.0}}   # {masses}
{cell}
# Noise and delay of the real arm. Replace these values by those of your arm.
plant:
  position_noise: 0.0001     # rad, m
  velocity_noise: 0.005      # rad/s, m/s
  torque_delay_periods: 1
)";

constexpr const char* kStudy = R"(description: {description}
gains: {gains}   # start gains; their objective is 1
{node}{distro}scenarios: [{scenarios}]

# These gains are tuned from a fifth to five times their start value, unless bounds are given. To give other
# bounds, write {{name: ..., lower: ..., upper: ...}}. A d of 0 starts without damping.
parameters:
{parameters}
objective:
  - {{metric: joint_error/rms, weight: 1}}
  - {{metric: joint_error/max, weight: 1}}
{tool}  - {{metric: effort_rate/rms, weight: 0.2}}

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

/// The arm, and the text of robot.yaml if its own files do not describe it completely.
struct Arm {
  std::shared_ptr<const RobotModel> model;
  std::shared_ptr<const ClearanceModel> clearance;
  bool has_cell = false;                         ///< true if its file describes the cell around it
  std::vector<std::pair<Metric, bool>> contact;  ///< metric of each kind of contact; true if it applies
  std::string yaml;                              ///< text of robot.yaml; empty: not needed
  std::string reference;                         ///< name by which scenarios refer to the arm

  bool touches_itself() const { return contact.front().second; }
};

Arm arm_of(const std::string& robot) {
  const RobotFile file = read_robot_file(robot);
  Arm arm;
  arm.model = load_robot(robot);
  arm.reference = portable_reference(file.path);
  std::vector<std::string> inputs;
  const std::optional<Cell> cell = cell_of(file, inputs);
  arm.has_cell = cell.has_value();
  arm.clearance = std::make_shared<const ClearanceModel>(arm.model, cell.value_or(Cell{}));
  for (const auto& [metric, kind] : {std::pair{Metric::kClearanceSelf, Clearance::kSelf},
                                     {Metric::kClearanceCell, Clearance::kCell},
                                     {Metric::kClearanceFloor, Clearance::kFloor}})
    arm.contact.emplace_back(metric, arm.clearance->has(kind));
  if (!lacks_rotors(file, *arm.model)) return arm;
  RobotModel estimated = *arm.model;
  estimate_rotors(estimated);
  arm.yaml = estimated_robot_yaml(file, estimated);
  arm.model = std::make_shared<const RobotModel>(std::move(estimated));
  arm.reference = "robot.yaml";
  return arm;
}

/// Returns the limits that this arm can violate, as constraints of a study.
std::string constraints_of(const Arm& arm) {
  std::string text;
  const auto add = [&text](Metric metric) {
    text += fmt::format("  - {{metric: {}, at_least: 0}}\n", name(metric));
  };
  const auto& joints = arm.model->joints;
  if (std::any_of(joints.begin(), joints.end(),
                  [](const JointInfo& joint) { return joint.limits.has_position; }))
    add(Metric::kJointPositionMinMargin);
  if (std::any_of(joints.begin(), joints.end(),
                  [](const JointInfo& joint) { return std::isfinite(joint.limits.acceleration); }))
    text += fmt::format("  - {{metric: {}, at_most: 0.9}}\n", name(Metric::kJointAccelerationMaxRatio));
  for (const auto& [metric, possible] : arm.contact) {
    if (possible) add(metric);
  }
  return text;
}

std::string scenario_yaml(const StudyMotion& move, const Arm& arm, const ControllerStudyInputs& inputs,
                          const ControllerInFile& from, double period) {
  const bool degrees = inputs.degrees && move.message.empty() && !is_trajectory_message(move.file);
  return fmt::format(
      kScenario,
      fmt::arg("description", yaml::quoted(fmt::format("{} follows {} under {}", arm.model->name,
                                                       std::filesystem::path(move.file).filename().string(),
                                                       from.controller.name))),
      fmt::arg("robot", yaml::quoted(arm.reference)), fmt::arg("motion", yaml::quoted(move.reference)),
      fmt::arg("period", period),
      fmt::arg("masses",
               from.gains.controller == kJointTrajectoryController && !arm.model->compensates_gravity
                   ? "no effect: this controller uses no masses"
                   : "the robot's own model of the arm, from which it computes gravity torques"),
      fmt::arg("units", degrees ? ", units: {angle: deg}" : ""),
      fmt::arg("speed",
               inputs.speed == 1.0 || !move.message.empty() ? "" : fmt::format(", speed: {}", inputs.speed)),
      fmt::arg("cell",
               arm.touches_itself() && !arm.has_cell
                   ? "\n# The arm must not touch itself. Describe its surroundings here too: floor, parts.\n"
                     "cell: {}\n"
                   : ""));
}

/// Returns the terms of the objective for the motions that the user gave as waypoints of the tool. Empty if
/// there are none.
std::string tool_terms(const std::vector<StudyMotion>& moves) {
  std::vector<std::string> names;
  for (const StudyMotion& move : moves) {
    if (move.of_tool) names.push_back(yaml::quoted(move.name));
  }
  if (names.empty()) return {};
  const std::string where =
      names.size() == moves.size() ? "" : fmt::format(", scenarios: [{}]", fmt::join(names, ", "));
  std::string text;
  for (const Metric metric : {Metric::kToolErrorRms, Metric::kToolErrorMax})
    text += fmt::format("  - {{metric: {}, weight: 1{}}}\n", name(metric), where);
  return text;
}

std::string study_yaml(const std::vector<StudyMotion>& moves, const Arm& arm,
                       const ControllerStudyInputs& inputs, const std::string& controller,
                       const std::string& parameters) {
  const bool own_file = !inputs.controllers.empty();
  std::vector<std::string> scenarios;
  scenarios.reserve(moves.size());
  for (const StudyMotion& move : moves) scenarios.push_back(yaml::quoted(move.name + ".yaml"));
  return fmt::format(
      kStudy,
      fmt::arg("description", yaml::quoted(fmt::format("gains of {} for {}", controller, arm.model->name))),
      fmt::arg("gains", own_file ? yaml::quoted(absolute_path(inputs.controllers)) : kGainsFile),
      fmt::arg("node", inputs.node.empty() ? "" : fmt::format("node: {}\n", yaml::quoted(inputs.node))),
      fmt::arg("distro", inputs.distro.empty() ? "" : fmt::format("distro: {}\n", inputs.distro)),
      fmt::arg("scenarios", fmt::join(scenarios, ", ")), fmt::arg("parameters", parameters),
      fmt::arg("tool", tool_terms(moves)), fmt::arg("more", constraints_of(arm)));
}

/// Returns the distribution of ROS that the user names, if any.
std::optional<RosDistro> named_distro(const ControllerStudyInputs& inputs) {
  if (inputs.distro.empty()) return std::nullopt;
  const auto distro = distro_from_name(inputs.distro);
  if (!distro) throw InputError(fmt::format("--distro is '{}'; give jazzy, humble or noetic", inputs.distro));
  return distro;
}

/// Adds notes on how the controller's file is read: the order of lists under a map of gains, and the
/// distribution of ROS whose rules are simulated.
void note_reading(const ControllerInFile& from, std::vector<std::string>& notes) {
  if (from.controller.layout == GainLayout::kMapped)
    notes.push_back(fmt::format("lists of numbers in {} are taken in the order of the joints {}", from.file,
                                fmt::join(from.joints, ", ")));
  if (from.file.empty() || !is_joint_trajectory_controller(from.gains.controller)) return;
  const bool open = from.controller.ros2 && !from.controller.distro;
  notes.push_back(fmt::format("{} is simulated as in {}{}", from.controller.name,
                              rules_of(jtc_distro(from.gains)).title,
                              open ? "; give --distro humble if the robot runs that distribution" : ""));
}

/// Returns the control rate [Hz] that the user gives, or else the one in the parameter file. Throws
/// InputError if there is neither.
double rate_of(const ControllerStudyInputs& inputs, const ControllerInFile& from) {
  if (inputs.rate > 0.0) return inputs.rate;
  // In a file that armtune does not know, a key update_rate may mean anything.
  if (inputs.controllers.empty() || from.controller.layout == GainLayout::kMapped)
    throw InputError("give the control rate with --rate HZ");
  if (const auto rate = controller_rate(from.controller, inputs.controllers)) return *rate;
  throw InputError(
      InputPlace{inputs.controllers},
      "the file has no update_rate of the controller manager; give the control rate with --rate HZ");
}

/// Adds a note if the simulated velocity drives are too fast for their rate somewhere on the motions.
/// control_rate [Hz].
void note_fast_drives(const Gains& gains, const RobotModel& arm, const std::vector<StudyMotion>& moves,
                      double control_rate, std::vector<std::string>& notes) {
  if (gains.controller != kPositionStreaming && gains.controller != kJointTrajectoryVelocityController)
    return;
  constexpr int kPoints = 50;  // on each motion
  const double rate = control_rate * steps_in(1.0 / control_rate, drive_frequency(arm, 0.0));
  double most = 0.0;
  Eigen::Index joint = 0;
  for (const StudyMotion& move : moves) {
    for (int k = 0; k <= kPoints; ++k) {
      const double share = static_cast<double>(k) / kPoints;
      const double time = move.motion.begin() + share * (move.motion.end() - move.motion.begin());
      Eigen::Index fastest = 0;
      const double step = drive_step(arm, move.motion.at(time).position, 1.0 / rate).maxCoeff(&fastest);
      if (step <= most) continue;
      most = step;
      joint = fastest;
    }
  }
  if (most < kFastDrive) return;
  notes.push_back(fmt::format(
      "the simulated velocity drive of {} is too fast for its rate of {:.4g} Hz: in each period it removes "
      "{:.0f} % of a velocity error, and more than {:.0f} % makes it overshoot. The arm may shake in simulation "
      "although it does not on the robot. Give the velocity_gain of your drives in a robot YAML, or their rate "
      "if it is higher, up to 1e5 Hz (drives: {{rate: {:.0f}}})",
      arm.joints[static_cast<std::size_t>(joint)].name, rate, 100.0 * most, 100.0 * kFastDrive,
      std::min(1e5, std::ceil(rate * most / 1000.0) * 1000.0)));
}

/// True if the folder contains exactly these files, as after an earlier call.
bool is_there_already(const std::vector<std::pair<std::string, std::string>>& texts,
                      const std::string& folder) {
  std::error_code none;
  std::size_t files = 0;
  for (auto entry = std::filesystem::directory_iterator(folder, none);
       !none && entry != std::filesystem::directory_iterator(); entry.increment(none))
    ++files;
  if (none || files != texts.size()) return false;
  return std::all_of(texts.begin(), texts.end(), [&folder](const auto& text) {
    const std::string path = fmt::format("{}/{}", folder, text.first);
    std::error_code missing;
    return std::filesystem::is_regular_file(path, missing) &&
           read_file(path, yaml::kMaxBytes, "a file") == text.second;
  });
}

}  // namespace

std::optional<ControllerStudyFiles> write_controller_study(const ControllerStudyInputs& inputs,
                                                           const std::string& folder) {
  const bool own_file = !inputs.controllers.empty();
  if (own_file == !inputs.kind.empty())
    throw InputError(
        "give the robot's controller: its ROS parameter file with --controllers FILE, or the name of one of "
        "armtune's controllers with --controller NAME");
  const Arm arm = arm_of(inputs.robot);
  ControllerInFile from;
  from.controller.ros2 = true;
  if (own_file)
    from = read_controller(inputs.controllers, inputs.node, joint_names(*arm.model), named_distro(inputs));
  const double rate = rate_of(inputs, from);
  const auto read = study_motions(inputs, {"", arm.model, arm.clearance, {}, from.controller.ros2});
  if (!read) return std::nullopt;
  const std::vector<StudyMotion>& moves = *read;
  const JointSpline& first = moves.front().motion;
  const JointVector start = first.at(first.begin()).position;
  if (!own_file) from = new_controller(inputs.kind, *arm.model, start);
  const std::string& controller = from.controller.name;
  std::vector<std::string> undamped;
  const std::vector<double> most_stiffness = bounded_stiffness(inputs.max_stiffness, from);
  const std::string parameters = tuned_parameters(from, *arm.model, start, most_stiffness, undamped);

  ControllerStudyFiles files;
  note_reading(from, files.notes);
  if (has_stiffness(from) && most_stiffness.empty())
    files.notes.emplace_back(
        "the stiffness is not tuned, only the damping: how stiff the arm may become depends on contacts, which "
        "are not simulated. To tune it, give its largest value with --max-stiffness, in N m/rad");
  note_fast_drives(from.gains, *arm.model, moves, rate, files.notes);
  files.study = folder + "/study.yaml";
  std::vector<std::pair<std::string, std::string>> texts = {
      {"study.yaml", study_yaml(moves, arm, inputs, controller, parameters)}};
  for (const StudyMotion& move : moves) {
    add_notes(move, files.notes);
    texts.emplace_back(move.name + ".yaml", scenario_yaml(move, arm, inputs, from, 1.0 / rate));
    if (!move.message.empty()) texts.emplace_back(move.reference, move.message);
  }
  if (!own_file)
    texts.emplace_back(
        kGainsFile, gains_yaml(from.gains, {"start gains of " + controller + ", computed by armtune"}, {}));
  if (!undamped.empty())
    files.notes.push_back(
        fmt::format("the gain d of {} is 0 in {}; it is tuned as well, because the joints may need damping",
                    fmt::join(undamped, ", "), inputs.controllers));
  if (!arm.yaml.empty()) {
    texts.emplace_back("robot.yaml", arm.yaml);
    files.notes.push_back(fmt::format(
        "no file gives the rotor inertia of {}: it is estimated from the limits of effort and velocity",
        arm.model->name));
  }
  for (const auto& entry : texts) files.written.push_back(entry.first);
  if (is_there_already(texts, folder)) return files;
  const FolderLock lock = make_run_folder(folder);
  for (const auto& [name, content] : texts) write_text_file(fmt::format("{}/{}", folder, name), content);
  return files;
}

}  // namespace armtune::internal
