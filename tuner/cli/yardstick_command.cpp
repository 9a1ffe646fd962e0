// armtune yardstick: each switch, return and lap of a run beside the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/planning/yardstick/yardstick.hpp"
#include "tuner/report/csv_table.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string folder;
  std::vector<std::string> scenarios;
  std::string out;
  double velocity = 1.0;
  double effort = 1.0;
  int knots = 120;
};

/// The scenarios whose rollouts lie in the folder: those named, else bundled ones by the files' names.
std::vector<Scenario> scenarios_in(const Arguments& args) {
  std::vector<std::string> names = args.scenarios;
  if (names.empty()) {
    for (const auto& entry : std::filesystem::directory_iterator(args.folder)) {
      const std::string file = entry.path().filename().string();
      if (file.starts_with("rollout_") && file.ends_with(".csv"))
        names.push_back(file.substr(8, file.size() - 12));
    }
    std::sort(names.begin(), names.end());
  }
  std::vector<Scenario> scenarios;
  scenarios.reserve(names.size());
  for (const std::string& name : names) scenarios.push_back(load_scenario(name));
  if (scenarios.empty())
    throw InputError(
        args.folder +
        ": has no rollout_*.csv; give the folder of a run that was simulated with --out, or tuned");
  return scenarios;
}

void show(const Measure& m) {
  const bool lap = m.event.kind == EventKind::kLap;
  const double scale = lap ? 1e3 : 1.0;
  const char* shown_unit = lap ? "mrad rms" : "s";
  const std::string reached = std::isnan(m.event.reached)
                                  ? "not reached"
                                  : fmt::format("{:.4g} {}", scale * m.event.reached, shown_unit);
  if (m.status != PlanStatus::kSolved) {
    fmt::print(
        "  {} at {:.2f} s: {}; no limit found ({})\n", name(m.event.kind), m.event.time, reached,
        m.status == PlanStatus::kInfeasible ? "infeasible from there: " + m.held_back_by : "not solved");
    return;
  }
  fmt::print("  {} at {:.2f} s: {}; the joint limits allow {:.4g} {}", name(m.event.kind), m.event.time,
             reached, scale * m.limit, shown_unit);
  if (!m.held_back_by.empty()) fmt::print(" ({})", m.held_back_by);
  fmt::print("\n");
}

int run(const Arguments& args) {
  if (!std::filesystem::is_directory(args.folder)) throw InputError(args.folder + ": is no folder of a run");
  const std::vector<Scenario> scenarios = scenarios_in(args);
  std::vector<Measure> measures;
  ProgressLine line;
  for (const Scenario& scenario : scenarios) {
    const Gains gains = load_gains(args.folder + "/gains.yaml", joint_names(*scenario.robot));
    YardstickOptions options;
    options.velocity = args.velocity;
    options.effort = args.effort;
    options.knots = args.knots;
    options.gaze_threshold = gains.slerpAngularErrorThreshold;
    const auto rollout = report::CsvTable::read(args.folder + "/rollout_" + scenario.name + ".csv");
    const std::vector<Event> events = events_of(rollout, scenario, options.gaze_threshold);
    fmt::print("{}: {}\n", scenario.name, events.empty() ? "no switch, return or whole lap" : "");
    for (std::size_t i = 0; i < events.size() && !stop_requested(); ++i) {
      line.show(fmt::format("{}: {} of {} events", scenario.name, i, events.size()));
      measures.push_back(measure(events[i], scenario, options,
                                 [](const SequentialQuadraticProgress&) { return !stop_requested(); }));
      line.clear();
      if (!stop_requested()) show(measures.back());
    }
  }
  const std::string out = args.out.empty() ? args.folder + "/yardstick.csv" : args.out;
  write_text_file(out, yardstick_csv(measures));
  fmt::print("wrote {}\n", out);
  return stop_requested() ? kInterrupted : kDone;
}

}  // namespace

void add_yardstick_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "yardstick", "Hold each switch, return and lap of a run against the best that the arm's limits allow");
  command->add_option("RUN", args->folder, "folder of a run, with gains.yaml and rollout_*.csv")->required();
  command->add_option("--scenarios", args->scenarios,
                      "those of the rollouts that are not bundled, or fewer than all");
  command->add_option("--out", args->out, "file to write (default: RUN/yardstick.csv)");
  command->add_option("--velocity", args->velocity, "share of the velocity limits that counts as the limit")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->add_option("--effort", args->effort, "share of the effort limits")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command->add_option("--knots", args->knots, "time grid of each plan")
      ->check(CLI::Range(20, 10000))
      ->capture_default_str();
  command->footer(
      "Each plan starts from the arm's state when the event begins, knows everything, and keeps the robot's "
      "positions,\n"
      "velocities and torques at its knots. It is the best found from one first guess: a local optimum. A "
      "lap is held\n"
      "against a small error on its grid, not against the least time.\n\n"
      "Example:\n  armtune simulate target_switch --out runs/published\n  armtune yardstick "
      "runs/published\n");
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
