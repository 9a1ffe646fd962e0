#include "tuner/cli/controller_study_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/stiffness_option.hpp"
#include "tuner/run/run_folder.hpp"
#ifdef ARMTUNE_SUITESPARSE
#include "tuner/planning/session/timed_goals.hpp"
#include "tuner/planning/session/tool_waypoints.hpp"
#endif

// armtune built without CHOLMOD has no planner, so it cannot find motions through positions without times, or
// along waypoints of the tool.
#ifdef ARMTUNE_SUITESPARSE
#define ARMTUNE_WITHOUT_TIMES ". Without times, armtune plans a motion through the positions"
#define ARMTUNE_WAYPOINTS "or of waypoints of the tool (time, x, y, z and perhaps qw, qx, qy, qz), "
#else
#define ARMTUNE_WITHOUT_TIMES ""
#define ARMTUNE_WAYPOINTS ""
#endif

namespace armtune::internal::cli {

void add_controller_study_options(CLI::App& command, ControllerStudyInputs& inputs, bool required) {
  CLI::Option* robot = command.add_option(
      "--robot", inputs.robot,
      "the arm: a URDF without xacro macros, a robot YAML, or a bundled robot such as ur5e");
  CLI::Option* controllers = command.add_option(
      "--controllers", inputs.controllers,
      "your unchanged ROS parameter file. It has the controller to tune: a joint_trajectory_controller, or "
      "the joint impedance controller of a Franka. For a file of any other form, such as that of a Cartesian "
      "impedance controller, give a map of gains here (docs/file_formats.md)");
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

std::string make_controller_study(ControllerStudyInputs inputs, const std::string& folder) {
#ifdef ARMTUNE_SUITESPARSE
  ProgressLine line;
  inputs.timing = [&line](const JointGoals& goals) {
    auto timed = time_goals(goals, stop_requested(), [&](std::size_t done, std::size_t all) {
      line.show(fmt::format("planning the motion of {}: {} of {} moves", goals.file, done, all));
    });
    line.clear();
    return timed;
  };
  inputs.tool_motion = motion_along;
#endif
  const auto files = write_controller_study(inputs, folder);
  if (!files) {
    fmt::print(stderr, "interrupted while a motion was planned; nothing was written\n");
    return {};
  }
  for (const std::string& note : files->notes) say(fmt::format("note: {}\n", note));
  say(fmt::format("wrote {}: {}\n", folder, fmt::join(files->written, ", ")));
  return files->study;
}

std::string study_beside_run(const ControllerStudyInputs& inputs, RunPlace& place, bool several_ranks) {
  if (place.folder.empty()) place.folder = default_run_folder(stem(inputs.robot));
  const std::string beside = absolute_path(place.folder) + "_study";
  if (place.resume) return beside + "/study.yaml";
  if (several_ranks)
    throw InputError(
        "tune: several MPI ranks cannot write a study together; write it first with 'armtune init' and the "
        "same options, then tune it");
  refuse_used_folder(place.folder);
  return make_controller_study(inputs, beside);
}

}  // namespace armtune::internal::cli
