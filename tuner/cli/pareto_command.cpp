// armtune pareto: the front of a study, point by point, each with gains that a robot can load.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/error_report.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/report_file.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/tune_report.hpp"
#include "tuner/cli/warm_arguments.hpp"
#include "tuner/evaluation/evaluations_file.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string study = "ur10_gaze";
  std::string controller;  ///< in place of the study's; empty: its own
  std::vector<std::string> criteria = {"objective", "joint_velocity/max_ratio"};
  std::size_t levels = 0;
  long max_evaluations = 0;
  long seed = -1;
  std::string folder;
  std::string resume;  ///< the folder of the run to go on with
  int workers = default_workers();
  double deadline = 0.0;
};

ParetoOptions options_of(const Arguments& args, const Study& study) {
  ParetoOptions options;
  for (const std::string& name : args.criteria) {
    options.criteria.push_back(criterion_from_name(name));
    for (std::size_t k = 0; k + 1 < options.criteria.size(); ++k) {
      if (options.criteria[k].name() == name) throw InputError("criterion " + name + " stands twice");
    }
  }
  constexpr std::size_t kForTwo = 12;
  constexpr std::size_t kForThree = 4;
  options.levels = args.levels > 0 ? args.levels : options.criteria.size() == 2 ? kForTwo : kForThree;
  options.max_evaluations = args.max_evaluations > 0 ? args.max_evaluations : 4 * study.max_evaluations;
  const auto least = static_cast<long>(options.searches() * (study.space.free.size() + 1));
  if (options.max_evaluations < 3 * least / 2) {
    fmt::print(stderr,
               "armtune: warning: {} evaluations are few for {} searches over {} gains, each of which begins "
               "with one "
               "evaluation per gain; allow {} or ask for fewer --levels\n",
               options.max_evaluations, options.searches(), study.space.free.size(), 3 * least / 2);
  }
  return options;
}

void write_front(const Study& study, const ParetoOptions& options, const ParetoResult& result,
                 const std::string& folder) {
  write_text_file(folder + "/pareto.csv", pareto_csv(study, options, result));
  make_folder(folder + "/points");
  for (std::size_t i = 0; i < result.front.size(); ++i) {
    const ParetoPoint& p = result.front[i];
    std::vector<std::string> header = {
        fmt::format("point {} of {}'s front by armtune, seed {}", i + 1, study.name, study.solver.seed)};
    for (const Criterion& c : options.criteria) {
      header.push_back(fmt::format("{} {:.6g} (start {:.6g})", c.name(), value(c, p.e, study.scenarios),
                                   value(c, result.start.e, study.scenarios)));
    }
    write_text_file(folder + "/" + point_file(i), gains_yaml(p.e.gains, header));
  }
  // Those of a longer front that was written before.
  for (std::size_t i = result.front.size(); std::filesystem::remove(folder + "/" + point_file(i)); ++i) {
  }
}

/// The criteria that are metrics: the study need not look at them.
std::vector<ExtraColumn> criteria_columns(const Study& study, const ParetoOptions& options) {
  std::vector<ExtraColumn> columns;
  for (const Criterion& c : options.criteria) {
    if (!c.metric) continue;
    columns.push_back({{"criterion/" + c.name(),
                        c.unit(),
                        fmt::format("{}; the worst over the scenarios", field(*c.metric).meaning),
                        {}},
                       [c, &study](const Evaluation& e) { return value(c, e, study.scenarios); }});
  }
  return columns;
}

RunHeader header_of(const Study& study, const Arguments& args, const ParetoOptions& options) {
  auto identity = identity_of(study);
  identity.emplace_back("criteria", fmt::format("{}", fmt::join(args.criteria, " ")));
  identity.emplace_back("levels", fmt::format("{}", options.levels));
  identity.emplace_back("max_evaluations", fmt::format("{}", options.max_evaluations));
  return run_header(std::move(identity), inputs_of(study));
}

