// armtune compare: gain sets side by side over the same scenarios.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "core/common/error.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/joint_values.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/endurance_option.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/report_file.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/set_labels.hpp"
#include "tuner/cli/task_notes.hpp"
#include "tuner/gains/gains_difference.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/study/study.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::vector<std::string> sets;
  std::vector<std::string> scenarios;
  std::string stepper = "midpoint";
  std::string folder;
  int workers = default_workers();
  bool all_metrics = false;
  bool gains_only = false;
  double deadline = 0.0;
  double endurance = 0.0;  ///< minutes; 0: none
  std::string robot;       ///< of --gains alone
};

/// Those asked for; else those of the first run folder's study; else those of the bundled study.
std::vector<Scenario> scenarios_of(const Arguments& args) {
  const auto run = std::find_if(args.sets.begin(), args.sets.end(), [](const std::string& set) {
    std::error_code ignored;
    return fs::exists(fs::path(set) / "study.yaml", ignored);
  });
  if (args.scenarios.empty() && run == args.sets.end()) return load_study("ur10_gaze").scenarios;
  return cli::scenarios_of(run == args.sets.end() ? std::string() : *run, args.scenarios, {});
}

/// Below the run's folder: where a set's gains and recordings are.
std::string recordings_of(const std::string& label) {
  return "rollouts_" + label;
}

/// A comparison is whole or nothing.
void take_away(const std::string& folder, const std::vector<ComparedSet>& sets) {
  std::error_code ignored;
  for (const ComparedSet& set : sets) fs::remove_all(folder + "/" + recordings_of(set.name), ignored);
}

report::Scene scene_of(const std::vector<Scenario>& scenarios, const std::vector<ComparedSet>& sets,
                       const Arguments& args) {
  const auto joints = joint_names(*scenarios.front().robot);
  std::vector<report::SceneSet> shown;
  shown.reserve(sets.size());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const std::string below = recordings_of(sets[i].name);
    write_text_file(args.folder + "/" + below + "/gains.yaml",
                    gains_yaml(load_gains(gains_name(args.sets[i]), joints), {"from " + sets[i].name}));
    shown.push_back({sets[i].name, below, "errors_" + sets[i].name + ".csv"});
  }
  return report::scene_of(scenarios, std::move(shown),
                          load_gains(gains_name(args.sets.front()), joints).obstacleInfluenceRadius);
}

int show_gains(const Arguments& args) {
  if (args.sets.size() < 2) throw InputError("--gains: shows what differs between sets; name two or more");
  const std::vector<std::string> labels = set_labels(args.sets);
  const auto joints =
      joint_names(args.robot.empty() ? *scenarios_of(args).front().robot : *load_robot(args.robot));
  std::vector<NamedGains> sets;
  for (std::size_t i = 0; i < args.sets.size(); ++i) {
    try {
      sets.push_back({labels[i], load_gains(gains_name(args.sets[i]), joints)});
    } catch (const yaml::OtherJoints& e) {
      if (!args.robot.empty()) throw;
      throw InputError(fmt::format("{}; read for an arm of {} joints: name another with --robot", e.what(),
                                   joints.size()));
    }
  }
  say(gains_difference(sets, joints));
  return kDone;
}

/// Checks all gain sets together: each failure names the set that it belongs to. told: gets what is to be
/// printed of the extended scenarios.
SimulationVerdict verdict_of(const Arguments& args, const std::vector<Scenario>& scenarios,
                             const std::vector<ComparedSet>& sets, std::string& told) {
  SimulationVerdict verdict;
  bool extended = args.endurance > 0.0;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    add_rollout_checks(sets[i].results, sets[i].name, verdict);
    add_contact_check(scenarios, sets[i].results, sets[i].name, verdict);
    if (!extended || stop_requested()) {
      extended = false;
      continue;
    }
    const auto endured = run_endurance(
        scenarios,
        [&](const Scenario& s) { return load_gains(gains_name(args.sets[i]), joint_names(*s.robot)); },
        {args.endurance, stepper_from_name(args.stepper), args.workers, {}}, sets[i].name);
    told += fmt::format("{}, every scenario extended to at least {:.4g} minutes:\n{}\n", sets[i].name,
                        args.endurance, endurance_table(endured));
    extended = endured.size() == scenarios.size();
    if (!extended) continue;
    add_endurance_checks(endured, VerdictThresholds(), sets[i].name, verdict);
  }
  add_unchecked(extended, verdict);
  add_assumptions(scenarios, stepper_from_name(args.stepper), verdict);
  return verdict;
}

