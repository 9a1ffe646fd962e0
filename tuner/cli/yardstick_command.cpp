// armtune yardstick: each switch, return and lap of a run beside the best that the arm's limits allow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "armtune/error.hpp"
#include "core/common/path_state.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/rollout_scenarios.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/yardstick_files.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal::cli {
namespace {

int run(const YardstickRequest& request) {
  if (request.folder.empty() || !is_there(request.folder + "/."))
    throw InputError(request.folder +
                     ": is no folder; give that of a run that was simulated with --out, or tuned");
  refuse_used_output(request);
  const Stopwatch watch;
  const std::vector<Scenario> scenarios = rollout_scenarios(request.folder, request.scenarios);
  const std::string gains = run_file(request.folder, "gains.yaml");
  const RolloutMeasures found = measure_rollouts(
      request.folder, scenarios,
      [&gains](const Scenario& s) { return load_gains(gains, joint_names(*s.robot)); }, request.options);
  if (stop_requested() && found.measures.empty()) {
    fmt::print(stderr, "interrupted; nothing was written\n");
    return kInterrupted;
  }
  say(fmt::format("wrote {}\n", write_yardstick(request, scenarios, found, watch.seconds())));
  return stop_requested() ? kInterrupted : kDone;
}

}  // namespace

void add_yardstick_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<YardstickRequest>();
  CLI::App* command = app.add_subcommand(
      "yardstick", "Compare each switch, return and lap of a run with the best that the arm's limits allow");
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
  command->add_option("--velocity", args->options.velocity, "factor on the velocity limits, for a reserve")
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

}  // namespace armtune::internal::cli
