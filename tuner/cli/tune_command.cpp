// The command `armtune tune`, which tunes the gains of a study and writes the results to a run folder.

#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/controller_study_options.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/mcap_option.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/stiffness_option.hpp"
#include "tuner/cli/tune_help.hpp"
#include "tuner/cli/tune_printer.hpp"
#include "tuner/cli/warm_arguments.hpp"
#include "tuner/cli/yardstick_option.hpp"
#include "tuner/first_task/steady_start.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal::cli {
namespace {

struct TuneArguments {
  std::string study;          ///< empty: made from the files in `own`
  ControllerStudyInputs own;  ///< files of the user's robot; without a robot: none
  std::string controller;     ///< controller to tune; empty: the study's
  long max_evaluations = 0;
  long seed = -1;
  bool yardstick = false;
  WarmArguments warm;
  TuneSettings settings = {};
};

Study load(const TuneArguments& args) {
  Study study = load_steady_study(args.study, args.controller, args.settings.workers);
  if (args.max_evaluations > 0) study.max_evaluations = args.max_evaluations;
  if (args.seed >= 0) study.solver.seed = static_cast<std::uint64_t>(args.seed);
  if (args.own.robot.empty()) apply_stiffness(args.own.max_stiffness, study);
  apply(args.warm, args.settings.place, study);
  return study;
}

int run_tune(TuneArguments& args, RankGroup& team) {
  if (args.own.robot.empty() && args.study.empty())
    throw InputError(
        "tune: no study is given; give a study file, a bundled study such as ur10_gaze, or your robot's "
        "files with --robot, --controllers (or --controller and --rate) and --trajectory");
  if (!args.own.robot.empty()) {
    args.own.kind = std::exchange(args.controller, {});
    args.study = study_beside_run(args.own, args.settings.place, team.several());
    if (args.study.empty()) return kInterrupted;
  }
  const Study study = load_inputs(args.settings.place, [&args] { return load(args); });
  TuneSettings settings = args.settings;
  if (settings.place.folder.empty()) settings.place.folder = default_run_folder(study.name);
  settings.yardstick = yardstick_if(args.yardstick);
  TunePrinter printer(study, settings, args.study);
  const auto outcome = TuneSession(study, settings, session_context(), printer).run(team);
  if (!outcome) return kDone;
  printer.ended(*outcome);
  return static_cast<int>(outcome->ending);
}

}  // namespace

void add_tune_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<TuneArguments>();
  TuneSettings& settings = args->settings;
  settings.workers = default_workers();
  CLI::App* command =
      app.add_subcommand("tune", "Tune the gains of a study, and write the results to a run folder");
  CLI::Option* study = command->add_option("STUDY", args->study,
                                           "a bundled study, such as ur10_gaze, or a YAML file of your own");
  CLI::Option* controller = add_controller_option(*command, args->controller);
  controller->description(
      controller->get_description() +
      ". With --robot, give this option if the controller has no parameter file: its start "
      "gains are then computed from the arm");
  add_controller_study_options(*command, args->own, false);
  command->get_option("--controllers")->excludes(controller);
  command->get_option("--robot")->excludes(study);
  add_run_options(*command, "new folder for the results", "runs/<study>_<time>", settings.place,
                  settings.workers, settings.deadline);
  command
      ->add_option("--max-evaluations", args->max_evaluations,
                   "number of evaluations, start gains included; each simulates every scenario with one gain "
                   "set")
      ->default_str("study's value")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--seed", args->seed, "seed of algorithms that use random numbers")
      ->default_str("study's seed")
      ->check(CLI::Range(0L, 1000000000000L));
  command
      ->add_option("--record-every", settings.record_every,
                   "number of control periods between two rows of rollout_<scenario>.csv")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  add_mcap_option(*command, settings.mcap);
  command->add_flag(
      "!--no-analysis", settings.analysis,
      "skip the analysis after the search: stability margins, simulations of randomly changed arms, "
      "endurance, and sensitivity of the gains");
  command->add_flag("--live", settings.live,
                    "update report.html while the search runs; the page reloads itself in a browser");
  add_yardstick_option(*command, args->yardstick);
  add_warm_options(*command, args->warm);
  command->footer(tune_help);
  command->callback([args, &exit_code] { exit_code = run_tune(*args, team()); });
}

}  // namespace armtune::internal::cli
