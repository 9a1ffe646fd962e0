// armtune tune: a study from its start gains to the files of a run folder.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/live_report.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/report_file.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/task_notes.hpp"
#include "tuner/cli/tune_analysis.hpp"
#include "tuner/cli/tune_checks.hpp"
#include "tuner/cli/tune_help.hpp"
#include "tuner/cli/tune_report.hpp"
#include "tuner/cli/warm_arguments.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/search/sweep.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::cli {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

struct Arguments {
  std::string study = "ur10_gaze";
  std::string controller;  ///< in place of the study's; empty: its own
  std::string folder;
  std::string resume;  ///< the folder of the run to go on with
  int workers = default_workers();
  double deadline = 0.0;
  long max_evaluations = 0;
  long seed = -1;
  int record_every = 5;
  bool analysis = true;
  bool live = false;
  bool yardstick = false;
  WarmArguments warm;
};

Study load(const Arguments& args) {
  Study study = load_study(args.study, args.controller);
  if (args.max_evaluations > 0) study.max_evaluations = args.max_evaluations;
  if (args.seed >= 0) study.solver.seed = static_cast<std::uint64_t>(args.seed);
  WarmArguments warm = args.warm;
  // The run that a warm start came from may be gone by now; its gains are kept.
  if (!args.resume.empty() && !warm.from.empty()) warm.from = args.resume + "/" + kWarmGains;
  apply(warm, study);
  return study;
}

std::string progress_text(const Study& study, const TuneProgress& p, const CandidateRunner& workers,
                          double seconds) {
  const double left = seconds_left(p.evaluations, p.max_evaluations, p.last->seconds, study.max_minutes);
  return fmt::format("{:<6} {}/{}  best {:.4f}{}  velocity ratio {:.3f}  {:.2f} rollouts/s  {:.0f} s left",
                     p.phase, p.evaluations, p.max_evaluations, p.best->objective,
                     p.best->feasible ? "" : " (infeasible)", largest_velocity_ratio(study, *p.best),
                     static_cast<double>(workers.rollouts_done()) / seconds, left);
}

void announce(const Study& study, const Arguments& args, const Journal& journal) {
  if (args.live) say(fmt::format("watch it: open {}/report.html in a browser\n", args.folder));
  say(fmt::format(
      "study {}: {} gains over {} scenarios{}{}, {} in {} and {} at most, {} rollouts each; results go to "
      "{}\n",
      study.name, study.space.free.size(), study.scenarios.size(), robust_text(study),
      study.margins.empty() ? "" : fmt::format(" and {} margins as corners", study.margins.size()),
      search_text(study), engine_text(study), budget_text(study.max_evaluations, study.max_minutes),
      rollouts_per_evaluation(study), args.folder));
  const auto swept = static_cast<long>(sweep_points(study).size());
  const long room = evaluations_to_search(study);
  if (swept > 0 && swept >= room) {
    say(fmt::format(
        "the sweep's {} points use up the budget: {}; allow more, or leave factors out\n", swept,
        swept > room ? fmt::format("only {} of them are simulated", room) : "nothing is searched"));
  }
  if (!args.resume.empty()) say(fmt::format("goes on after {} finished evaluations\n", journal.records()));
  std::fflush(stdout);
}

