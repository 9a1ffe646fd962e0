// The command `armtune export`, which writes gains in a format that a robot can load.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/joint_values.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/export_origin.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/gains/gains_formats.hpp"
#include "tuner/gains/gains_origin.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::internal::cli {
namespace {

struct ExportArguments {
  GainsToExport what;
  std::string format = "yaml";
  std::string node;
  std::string into;
  std::string file;
};

/// Returns the text of the ROS parameter file `args.into`, in which only the gains are changed.
std::string changed_controllers(const ExportArguments& args, const GainsFile& gains) {
  const ParameterFile file = parameter_file_for(gains.gains, args.into, args.node, gains.joints);
  const std::string kind = controller_gains(file.controller, file.path, gains.joints).controller;
  if (gains.gains.controller != kind) {
    throw InputError(
        fmt::format("{}: the gains are for the controller '{}', but {} in the file of --into is a {}; give "
                    "gains for the controller in the file, or export without --into",
                    args.what.set, gains.gains.controller, file.controller.name, kind));
  }
  return with_gains(file.text, file.controller, file.path, gains.gains, gains.joints);
}

int run_export(const ExportArguments& args) {
  const GainsFormat format = gains_format_from_name(args.format);
  const std::string path = find_data_file("gains", gains_name(args.what.set));
  const std::string run = run_above(path);
  const auto robot = robot_of(args.what, run);
  GainsFile file;
  file.joints = joint_names(*robot);
  try {
    file.gains = load_gains(path, file.joints);
  } catch (const yaml::OtherJoints& e) {
    if (!args.what.robot.empty()) throw;
    throw e.with(
        fmt::format(". The gains were read for the arm {}; if they are for another arm, name it with --robot",
                    robot->name));
  }
  file.node = args.node;
  file.origin = origin_of(args.what, path, run, robot->source);
  file.origin.insert(file.origin.begin(),
                     {"gains", fmt::format("{}, for {}", shown_path(path), robot->name)});
  file.others = published_path(path);
  warn_of_failed_checks(path, run);
  const std::string text = args.into.empty() ? gains_text(file, format) : changed_controllers(args, file);
  if (args.file.empty()) {
    say(text);
    return kDone;
  }
  write_new_text_file(args.file, text);
  say(fmt::format("wrote {}\n", args.file));
  return kDone;
}

}  // namespace

void add_export_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<ExportArguments>();
  CLI::App* command = app.add_subcommand("export", "Write gains in a format that a robot can load");
  command->add_option("RUN_OR_GAINS", args->what.set, "run folder, gains file or bundled gains")->required();
  command
      ->add_option("--format", args->format,
                   "format of the output: yaml for armtune, ros1 for 'rosparam load', ros2 for the ROS 2 "
                   "option --params-file")
      ->check(CLI::IsMember(gains_format_names()))
      ->capture_default_str();
  CLI::Option* into = command->add_option(
      "--into", args->into,
      "ROS parameter file of the gains' controller, or a map of gains (docs/file_formats.md); the output is "
      "a copy of the parameter file in which only the gains are changed");
  into->excludes("--format");
  command->add_option("--node", args->node,
                      "node or namespace of the parameters in the output (default: simple_effort_ctrl; with "
                      "--format ros2 the pattern /**, which means every node). With --into: name of the "
                      "controller, if the file has several");
  command
      ->add_option("--robot", args->what.robot,
                   "arm that the gains are made for: a bundled robot, a robot YAML or a URDF")
      ->default_str("the arm of the run's study; for gains outside a run folder, ur10");
  into->needs(
      command->add_option("--out", args->file, "new file for the output")->default_str("standard output"));
  command->footer(
      "A comment at the top of the file lists the study, the seed and the input files of the run, how close\n"
      "the simulated joints came to their limits, and the order of axes and joints in lists of numbers. The\n"
      "line above each gain has its unit. Read docs/ros.md before the first motion of a real arm.\n\n"
      "Example:\n"
      "  armtune export runs/tuned --format ros2 --out gains.yaml\n"
      "  armtune export runs/moves --into ros2_controllers.yaml --out tuned_controllers.yaml");
  command->callback([args, &exit_code] { exit_code = run_export(*args); });
}

}  // namespace armtune::internal::cli
