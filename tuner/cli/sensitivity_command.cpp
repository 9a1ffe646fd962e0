// armtune sensitivity: which of a run's gains matter.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/changed_inputs.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/sensitivity_report.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/run/hashed_table.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal::cli {
namespace {

struct Arguments {
  std::string run;
  std::string folder;
  int workers = default_workers();
  double deadline = 0.0;
};

std::string gains_of(const Arguments& args) {
  return run_file(args.run, "gains.yaml");
}

void write_files(const Study& study, const Sensitivity& result, const Arguments& args,
                 const HashedTable& evaluations, int workers, double seconds) {
  make_folder(args.folder + "/start");
  write_text_file(args.folder + "/start/gains.yaml",
                  gains_yaml(study.space.start, {"start of " + shown_path(study.source)}));
  write_sensitivity(study, result, args.folder);
  Provenance p;
  p.command = command_line();
  p.inputs = {study.source, study.gains, gains_of(args)};
  p.streamed = {{evaluations.table.name(), evaluations.hash}};
  add_inputs(study.scenarios, p.inputs);
  p.seed = study.solver.seed;
  p.workers = workers;
  p.wall_seconds = seconds;
  write_provenance(args.folder, p);
}

int run(const Arguments& args, RankGroup& team) {
  const auto seconds = [began = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  const Study study = load_study(run_file(args.run, "study.yaml"));
  std::vector<std::string> files;
  add_inputs(study.scenarios, files);
  if (const std::string changed = changed_input(inputs_of_run(args.run), files); !changed.empty())
    throw InputError(InputPlace{changed},
                     fmt::format("this file has changed since the run {}; tune again", args.run));
  if (!team.begin(plan_of(study, args.deadline), args.workers)) return kDone;
  const Gains best = load_gains(gains_of(args), joint_names(*study.scenarios.front().robot));
  const HashedTable evaluations = read_hashed_table(run_file(args.run, "evaluations.csv"));
  const auto journal = read_evaluations(evaluations.table, study);
  const FolderLock lock = make_run_folder(args.folder);

  CandidateRunner workers(team.pool(), study.robust);
  ProgressLine line;
  std::optional<Sensitivity> result;
  if (const auto start = simulate_points(study, {study.space.start_point()}, workers, stop_requested(), {})) {
    const Objective objective(study.terms, study.constraints, simulated_scenarios(study),
                              start->front().results, study.source);
    result = sensitivity(study, objective, best, journal, workers, stop_requested(),
                         [&line](std::size_t done, std::size_t all) {
                           line.show(fmt::format("{} of {} evaluations", done, all));
                         });
  }
  line.clear();
  if (!result) {
    fmt::print(stderr, "interrupted; nothing was written\n");
    return kInterrupted;
  }
  if (!args.folder.empty()) write_files(study, *result, args, evaluations, workers.count(), seconds());
  print_sensitivity(study, *result, study.space.free.size());
  print_advice(study, *result);
  if (args.folder.empty()) return kDone;
  say(
      fmt::format("wrote {0}: sensitivity.csv, reduced_study.yaml, run.yaml, inputs/\nnext: {1} tune "
                  "{0}/reduced_study.yaml\n",
                  args.folder, program_name()));
  return kDone;
}

}  // namespace

void add_sensitivity_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("sensitivity", "Show which gains of a run matter, and which do not");
  command->add_option("RUN", args->run, "the folder of a tuning run")->required();
  command->add_option(
      "--out", args->folder,
      "new folder for sensitivity.csv and reduced_study.yaml (default: no files). In the reduced study, the "
      "less important half of the gains is fixed at the start values");
  command->add_option("--workers", args->workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->add_option("--rollout-deadline", args->deadline, kDeadlineHelp)->check(CLI::PositiveNumber);
  command->footer(
      "importance  increase of the merit of the best gains if only this gain returns to its start value\n"
      "local       largest relative change of the merit for a step of 2 % of the gain's range, up or down\n"
      "Further columns of sensitivity.csv:\n"
      "elasticity        relative change of the merit per relative change of the gain (central differences)\n"
      "rank_correlation  rank correlation between gain and merit over the run's evaluations\n\n"
      "The merit is objective + penalty * (sum of the relative constraint violations), with the penalty of\n"
      "the study's search. A smaller merit is better.\n\n"
      "Example:\n  armtune tune ur10_gaze --out runs/gaze\n  armtune sensitivity runs/gaze\n");
  command->callback([args, &exit_code] { exit_code = run(*args, team()); });
}

}  // namespace armtune::internal::cli
