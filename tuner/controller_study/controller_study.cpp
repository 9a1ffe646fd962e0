#include "tuner/controller_study/controller_study.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/input_file.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/controller_files/joint_trajectory_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/first_task/estimated_robot.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {
namespace {

constexpr double kFastestRate = 10000.0;  // Hz

constexpr const char* kScenario = R"(description: {description}
robot: {robot}
planned: {{file: {motion}, segments: as_ros}}
duration: planned
control_period: {period}   # s
theta_start: {{model_scale: 1.0}}   # no matter: this controller knows no masses
{cell}
# What the real arm has and the controller does not know: change it to what is known of yours.
plant:
  position_noise: 0.0001     # rad, m
  velocity_noise: 0.005      # rad/s, m/s
  torque_delay_periods: 1
)";

constexpr const char* kStudy = R"(description: {description}
gains: {gains}   # the start; it scores 1
{node}scenarios: [{scenarios}]

parameters:           # bounds of your own: {{name: ..., lower: ..., upper: ...}}
  - {{name: jtc_p}}
  - {{name: jtc_i}}
  - {{name: jtc_d}}

objective:
  - {{metric: joint_error/rms, weight: 1}}
  - {{metric: joint_error/max, weight: 1}}
  - {{metric: effort_rate/rms, weight: 0.2}}

constraints:
  - {{metric: joint_velocity/max_ratio, at_most: 0.9}}
  - {{metric: joint_effort/max_ratio, at_most: 0.9}}
  - {{metric: joint_position/min_margin, at_least: 0}}
{self}
# Gains that hold: the worst of the arm and six others at random counts, and one corner rollout for each
# stability margin must hold on the arm of the model.
robust: {{samples: 6, measure: worst}}
margins: {{delay_periods: 2, gain: 1.5, noise: 2, rate: 0.8}}

search:
  engine: native      # Simbody judges what is found
  max_evaluations: 400
  seed: 1
)";

/// The arm, and what of it has to be written: nothing where its files say all.
struct Arm {
  std::shared_ptr<const RobotModel> model;
  bool in_cell = false;   ///< its file has a cell of its own
  bool touches = false;   ///< its shapes are known, so that it can be kept from itself
  std::string yaml;       ///< of robot.yaml; empty: none is needed
  std::string reference;  ///< how scenarios name it
};

Arm arm_of(const std::string& robot) {
  const RobotFile file = read_robot_file(robot);
  Arm arm;
  arm.model = load_robot(robot);
  arm.reference = portable_reference(file.path);
  std::vector<std::string> inputs;
  arm.in_cell = cell_of(file, inputs).has_value();
  arm.touches = ClearanceModel(arm.model, Cell{}).has(Clearance::kSelf);
  if (!lacks_rotors(file, *arm.model)) return arm;
  RobotModel estimated = *arm.model;
  estimate_rotors(estimated);
  arm.yaml = estimated_robot_yaml(file, estimated);
  arm.model = std::make_shared<const RobotModel>(std::move(estimated));
  arm.reference = "robot.yaml";
  return arm;
}

/// The first `update_rate` that a file gives: the controller's own, then that of a controller manager.
double rate_in(const RosController& controller, const ControllerStudyInputs& inputs) {
  const yaml::PlacedValue* rate = controller.parameters->find("update_rate");
  for (const yaml::PlacedEntry& node : controller.all->entries) {
    const yaml::PlacedValue* parameters = node.value->find("ros__parameters");
    if (rate == nullptr && parameters != nullptr) rate = parameters->find("update_rate");
  }
  double hertz = 0.0;
  if (rate != nullptr) {
    const auto [end, error] =
        std::from_chars(rate->text.data(), rate->text.data() + rate->text.size(), hertz);
    if (error != std::errc() || end != rate->text.data() + rate->text.size()) hertz = 0.0;
  }
  if (rate == nullptr)
    throw InputError(fmt::format(
        "{}: it has no update_rate of the controller manager; say how often the controller runs with --rate HZ",
        inputs.controllers));
  if (!(hertz > 0.0 && hertz <= kFastestRate))
    throw InputError(fmt::format("{}:{}: update_rate is '{}'; expected Hz, above 0 and at most {:g}",
                                 inputs.controllers, rate->line, rate->text, kFastestRate));
  return hertz;
}

/// A motion, and what its scenario is called.
struct Move {
  std::string file;
  std::string name;
};

