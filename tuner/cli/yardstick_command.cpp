// The command `armtune yardstick`, which compares each target switch, return to the path and lap of a run
// with the best motion that the arm's limits allow.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/yardstick_printer.hpp"
#include "tuner/planning/session/yardstick_session.hpp"

namespace armtune::internal::cli {
namespace {

int run_yardstick(const YardstickSettings& settings) {
  YardstickPrinter printer;
  const YardstickOutcome outcome = YardstickSession(settings, session_context(), printer).run();
  if (outcome.files.empty())
    fmt::print(stderr, "interrupted; nothing was written\n");
  else
    say(fmt::format("wrote {}\n", fmt::join(outcome.files, ", ")));
  return static_cast<int>(outcome.ending);
}

}  // namespace

void add_yardstick_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<YardstickSettings>();
  CLI::App* command = app.add_subcommand(
      "yardstick", "Compare the target switches, returns and laps of a run with optimal motions");
  command
      ->add_option(
          "RUN", args->folder,
          "run folder, or folder of one of its gain sets (RUN/start), with gains.yaml and rollout_*.csv")
      ->required();
  command->add_option(
      "--scenarios", args->scenarios,
      "bundled scenarios or scenario files (default: the scenarios that the run's study.yaml or run.json "
      "names)");
  command->add_option("--out", args->out,
                      "new file instead of RUN/yardstick.csv; the run's files and report then stay "
                      "unchanged");
  command
      ->add_option("--velocity", args->options.velocity,
                   "share of the velocity limits that the optimal motions may use")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command
      ->add_option("--effort", args->options.effort,
                   "share of the effort limits that the optimal motions may use")
      ->check(CLI::Range(0.01, 1.0))
      ->capture_default_str();
  command
      ->add_option(
          "--knots", args->options.knots,
          "number of intervals in each plan's time grid; the plan of a lap has more if an interval would "
          "otherwise be longer than 25 ms, or than 12.5 ms if targets switch")
      ->check(CLI::Range(20, 10000))
      ->capture_default_str();
  command->footer(
      "There are three kinds of events: a switch to another target, a return to the path, and a lap of the\n"
      "path. For each event an optimal motion (plan) is computed. It starts from the arm's state at the\n"
      "beginning of the event, and uses the exact model of the arm and the future motion of targets and\n"
      "obstacles. It keeps the limits of joint position, velocity and torque at its knots, which are the\n"
      "points of its time grid.\n"
      "It is the best plan found from one first guess: a local optimum. The plan of a switch or return has\n"
      "the least time, the plan of a lap the least error. For a lap, the RMS gaze errors of plan and\n"
      "rollout are compared at the recorded times. The gaze error is the angle between the tool's z axis\n"
      "and the line to the target.\n\n"
      "If the scenario has obstacles, a plan keeps a distance from them: the gain obstacleInfluenceRadius,\n"
      "or, if it is smaller, the least distance of the rollout during the event. If no such plan is found,\n"
      "the obstacles are ignored, and the column status shows that. Scenarios are left out if they\n"
      "have a stimulus (a step or sines), if they give the tool's orientation, or if their task is the\n"
      "position alone. The run's report.html is written again, with the comparison.\n\n"
      "Example:\n  armtune simulate target_switch --out runs/published\n  armtune yardstick "
      "runs/published\n");
  command->callback([args, &exit_code] { exit_code = run_yardstick(*args); });
}

}  // namespace armtune::internal::cli
