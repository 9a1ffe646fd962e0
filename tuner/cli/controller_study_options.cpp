#include "tuner/cli/controller_study_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/stiffness_option.hpp"
#ifdef ARMTUNE_SUITESPARSE
#include "tuner/planning/session/motion_planner.hpp"
#endif

// armtune built without CHOLMOD has no planner, so it cannot find motions through positions without times, or
// along waypoints of the tool.
#ifdef ARMTUNE_SUITESPARSE
#define ARMTUNE_MOTION_PLANNER motion_planner()
#define ARMTUNE_WITHOUT_TIMES ". Without times, armtune plans a motion through the positions"
#define ARMTUNE_WAYPOINTS "or of waypoints of the tool (time, x, y, z and perhaps qw, qx, qy, qz), "
#else
#define ARMTUNE_MOTION_PLANNER MotionPlanner()
#define ARMTUNE_WITHOUT_TIMES ""
#define ARMTUNE_WAYPOINTS ""
#endif

namespace armtune::internal::cli {

void add_controller_study_options(CLI::App& command, ControllerStudyInputs& inputs, bool required) {
  CLI::Option* robot = command.add_option(
      "--robot", inputs.robot,
      "the arm: a URDF (or a xacro file with --xacro), a robot YAML, or a bundled robot such as ur5e");
  CLI::Option* controllers = command.add_option(
      "--controllers", inputs.controllers,
      "your unchanged ROS parameter file, with the controller to tune: a joint_trajectory_controller, or "
      "the joint impedance controller of a Franka. For a file of any other form, such as that of a Cartesian "
      "impedance controller, give here a YAML file of yours that says where its gains are (a map, "
      "docs/file_formats.md)");
  CLI::Option* trajectory =
      command
          .add_option(
              "--trajectory", inputs.trajectories,
              "one or more motions for which the gains are tuned: CSV files of joint positions, " ARMTUNE_WAYPOINTS
              "or a trajectory_msgs/JointTrajectory as YAML" ARMTUNE_WITHOUT_TIMES)
          ->expected(1, -1);
  CLI::Option* node = command.add_option(
      "--node", inputs.node, "name of the controller to tune, if the file of --controllers has several");
  CLI::Option* distro = command
                            .add_option("--distro", inputs.distro,
                                        "distribution of ROS that runs a joint_trajectory_controller")
                            ->default_str("jazzy for a ROS 2 file, noetic for a ROS 1 file")
                            ->check(CLI::IsMember({"jazzy", "humble", "noetic"}));
  CLI::Option* rate =
      command.add_option("--rate", inputs.rate, "control rate [Hz]")
          ->default_str(
              "update_rate or loop_hz in the file of --controllers; with --controller it must be given")
          ->check(CLI::Range(10.0, 10000.0));
  CLI::Option* degrees =
      command
          .add_flag("--degrees", inputs.degrees, "read the angles in CSV files of --trajectory in degrees")
          ->default_str("rad");
  CLI::Option* speed =
      command
          .add_option("--speed", inputs.speed,
                      "factor on the speed of the motions, as a robot's speed slider sets it: 0.5 doubles "
                      "their times")
          ->default_str("1")
          ->check(CLI::Range(0.01, 10.0));
  add_stiffness_option(command, inputs.max_stiffness);
  if (required) {
    for (CLI::Option* option : {robot, trajectory}) option->required();
  } else {
    robot->needs(trajectory);
    trajectory->needs(robot);
    controllers->needs(robot);
    rate->needs(robot);
  }
  node->needs(controllers);
  distro->needs(controllers);
  degrees->needs(trajectory);
  speed->needs(trajectory);
}

std::string write_study(const ControllerStudyInputs& inputs, const std::string& folder) {
  SessionPrinter<> printer;
  const auto files = make_controller_study(inputs, folder, ARMTUNE_MOTION_PLANNER, printer, stop_requested());
  if (!files) {
    fmt::print(stderr, "interrupted while a motion was planned; nothing was written\n");
    return {};
  }
  for (const std::string& note : files->notes) say(fmt::format("note: {}\n", note));
  say(fmt::format("wrote {}: {}\n", folder, fmt::join(files->written, ", ")));
  return files->study;
}

std::string study_beside_run(const ControllerStudyInputs& inputs, RunPlace& place, bool several_ranks) {
  const std::string folder = study_folder_beside(place, inputs, several_ranks);
  return place.resume ? folder + "/study.yaml" : write_study(inputs, folder);
}

}  // namespace armtune::internal::cli
