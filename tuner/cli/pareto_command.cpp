// The command `armtune pareto`, which finds the Pareto front of a study. Each point of the front has gains
// that a robot can load.

#include <CLI/CLI.hpp>
#include <memory>

#include "tuner/cli/commands.hpp"
#include "tuner/cli/front_printer.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/stiffness_option.hpp"
#include "tuner/first_task/steady_start.hpp"

namespace armtune::internal::cli {
namespace {

struct ParetoArguments {
  std::string study;
  std::string controller;  ///< controller to tune; empty: the study's
  std::vector<double> max_stiffness = {};
  long seed = -1;
  FrontSettings settings = {};
};

int run_pareto(const ParetoArguments& args, RankGroup& team) {
  Study study = load_inputs(args.settings.place, [&args] {
    return load_steady_study(args.study, args.controller, args.settings.workers);
  });
  if (args.seed >= 0) study.solver.seed = static_cast<std::uint64_t>(args.seed);
  apply_stiffness(args.max_stiffness, study);
  FrontSettings settings = args.settings;
  if (settings.place.folder.empty()) settings.place.folder = default_run_folder("pareto_" + study.name);
  FrontPrinter printer(settings);
  const auto outcome = FrontSession(study, settings, session_context(), printer).run(team);
  if (!outcome) return kDone;
  print_front(*outcome, study, settings.place.folder);
  return static_cast<int>(outcome->ending);
}

}  // namespace

void add_pareto_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<ParetoArguments>();
  FrontSettings& settings = args->settings;
  settings.criteria = {"objective", "joint_velocity/max_ratio"};
  settings.workers = default_workers();
  CLI::App* command =
      app.add_subcommand("pareto", "Find a study's Pareto front, such as accuracy against joint velocity");
  command->add_option("STUDY", args->study, "a bundled study, such as ur10_gaze, or a YAML file of your own")
      ->required();
  add_controller_option(*command, args->controller);
  add_stiffness_option(*command, args->max_stiffness);
  command
      ->add_option("--criteria", settings.criteria,
                   "two or three criteria of the front: metrics, or the word objective for the study's "
                   "objective. The worst value of a metric over the scenarios counts")
      ->expected(2, 3)
      ->capture_default_str();
  command
      ->add_option(
          "--levels", settings.levels,
          "number of upper bounds for each criterion except the first. For each bound (with three criteria: "
          "each pair of bounds) the first criterion is minimised. The bounds are applied one after another, "
          "from the lowest to the highest, and then back")
      ->default_str("12, or 4 with three criteria")
      ->check(CLI::Range(2, 1000));
  command
      ->add_option("--max-evaluations", settings.max_evaluations,
                   "number of evaluations; each simulates every scenario with one gain set")
      ->default_str("four times the number in the study")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--seed", args->seed, "seed of algorithms that use random numbers")
      ->default_str("the study's seed")
      ->check(CLI::Range(0L, 1000000000000L));
  add_run_options(*command, "new folder for the results", "runs/pareto_<study>_<time>", settings.place,
                  settings.workers, settings.deadline);
  command->footer(
      "Every point of the front keeps the study's constraints. The first search minimises the first\n"
      "criterion. It alone uses the keys 'global', 'global_share', 'algorithm' and 'constraints' of the\n"
      "study's section 'search'. The steps, engine and seed of the study apply to all searches. The keys\n"
      "'sweep', 'starts' and 'verify_share' are not used. At the end the points of the front are\n"
      "simulated again, in addition to the budget of evaluations. One end of the front is the\n"
      "minimum of the first criterion. For each other criterion, the end is its minimum while the\n"
      "remaining criteria are no worse than with the start gains.\n\n"
      "Example:\n  armtune pareto ur10_gaze --criteria gaze/rms "
      "joint_velocity/max_ratio effort_rate/rms --levels 5\n");
  command->callback([args, &exit_code] { exit_code = run_pareto(*args, team()); });
}

}  // namespace armtune::internal::cli