/// The search with its files: what it finds is on disk before it goes on.
TuneResult search(const Study& study, const Arguments& args, CandidateRunner& workers, Journal& journal,
                  std::optional<Objective>& objective) {
  const auto began = Clock::now();
  std::optional<EvaluationsFile> evaluations;
  ProgressLine line;
  TuneCallbacks callbacks;
  TuneResult so_far;  // kept here, so that nothing finished is lost if the disk or a rollout fails
  callbacks.begin = [&](const Objective& o) {
    objective = o;
    announce(study, args, journal);
    write_start(study, args.folder);
    write_scene(args.folder,
                report::scene_of(study.scenarios, report::usual_sets(report::RunKind::kTune, args.folder),
                                 study.space.start.obstacleInfluenceRadius));
    evaluations.emplace(args.folder + "/evaluations.csv", study, std::vector<ExtraColumn>(),
                        AppendFile::Open::kReplace);
  };
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    if (so_far.evaluations++ == 0 || better(e, so_far.best)) so_far.best = e;
    evaluations->append(phase, e);
  };
  std::optional<LiveReport> live;
  if (args.live) live.emplace(args.folder);
  callbacks.progress = [&](const TuneProgress& p) {
    if (live)
      live->update(p.evaluations, p.max_evaluations,
                   seconds_left(p.evaluations, p.max_evaluations, p.last->seconds, study.max_minutes));
    line.show(progress_text(study, p, workers, seconds_since(began)));
  };
  TuneResult result;
  try {
    result = tune(study, workers, stop_requested(), callbacks, &journal);
  } catch (...) {
    const auto failure = std::current_exception();
    try {
      if (so_far.evaluations > 0) write_gains(study, so_far, args.folder);
    } catch (const std::exception&) {  // the first failure is the one to tell
    }
    std::rethrow_exception(failure);
  }
  if (evaluations) evaluations->finish();
  line.clear();
  return result;
}

int run(Arguments args, RankGroup& team) {
  const auto began = Clock::now();
  const Study study = load_inputs(args.resume, [&args] { return load(args); });
  if (!team.begin(plan_of(study, args.deadline), args.workers)) return kDone;
  const bool resumed = !args.resume.empty();
  if (resumed) args.folder = args.resume;
  if (args.folder.empty()) args.folder = default_run_folder(study.name);
  require_recording_memory(study.scenarios, args.record_every, args.workers);
  const RunHeader header = run_header(identity_of(study), inputs_of(study));
  FolderLock lock;
  if (!resumed) {
    lock = make_run_folder(args.folder);
    try {
      write_warm(study, args.folder);  // before the journal: a resumed run reads them here
    } catch (...) {
      discard_run(args.folder);
      throw;
    }
  }
  const auto journal = open_journal(args.folder, args.resume, header, files_of(study));
  if (journal->exit_code()) {
    say(fmt::format(
        "{}: this run is finished; there is nothing to resume. To search on from its best: {} tune {} "
        "--warm-start {}\n",
        args.folder, program_name(), args.study, args.folder));
    return *journal->exit_code();
  }
  const double before = journal->seconds();  // of the sessions of a run that goes on
  warn_of_clamped(study);
  // Before the start gains are simulated: a task that none can do may be why they do not complete it.
  for (const Scenario& scenario : study.scenarios) warn_of_task(scenario, study.space.start);
  CandidateRunner workers(team.pool(), study.robust);
  std::optional<Objective> objective;
  TuneResult result;
  try {
    result = search(study, args, workers, *journal, objective);
  } catch (...) {
    if (!resumed && !objective) discard_run(args.folder);
    if (objective) tell_how_to_go_on("tune", args.folder);
    throw;
  }
  if (result.evaluations == 0) {
    if (!resumed) discard_run(args.folder);
    fmt::print(stderr, "interrupted before the start gains were simulated; nothing to report\n");
    return kInterrupted;
  }
  write_gains(study, result, args.folder);
  if (result.interrupted && team.several()) {  // launchers that pass on a signal kill soon after
    say(fmt::format("interrupted: the search was not finished; to go on: {} tune --resume {}\n",
                    program_name(), args.folder));
    return kInterrupted;
  }
  const ReportOptions options = {args.folder, args.workers, args.record_every};
  ProgressLine line;
  line.show("fresh rollouts of the start and the tuned gains");
  const auto sets = verify(study, result, options);
  line.clear();
  std::vector<ComparedSet> robust;
  if (study.robust) robust = verify_robust(study, result, options, team);
  if (result.best.engine != Engine::kSimbody) {
    judge(*objective, study.robust ? robust[1] : sets[1], result);
    write_gains(study, result, args.folder);
  }
  std::vector<YardstickFiles> yardsticks(sets.size());
  const auto write_all = [&] {
    write_reports(study, result, sets, yardsticks, options, workers.count(), before + seconds_since(began));
  };
  write_all();  // first without the yardsticks, which take longer
  if (args.yardstick && !result.interrupted) {
    yardsticks = measure_sets(study, result, args.folder);
    write_all();
  }

  if (study.robust) {
    say(fmt::format("Each metric as the study folds it{}:\n\n{}The arm of the scenario itself:\n\n",
                    robust_text(study), comparison_table(robust, headline_metrics())));
  }
  say(comparison_table(sets, headline_metrics()));
  print_gains(study, result);
  const bool analysed = args.analysis && !result.interrupted &&
                        analyse(study, result, *objective, workers, {args.folder, args.workers});
  print_search(study, result, *objective);
  const SimulationVerdict verdict = check_search(study, result, *objective, sets[1], analysed, args.workers);
  print_recommendation(result, verdict.checks.front(), args.folder);
  const bool interrupted = result.interrupted || stop_requested();  // then some checks are missing
  if (!interrupted) write_verdict(args.folder, verdict);
  const std::string report = add_report(args.folder, [&study, &result] {
    return report::scene_of(
        study.scenarios,
        {{"start", "start", "start/errors.csv"}, {name(outcome_of(result)), ".", "errors.csv"}},
        study.space.start.obstacleInfluenceRadius);
  });
  const bool seen = report.find("report.html") != std::string::npos;
  say(fmt::format(
      "wrote {} in {:.0f} s: gains.yaml, errors.csv, rollout_<scenario>.csv, evaluations.csv, columns.csv, "
      "study.yaml, run.yaml{}{}{}{}; the start's in start/\n"
      "next: {}{} compare {}/start {}\n",
      args.folder, seconds_since(began), interrupted ? "" : ", verdict.yaml",
      analysed ? ", margins.csv, sensitivity.csv, reduced_study.yaml" : "", yardsticks.back().written, report,
      seen ? fmt::format("open {}/report.html in a browser; or ", args.folder) : "", program_name(),
      args.folder, args.folder));
  if (interrupted) {
    say(fmt::format("interrupted: {}; to go on: {} tune --resume {}\n",
                    result.interrupted ? "the search was not finished"
                                       : "the search was finished, the analysis after it was not",
                    program_name(), args.folder));
    return kInterrupted;
  }
  const int exit_code = conclude(verdict);
  journal->complete(exit_code);
  return exit_code;
}

}  // namespace