void write_files(const Arguments& args, const std::vector<Scenario>& scenarios,
                 const std::vector<ComparedSet>& sets) {
  write_text_file(args.folder + "/comparison.csv", comparison_csv(sets));
  for (const ComparedSet& set : sets) {
    write_text_file(args.folder + "/errors_" + set.name + ".csv", errors_csv(set.results));
  }
  Provenance p;
  p.command = command_line();
  for (const std::string& set : args.sets) p.inputs.push_back(find_data_file("gains", gains_name(set)));
  add_inputs(scenarios, p.inputs);
  p.workers = args.workers;
  write_provenance(args.folder, p);
}

int interrupted(const Arguments& args, const std::vector<ComparedSet>& sets) {
  if (!args.folder.empty()) take_away(args.folder, sets);
  fmt::print(stderr, "interrupted: a comparison is whole or nothing, so nothing was written\n");
  return kInterrupted;
}

int run(const Arguments& args) {
  if (args.gains_only) return show_gains(args);
  const std::vector<std::string> labels = set_labels(args.sets);
  if (!args.folder.empty()) check_labels(labels, args.sets);
  const auto scenarios = scenarios_of(args);
  for (const std::string& set : args.sets) {
    for (const Scenario& s : scenarios) {
      refuse_winding(s, load_gains(gains_name(set), joint_names(*s.robot)));
    }
  }
  SimulateOptions options;
  if (!args.folder.empty()) require_recording_memory(scenarios, options.record_stride, args.workers);
  const FolderLock lock = make_run_folder(args.folder);
  options.stepper = stepper_from_name(args.stepper);
  options.workers = args.workers;
  options.deadline = args.deadline;
  ProgressLine line;
  std::vector<ComparedSet> sets;
  for (std::size_t i = 0; i < args.sets.size(); ++i) {
    const std::string& set = args.sets[i];
    const std::string& label = labels[i];
    options.progress = [&](std::size_t done) {
      line.show(fmt::format("{}: {} of {} scenarios", label, done, scenarios.size()));
    };
    if (!args.folder.empty()) {
      options.folder = args.folder + "/" + recordings_of(label);
      make_folder(options.folder);
    }
    sets.push_back(
        {label,
         simulate(
             scenarios, [&](const Scenario& s) { return load_gains(gains_name(set), joint_names(*s.robot)); },
             options, stop_requested())});
    if (stop_requested()) {
      line.clear();
      return interrupted(args, sets);
    }
  }
  line.clear();
  if (!args.folder.empty()) write_files(args, scenarios, sets);  // an endurance may take hours
  std::string endured;
  const SimulationVerdict verdict = verdict_of(args, scenarios, sets, endured);
  std::string wrote;
  if (!args.folder.empty()) {
    if (!stop_requested()) write_verdict(args.folder, verdict);
    const std::string report = add_report(args.folder, [&] { return scene_of(scenarios, sets, args); });
    wrote =
        fmt::format("wrote {}: comparison.csv, errors_<set>.csv, rollouts_<set>/, run.yaml, inputs/{}{}\n",
                    args.folder, stop_requested() ? "" : ", verdict.yaml", report);
  }
  say(comparison_table(sets, args.all_metrics ? all_metrics() : headline_metrics()) + endured + wrote);
  if (stop_requested()) {
    say("interrupted: the comparison is whole, but not every scenario was extended, so there is no "
        "verdict\n");
    return kInterrupted;
  }
  return conclude(verdict);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "compare", "Simulate gain sets over the same scenarios: one table, ratios against the first");
  command->add_option("RUN_OR_GAINS", args->sets, "run folders, gains files or bundled gains")->required();
  command->add_option("--scenarios", args->scenarios,
                      "scenarios (default: those of the first run folder's study, else of the bundled one)");
  CLI::Option* stepper = add_stepper_option(*command, args->stepper);
  CLI::Option* workers = command->add_option("--workers", args->workers, "threads")
                             ->check(CLI::Range(1, 1024))
                             ->default_str(kWorkersDefault);
  CLI::Option* deadline = command->add_option("--rollout-deadline", args->deadline, kScenarioDeadlineHelp)
                              ->check(CLI::PositiveNumber);
  CLI::Option* endurance = add_endurance_option(*command, args->endurance);
  CLI::Option* all =
      command->add_flag("--all-metrics", args->all_metrics, "every metric instead of the headlines");
  CLI::Option* folder = command->add_option(
      "--out", args->folder, "new folder for comparison.csv, errors_<set>.csv and report.html");
  CLI::Option* gains = command->add_flag("--gains", args->gains_only,
                                         "the gains that differ, side by side; nothing is simulated");
  for (CLI::Option* of_simulation : {stepper, workers, deadline, endurance, all, folder})
    gains->excludes(of_simulation);
  command
      ->add_option("--robot", args->robot,
                   "with --gains: the arm they are for (default: that of the scenarios)")
      ->needs(gains);
  command->footer([] {
    return std::string("Example:\n  armtune compare published extended_tuned --scenarios fixed_target\n");
  });
  command->callback([args, &exit_code] { exit_code = run(*args); });
}

}  // namespace armtune::cli