/// What the report replays: the start, and the point with the least of the first criterion.
report::Scene scene_of(const Study& study, const ParetoResult& result, const Arguments& args, bool recorded) {
  std::vector<report::SceneSet> sets = {{"start", "start", "start/errors.csv"}};
  if (recorded) {
    const RecordOptions how = {study.stepper, args.workers};
    sets = {record_set("start", args.folder, "start", study.scenarios, study.space.start, how)};
    if (!result.front.empty()) {
      sets.push_back(
          record_set("point 1", args.folder, "shown", study.scenarios, result.front.front().e.gains, how));
    }
  }
  return report::scene_of(study.scenarios, std::move(sets), study.space.start.obstacleInfluenceRadius);
}

int run(Arguments args, RankGroup& team) {
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [began] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  Study study = load_inputs(args.resume, [&args] { return load_study(args.study, args.controller); });
  if (args.seed >= 0) study.solver.seed = static_cast<std::uint64_t>(args.seed);
  if (!team.begin(plan_of(study, args.deadline), args.workers)) return kDone;
  const ParetoOptions options = options_of(args, study);
  const bool resumed = !args.resume.empty();
  if (resumed) args.folder = args.resume;
  if (args.folder.empty()) args.folder = default_run_folder("pareto_" + study.name);
  const RunHeader header = header_of(study, args, options);
  FolderLock lock;
  require_recording_memory(study.scenarios, SimulateOptions().record_stride, args.workers);
  if (!resumed) lock = make_run_folder(args.folder);
  const auto journal = open_journal(args.folder, args.resume, header, files_of(study));
  if (journal->exit_code()) {
    say(fmt::format("{}: this run is finished; there is nothing to resume\n", args.folder));
    return *journal->exit_code();
  }
  const double before = journal->seconds();  // of the sessions of a run that goes on
  warn_of_clamped(study);
  CandidateRunner workers(team.pool(), study.robust);
  std::optional<EvaluationsFile> evaluations;
  std::optional<Objective> objective;
  ProgressLine line;
  ParetoCallbacks callbacks;
  double last_seconds = 0.0;
  callbacks.begin = [&](const Objective& o) {
    objective = o;
    say(fmt::format("front of {}: {}; {} gains over {} scenarios, {} at most; results go to {}\n", study.name,
                    fmt::join(args.criteria, " against "), study.space.free.size(), study.scenarios.size(),
                    budget_text(options.max_evaluations, study.max_minutes), args.folder));
    if (resumed) say(fmt::format("goes on after {} finished evaluations\n", journal->records()));
    std::fflush(stdout);
    make_folder(args.folder + "/start");
    write_text_file(args.folder + "/start/gains.yaml",
                    gains_yaml(study.space.start, {"start of " + shown_path(study.source)}));
    write_text_file(args.folder + "/study.yaml",
                    study_yaml(study, "start/gains.yaml", write_warm(study, args.folder)));
    write_scene(args.folder, scene_of(study, {}, args, false));
    evaluations.emplace(args.folder + "/evaluations.csv", study, criteria_columns(study, options),
                        AppendFile::Open::kReplace);
  };
  callbacks.evaluated = [&](const char* phase, const Evaluation& e) {
    evaluations->append(phase, e);
    last_seconds = e.seconds;
  };
  callbacks.progress = [&](const ParetoProgress& p) {
    const double left = seconds_left(p.evaluations, p.max_evaluations, last_seconds, study.max_minutes);
    line.show(fmt::format("{}/{}  {} points  {:.0f} s left  {}", p.evaluations, p.max_evaluations, p.front,
                          left, p.phase));
  };
  ParetoResult result;
  bool verified = false;
  try {
    result = pareto(study, options, workers, stop_requested(), callbacks, journal.get());
    if (evaluations) evaluations->finish();
    line.clear();
    // First as the search saw it: whatever becomes of the rest, the front is there.
    if (!result.front.empty()) write_front(study, options, result, args.folder);
    if (result.failure) std::rethrow_exception(result.failure);
    if (result.evaluations > 0 && !result.interrupted) {
      line.show(fmt::format("fresh rollouts of {} points", result.front.size()));
      CandidateRunner fresh(team.pool(), study.robust);
      verified = verify(study, *objective, options, result, fresh, stop_requested());
      line.clear();
    }
    if (result.evaluations > 0) write_front(study, options, result, args.folder);
  } catch (...) {
    if (!resumed && !objective) discard_run(args.folder);
    if (objective) tell_how_to_go_on("pareto", args.folder);
    throw;
  }
  if (result.evaluations == 0) {
    if (!resumed) discard_run(args.folder);
    fmt::print(stderr, "interrupted before the start gains were simulated; nothing to report\n");
    return kInterrupted;
  }
  write_text_file(
      args.folder + "/columns.csv",
      columns_csv({{"pareto.csv", pareto_columns(study, options)},
                   {"evaluations.csv", evaluation_columns(study, criteria_columns(study, options))}}));
  const Provenance p = study_provenance(
      study, workers.count(), before + seconds(),
      {{"criteria", fmt::format("{}", fmt::join(args.criteria, " "))},
       {"evaluations", fmt::format("{}", result.evaluations)},
       {"stepper", name(study.stepper)},
       {"engine",
        study.engine == Engine::kSimbody ? "simbody" : fmt::format("{}, then simbody", name(study.engine))},
       {"ended", result.interrupted   ? "interrupted"
                 : result.out_of_time ? "time used up"
                                      : "every level searched"},
       {"points", fmt::format("{}", result.front.size())},
       {"verified", verified ? "true" : "false"},
       {"hypervolume", fmt::format("{}", result.hypervolume)}});
  write_provenance(args.folder, p);

  const std::string report = add_report(args.folder, [&] { return scene_of(study, result, args, verified); });
  say(pareto_table(study, options, result));
  say(fmt::format(
      "{}{}\nwrote {} in {:.0f} s: pareto.csv, points/, evaluations.csv, columns.csv, study.yaml, "
      "run.yaml{}{}\n",
      result.out_of_time
          ? fmt::format(
                "time used up after {} evaluations: levels may have been left out or be searched short\n",
                result.evaluations)
          : "",
      !verified ? "interrupted: the points were not simulated again"
      : study.engine == Engine::kSimbody
          ? "every point was simulated again, with the same figures"
          : "every point was simulated again, by simbody: these are its figures",
      args.folder, seconds(), verified ? "; recordings for the report in start/ and shown/" : "", report));
  if (!verified) {
    say(fmt::format("to go on: {} pareto --resume {}\n", program_name(), args.folder));
    return kInterrupted;
  }
  const int exit_code = result.front.empty() ? kChecksFailed : kDone;
  journal->complete(exit_code);
  return exit_code;
}

}  // namespace

