// armtune yardstick: each switch, return and lap of a run beside the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/rollout_scenarios.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/cli/yardstick_measures.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string folder;
  std::vector<std::string> scenarios;
  std::string out;
  YardstickOptions options;
};

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// yardstick.csv, and beside it with the ending .yaml where it came from.
std::string provenance_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".yaml").string();
}

void write_provenance(const Arguments& args, const std::string& csv, const std::vector<Scenario>& scenarios,
                      const RolloutMeasures& found, double seconds) {
  Provenance p;
  p.command = command_line();
  p.inputs = {args.folder + "/gains.yaml"};
  p.streamed = found.recordings;
  add_inputs(scenarios, p.inputs);
  p.wall_seconds = seconds;
  p.extra = {{"events", std::to_string(found.measures.size())},
             {"velocity", fmt::format("{}", args.options.velocity)},
             {"effort", fmt::format("{}", args.options.effort)},
             {"knots", std::to_string(args.options.knots)}};
  const std::string text = run_yaml(p);
  args.out.empty() ? write_text_file(provenance_path(csv), text)
                   : write_new_text_file(provenance_path(csv), text);
}

/// The page of the run, made again with what is new; never the reason for this to fail.
std::string report_again(const std::string& run) {
  if (!exists(run + "/report.html") || !report::available()) return {};
  try {
    SessionPrinter<> printer;
    warn_of_left_out(report::write_report(run, run + "/report.html"), printer);
    return fmt::format(", {}/report.html", run);
  } catch (const std::exception& error) {
    fmt::print(stderr, "armtune: warning: the report is as it was: {}\n", error.what());
    return {};
  }
}

int run(const Arguments& args) {
  if (args.folder.empty() || !is_there(args.folder + "/."))
    throw InputError(args.folder +
                     ": is no folder; give that of a run that was simulated with --out, or tuned");
  if (!args.out.empty()) {
    refuse_existing(args.out);
    refuse_existing(provenance_path(args.out));
  }
  const auto began = std::chrono::steady_clock::now();
  const std::vector<Scenario> scenarios = rollout_scenarios(args.folder, args.scenarios);
  const std::string gains = run_file(args.folder, "gains.yaml");
  const RolloutMeasures found = measure_rollouts(
      args.folder, scenarios,
      [&gains](const Scenario& s) { return load_gains(gains, joint_names(*s.robot)); }, args.options);
  if (stop_requested() && found.measures.empty()) {
    fmt::print(stderr, "interrupted; nothing was written\n");
    return kInterrupted;
  }
  const std::string csv = args.out.empty() ? args.folder + "/yardstick.csv" : args.out;
  const std::string table = yardstick_csv(found.measures);
  args.out.empty() ? write_text_file(csv, table) : write_new_text_file(csv, table);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - began;
  write_provenance(args, csv, scenarios, found, elapsed.count());
  std::string more;
  if (args.out.empty()) {
    const std::string run_folder = run_of(args.folder);
    more = add_columns(run_folder, {"yardstick.csv", yardstick_columns()}) + report_again(run_folder);
  }
  say(fmt::format("wrote {}, {}{}\n", csv, provenance_path(csv), more));
  return stop_requested() ? kInterrupted : kDone;
}

}  // namespace

void add_yardstick_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "yardstick", "Hold each switch, return and lap of a run against the best that the arm's limits allow");
  command
      ->add_option(
          "RUN", args->folder,
          "folder of a run, or of one of its gain sets (RUN/start), with gains.yaml and rollout_*.csv")
      ->required();
  command->add_option(
      "--scenarios", args->scenarios,
      "bundled names or files; unless given, the run's own, as its study.yaml or run.yaml says");
  command->add_option("--out", args->out,
                      "file to write in place of RUN/yardstick.csv; run and report then stay as they are");
  command
      ->add_option("--velocity", args->options.velocity,
                   "share of the velocity limits that counts as the limit")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->add_option("--effort", args->options.effort, "share of the effort limits")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command
      ->add_option(
          "--knots", args->options.knots,
          "time grid of each plan; a lap's has intervals of 25 ms at most, of 12.5 ms if targets switch")
      ->check(CLI::Range(20, 10000))
      ->capture_default_str();
  command->footer(
      "Each plan starts from the arm's state when the event begins, knows everything, and keeps the robot's "
      "positions,\n"
      "velocities and torques at its knots. It is the best found from one first guess: a local optimum. A "
      "lap is held\n"
      "against a small error, not against the least time; the mean is over the rollout's own times on both "
      "sides.\n"
      "Where the scenario has obstacles, plans keep the gains' influence radius from them, or what the arm "
      "has "
      "when the\n"
      "event begins; where no plan is found that does, they are left out and status says so. Scenarios with "
      "a "
      "stimulus\n"
      "are left out. A run's report.html is made again and shows all this.\n\n"
      "Example:\n  armtune simulate target_switch --out runs/published\n  armtune yardstick "
      "runs/published\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