/// Each called as its file, with a number where that is taken.
std::vector<Move> moves_of(const std::vector<std::string>& files) {
  std::vector<Move> moves;
  std::set<std::string> taken = {"study", "robot"};
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    std::string name = stem;
    for (int number = 2; !taken.insert(name).second; ++number) name = fmt::format("{}_{}", stem, number);
    moves.push_back({file, name});
  }
  return moves;
}

/// What was taken for granted of a motion; empty: nothing.
std::string note_of(const Move& move, const RobotModel& arm) {
  const JointSpline motion = load_planned_motion({{move.file}, true}, arm);
  // Straight lines begin with a jump of the velocity.
  const bool straight =
      !motion.at(motion.begin()).velocity.isZero(0.0) && motion.knots().front().velocity.isZero(0.0);
  return straight
             ? fmt::format(
                   "{} has positions without velocities: as ROS does, they are joined by straight lines, and the "
                   "desired velocity jumps at every point; a file with velocities is followed better",
                   move.file)
             : "";
}

std::string scenario_yaml(const Move& move, const Arm& arm, const std::string& controller, double period) {
  return fmt::format(
      kScenario,
      fmt::arg("description",
               yaml::quoted(fmt::format("{} follows {} under {}", arm.model->name,
                                        std::filesystem::path(move.file).filename().string(), controller))),
      fmt::arg("robot", yaml::quoted(arm.reference)),
      fmt::arg("motion", yaml::quoted(absolute_path(move.file))), fmt::arg("period", period),
      fmt::arg(
          "cell",
          arm.touches && !arm.in_cell
              ? "\n# The arm is not to touch itself. What stands around it belongs here too: floor, parts.\n"
                "cell: {}\n"
              : ""));
}

std::string study_yaml(const std::vector<Move>& moves, const Arm& arm, const ControllerStudyInputs& inputs,
                       const std::string& controller) {
  std::vector<std::string> scenarios;
  scenarios.reserve(moves.size());
  for (const Move& move : moves) scenarios.push_back(yaml::quoted(move.name + ".yaml"));
  return fmt::format(
      kStudy,
      fmt::arg("description", yaml::quoted(fmt::format("gains of {} for {}", controller, arm.model->name))),
      fmt::arg("gains", yaml::quoted(absolute_path(inputs.controllers))),
      fmt::arg("node", inputs.node.empty() ? "" : fmt::format("node: {}\n", yaml::quoted(inputs.node))),
      fmt::arg("scenarios", fmt::join(scenarios, ", ")),
      fmt::arg("self", arm.touches ? "  - {metric: clearance/self, at_least: 0}\n" : ""));
}

}  // namespace

ControllerStudyFiles write_controller_study(const ControllerStudyInputs& inputs, const std::string& folder) {
  refuse_used_folder(folder);
  const Arm arm = arm_of(inputs.robot);
  const std::string text = read_input_file(inputs.controllers, yaml::kMaxBytes, "a ROS parameter file");
  const RosController controller =
      chosen_controller(ros_controllers(text, inputs.controllers), inputs.controllers, inputs.node);
  joint_trajectory_gains(controller, inputs.controllers, joint_names(*arm.model));
  const double rate = inputs.rate > 0.0 ? inputs.rate : rate_in(controller, inputs);
  const std::vector<Move> moves = moves_of(inputs.trajectories);

  ControllerStudyFiles files;
  files.study = folder + "/study.yaml";
  std::vector<std::pair<std::string, std::string>> texts = {
      {"study.yaml", study_yaml(moves, arm, inputs, controller.name)}};
  for (const Move& move : moves) {
    if (std::string note = note_of(move, *arm.model); !note.empty()) files.notes.push_back(std::move(note));
    texts.emplace_back(move.name + ".yaml", scenario_yaml(move, arm, controller.name, 1.0 / rate));
  }
  if (!arm.yaml.empty()) {
    texts.emplace_back("robot.yaml", arm.yaml);
    files.notes.push_back(fmt::format(
        "no file gives the rotor inertia of {}: it is estimated from the limits of effort and velocity",
        arm.model->name));
  }
  const FolderLock lock = make_run_folder(folder);
  for (const auto& [name, content] : texts) {
    write_text_file(fmt::format("{}/{}", folder, name), content);
    files.written.push_back(name);
  }
  return files;
}

}  // namespace armtune::internal
