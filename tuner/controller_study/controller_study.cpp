#include "tuner/controller_study/controller_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/position_streaming_law.hpp"
#include "core/control/laws/velocity_drive.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/document.hpp"
#include "tuner/controller_study/controller_in_file.hpp"
#include "tuner/controller_study/controller_rate.hpp"
#include "tuner/controller_study/study_arm.hpp"
#include "tuner/controller_study/study_motions.hpp"
#include "tuner/controller_study/study_texts.hpp"
#include "tuner/controller_study/tuned_parameters.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {
namespace {

constexpr double kFastDrive = 1.0;  // above, a velocity error changes its sign in every period of the drive

/// Returns the distribution of ROS that the user names, if any.
std::optional<RosDistro> named_distro(const ControllerStudyInputs& inputs) {
  if (inputs.distro.empty()) return std::nullopt;
  const auto distro = distro_from_name(inputs.distro);
  if (!distro) throw InputError(fmt::format("--distro is '{}'; give jazzy, humble or noetic", inputs.distro));
  return distro;
}

/// Adds a note if the controller was chosen among several in its file.
void note_choice(const ControllerStudyInputs& inputs, const ControllerInFile& from,
                 std::vector<std::string>& notes) {
  const std::vector<std::string>& others = from.controller.neighbours;
  if (!inputs.node.empty() || others.empty()) return;
  constexpr std::size_t kMostNames = 5;
  const std::size_t shown = std::min(others.size(), kMostNames);
  notes.push_back(
      fmt::format("of the controllers in {}, {} is tuned. The others are not changed: {}{}", from.file,
                  from.controller.name,
                  fmt::join(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                  shown < others.size() ? fmt::format(" and {} more", others.size() - shown) : ""));
}

/// Adds notes on how the controller's file is read: the order of lists under a map of gains, the distribution
/// of ROS whose rules are simulated, and motions without interpolation.
void note_reading(const ControllerInFile& from, std::vector<std::string>& notes) {
  if (from.controller.layout == GainLayout::kMapped)
    notes.push_back(fmt::format("lists of numbers in {} are taken in the order of the joints {}{}", from.file,
                                fmt::join(from.joints, ", "),
                                is_of_tool(from) ? ", or of the axes x, y, z, rx, ry, rz" : ""));
  if (from.file.empty() || !is_joint_trajectory_controller(from.gains.controller)) return;
  const bool open = from.controller.ros2 && !from.controller.distro;
  notes.push_back(fmt::format("{} is simulated as in {}{}", from.controller.name,
                              rules_of(jtc_distro(from.gains)).title,
                              open ? "; give --distro humble if the robot runs that distribution" : ""));
  if (jumps_between_points(from.controller))
    notes.push_back(fmt::format(
        "{} does not interpolate (interpolation_method: none), so its desired positions jump from point to "
        "point, and the joint errors contain these jumps; give the motion with as many points as the robot "
        "receives",
        from.controller.name));
}

/// Returns the control rate [Hz] that the user gives, or else the one in the parameter file, and adds a note
/// about the latter. Throws InputError if there is neither.
double rate_of(const ControllerStudyInputs& inputs, const ControllerInFile& from,
               std::vector<std::string>& notes) {
  if (inputs.rate > 0.0) return inputs.rate;
  if (from.controller.rate > 0.0) return from.controller.rate;
  // In a file that armtune does not know, a key update_rate may mean anything.
  if (inputs.controllers.empty() || from.controller.layout == GainLayout::kMapped)
    throw InputError(InputPlace{from.controller.map_file, 0, "rate"},
                     inputs.controllers.empty()
                         ? "give the control rate with --rate HZ"
                         : "the map gives no control rate; give 'rate: HZ' in the map, or --rate HZ");
  const auto rate = controller_rate(from.controller, inputs.controllers);
  if (!rate)
    throw InputError(InputPlace{inputs.controllers, 0, "update_rate"},
                     "the file has neither an update_rate of the controller manager nor a loop_hz of the "
                     "control loop; give the control rate with --rate HZ");
  notes.push_back(fmt::format("the control rate is {:g} Hz, the value of {} in {}; --rate replaces it",
                              rate->hertz, rate->key, inputs.controllers));
  return rate->hertz;
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
      "{:.0f} % of a velocity error, and it overshoots if this is more than {:.0f} %. The arm may shake in "
      "simulation although it does not on the robot. In a robot YAML, give the velocity_gain of your drives, "
      "or their rate if it is higher, up to 1e5 Hz (drives: {{rate: {:.0f}}})",
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

/// Adds a note if the stiffness stays as it is.
void note_stiffness(const ControllerInFile& from, const std::vector<double>& most,
                    std::vector<std::string>& notes) {
  if (!has_stiffness(from) || !most.empty()) return;
  notes.push_back(fmt::format(
      "the stiffness is not tuned, only the damping: how stiff the arm may become depends on contacts, which "
      "are not simulated. To tune it, give its largest value with --max-stiffness, in {}",
      is_of_tool(from) ? "N/m and N m" : "N m/rad"));
}

/// The controller of a study, its rate, and the motions that it follows.
struct StudyTask {
  ControllerInFile from;
  double rate = 0.0;  ///< [Hz]
  Segments segments = Segments::kAsRos;
  std::vector<StudyMotion> moves;
};

/// Reads the controller and the motions, or computes the start gains. Adds notes on the controller. Returns
/// nothing if planning was stopped.
std::optional<StudyTask> read_task(const ControllerStudyInputs& inputs, const StudyArm& arm,
                                   std::vector<std::string>& notes) {
  StudyTask task;
  ControllerInFile& from = task.from;
  from.controller.ros2 = true;
  from.gains.controller = inputs.kind;
  if (!inputs.controllers.empty())
    from = read_controller(inputs.controllers, inputs.node, joint_names(*arm.model), named_distro(inputs));
  task.rate = rate_of(inputs, from, notes);
  if (jumps_between_points(from.controller)) task.segments = Segments::kNextPoint;
  const JointGoals goals{"", arm.model, arm.clearance, {}, from.controller.ros2};
  if (is_of_tool(from)) {
    task.moves = tool_motions(inputs, goals, 1.0 / task.rate);
  } else {
    auto moves = study_motions(inputs, goals, task.segments);
    if (!moves) return std::nullopt;
    task.moves = *std::move(moves);
  }
  if (inputs.controllers.empty()) {
    const JointSpline& first = task.moves.front().motion;
    from = new_controller(inputs.kind, *arm.model, first.at(first.begin()).position);
  }
  from.turns = std::any_of(task.moves.begin(), task.moves.end(),
                           [](const StudyMotion& move) { return !move.path || move.path->turns; });
  note_choice(inputs, from, notes);
  note_reading(from, notes);
  return task;
}

/// Returns the names and texts of the files of a study.
std::vector<std::pair<std::string, std::string>> texts_of(const StudyTask& task, const StudyArm& arm,
                                                          const ControllerStudyInputs& inputs,
                                                          const std::string& parameters) {
  const std::string& controller = task.from.controller.name;
  std::vector<std::pair<std::string, std::string>> texts = {
      {"study.yaml", controller_study_yaml(task.moves, arm, inputs, controller, parameters)}};
  for (const StudyMotion& move : task.moves) {
    texts.emplace_back(move.name + ".yaml", scenario_yaml(move, arm, inputs, task.from, 1.0 / task.rate));
    if (!move.message.empty()) texts.emplace_back(move.reference, move.message);
    if (move.path) texts.emplace_back(move.start_reference, move.path->start);
  }
  if (inputs.controllers.empty())
    texts.emplace_back(
        kStartGainsFile,
        gains_yaml(task.from.gains, {"start gains of " + controller + ", computed by armtune"}, {}));
  if (!arm.yaml.empty()) texts.emplace_back("robot.yaml", arm.yaml);
  return texts;
}

}  // namespace

std::optional<ControllerStudyFiles> write_controller_study(const ControllerStudyInputs& inputs,
                                                           const std::string& folder) {
  if (inputs.controllers.empty() == inputs.kind.empty())
    throw InputError(
        "give the robot's controller: its ROS parameter file with --controllers FILE, or the name of one of "
        "armtune's controllers with --controller NAME");
  const StudyArm arm = study_arm(inputs.robot);
  ControllerStudyFiles files;
  auto task = read_task(inputs, arm, files.notes);
  if (!task) return std::nullopt;
  const JointSpline& first = task->moves.front().motion;
  const JointVector start = first.at(first.begin()).position;
  const std::vector<double> most_stiffness = bounded_stiffness(inputs.max_stiffness, task->from);
  const TunedParameters parameters = tuned_parameters(task->from, *arm.model, start, most_stiffness);
  note_stiffness(task->from, most_stiffness, files.notes);
  note_fast_drives(task->from.gains, *arm.model, task->moves, task->rate, files.notes);
  for (const StudyMotion& move : task->moves) add_notes(move, task->segments, files.notes);
  if (!parameters.note.empty()) files.notes.push_back(parameters.note);
  if (!parameters.undamped.empty())
    files.notes.push_back(
        fmt::format("the gain d of {} is 0 in {}; it is tuned as well, because the joints may need damping",
                    fmt::join(parameters.undamped, ", "), inputs.controllers));
  if (!arm.yaml.empty())
    files.notes.push_back(fmt::format(
        "no file gives the rotor inertia of {}: it is estimated from the limits of effort and velocity",
        arm.model->name));
  files.study = folder + "/study.yaml";
  const auto texts = texts_of(*task, arm, inputs, parameters.lines);
  for (const auto& entry : texts) files.written.push_back(entry.first);
  if (is_there_already(texts, folder)) return files;
  const FolderLock lock = make_run_folder(folder);
  for (const auto& [name, content] : texts) write_text_file(fmt::format("{}/{}", folder, name), content);
  return files;
}

}  // namespace armtune::internal