void add_tune_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("tune", "Tune gains: run a study and write a run folder");
  command->add_option("STUDY", args->study, "a bundled study or a YAML file of your own")
      ->capture_default_str();
  add_controller_option(*command, args->controller);
  command->add_option("--out", args->folder, "new folder for the results (default: runs/<study>_<time>)");
  command->add_option("--resume", args->resume, kResumeHelp);
  command->add_option("--workers", args->workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->add_option("--rollout-deadline", args->deadline, kDeadlineHelp)->check(CLI::PositiveNumber);
  command
      ->add_option("--max-evaluations", args->max_evaluations,
                   "budget, start and sweep included (default: the study's)")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--seed", args->seed, "of algorithms that draw random numbers (default: the study's)")
      ->check(CLI::Range(0L, 1000000000000L));
  command
      ->add_option("--record-every", args->record_every, "control periods per row of rollout_<scenario>.csv")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_flag(
      "!--no-analysis", args->analysis,
      "leave out what comes after the search: margins, random arms, endurance, and which gains matter");
  command->add_flag(
      "--live", args->live,
      "keep report.html fresh while the search goes on: open it in a browser, it loads itself again");
  add_yardstick_option(*command, args->yardstick);
  add_warm_options(*command, args->warm);
  command->footer(tune_help);
  command->callback([args, &exit_code] { exit_code = run(*args, team()); });
}

}  // namespace armtune::cli
