// armtune export: gains in the form a robot loads.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/joint_values.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/gains/gains_formats.hpp"
#include "tuner/gains/gains_origin.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"

namespace armtune::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string set;
  std::string format = "yaml";
  std::string robot;
  std::string node;
  std::string file;
};

bool is_folder(const std::string& set) {
  std::error_code ignored;
  return fs::is_directory(set, ignored);
}

/// The arm that the gains are for: the one asked for; else that of the run's study; else the UR10. Throws
/// InputError for a run without a study, which does not say which arm it is of.
std::shared_ptr<const RobotModel> robot_of(const Arguments& args, const std::string& run) {
  if (!args.robot.empty()) return load_robot(args.robot);
  if (!run.empty()) return scenarios_of(run, {}, {}).front().robot;
  if (!is_folder(args.set)) return load_robot("ur10");
  throw InputError(fmt::format(
      "{}: no study.yaml in it says which arm the gains are for; name it with --robot", args.set));
}

/// Where the gains came from; figures only where they are these gains' on this arm.
std::vector<std::pair<std::string, std::string>> origin_of(const Arguments& args, const std::string& path,
                                                           const std::string& run, const std::string& robot) {
  std::vector<std::string> files = {robot};
  if (!args.robot.empty()) files.push_back(read_robot_file(args.robot).path);
  const auto of_robot = origin_of_files(files);
  if (run.empty() && !is_folder(args.set)) {
    files.push_back(path);
    return origin_of_files(files);
  }
  const std::string& folder = run.empty() ? args.set : run;
  auto origin = origin_of_run(folder);
  const auto is_known = [&origin](const auto& row) {
    return !row.first.starts_with("input ") || std::find(origin.begin(), origin.end(), row) != origin.end();
  };
  const bool of_other_arm = !std::all_of(of_robot.begin(), of_robot.end(), is_known);
  const auto own = find_run_file(folder, "gains.yaml");  // a front has none
  const bool of_other_gains = !own || hash_of_input(path) != hash_of_input(*own);
  if (!of_other_arm && !of_other_gains) return origin;
  origin = origin_of_run(folder, false);
  origin.insert(
      origin.begin(),
      {"warning", fmt::format("the figures of this run are not of these {}: simulate them",
                              of_other_arm ? "gains on this arm" : "gains, which stand beside it")});
  for (const auto& row : of_robot) {
    if (!is_known(row)) origin.push_back(row);
  }
  return origin;
}

int run(const Arguments& args) {
  const GainsFormat format = gains_format_from_name(args.format);
  const std::string path = find_data_file("gains", gains_name(args.set));
  const std::string run = run_above(path);
  const auto robot = robot_of(args, run);
  GainsFile file;
  file.joints = joint_names(*robot);
  try {
    file.gains = load_gains(path, file.joints);
  } catch (const yaml::OtherJoints& e) {
    if (!args.robot.empty()) throw;
    throw InputError(fmt::format("{}; read for {}: name another arm with --robot", e.what(), robot->name));
  }
  file.node = args.node;
  file.origin = origin_of(args, path, run, robot->source);
  file.origin.insert(file.origin.begin(),
                     {"gains", fmt::format("{}, for {}", shown_path(path), robot->name)});
  file.others = published_path(path);
  const std::string text = gains_text(file, format);
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
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("export", "Write gains in the form that a robot reads");
  command->add_option("RUN_OR_GAINS", args->set, "run folder, gains file or bundled gains")->required();
  command
      ->add_option("--format", args->format,
                   "yaml: armtune's own; ros1: for rosparam load; ros2: for --params-file")
      ->check(CLI::IsMember(gains_format_names()))
      ->capture_default_str();
  command->add_option(
      "--node", args->node,
      "name space or node that the parameters are of (default: simple_effort_ctrl; of ros2 '/**', "
      "every node)");
  command->add_option(
      "--robot", args->robot,
      "the arm that the gains are for (default: that of the run's study; of gains alone ur10)");
  command->add_option("--out", args->file, "new file (default: to the screen)");
  command->footer(
      "A comment at the top says which study, seed and inputs the gains came from, how much of the joints'\n"
      "limits they use in simulation, and the order of numbers. Each gain stands below its unit. Before the\n"
      "first motion of a real arm, see docs/ros.md.\n\n"
      "Example:\n"
      "  armtune export runs/tuned --format ros2 --out gains.yaml");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