void add_pareto_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("pareto", "Find a study's front: what each bit of accuracy costs in joint velocity");
  command->add_option("STUDY", args->study, "a bundled study or a YAML file of your own")
      ->capture_default_str();
  add_controller_option(*command, args->controller);
  command
      ->add_option("--criteria", args->criteria,
                   "two or three of: 'objective' (the study's) and any metric (its worst over the scenarios)")
      ->expected(2, 3)
      ->capture_default_str();
  command
      ->add_option(
          "--levels", args->levels,
          "levels of each criterion but the first, each searched twice (default: 12, with three criteria 4)")
      ->check(CLI::Range(2, 1000));
  command->add_option("--max-evaluations", args->max_evaluations, "budget (default: four times the study's)")
      ->check(CLI::Range(1L, 1000000000L));
  command->add_option("--seed", args->seed, "of algorithms that draw random numbers (default: the study's)")
      ->check(CLI::Range(0L, 1000000000000L));
  command->add_option("--out", args->folder, "new folder (default: runs/pareto_<study>_<time>)");
  command->add_option("--resume", args->resume, kResumeHelp);
  command->add_option("--workers", args->workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->add_option("--rollout-deadline", args->deadline, kDeadlineHelp)->check(CLI::PositiveNumber);
  command->footer(
      "The study's constraints hold for every point. Of its search, global, global_share, algorithm and "
      "constraints are "
      "taken for the least of the first criterion, steps, engine and seed for all; sweep, starts and "
      "verify_share are "
      "tune's. The points of the front are simulated again "
      "at "
      "the end, beyond the evaluations allowed. The front ends where a criterion cannot fall further "
      "without "
      "another one being worse than with the start gains.\n\nExample:\n  armtune pareto ur10_gaze --criteria "
      "gaze/rms joint_velocity/max_ratio effort_rate/rms --levels 5\n");
  command->callback([args, &exit_code] { exit_code = run(*args, team()); });
}

}  // namespace armtune::cli
