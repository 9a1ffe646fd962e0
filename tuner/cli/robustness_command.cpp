// armtune robustness: how many arms that differ from the model keep their limits under a gain set.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>

#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/gain_set.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/named_choice.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/report_file.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/rollouts/simulate.hpp"
#include "tuner/run/append_file.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/samples/statistics.hpp"
#include "tuner/verdict/yield_check.hpp"

namespace armtune::cli {
namespace {

struct Arguments {
  std::string set;
  std::vector<std::string> scenarios;
  std::vector<std::string> limits;
  std::string folder;
  std::string resume;  ///< the folder of the run to go on with
  std::string stepper = "midpoint";
  long only = -1;
  long seed = 1;
  double deadline = 0.0;
  bool payload_given = false;
  MonteCarloOptions options;
};

void print_yield(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples,
                 const std::vector<MetricLimit>& limits) {
  const auto kept = static_cast<std::size_t>(
      std::count_if(samples.begin(), samples.end(), [](const MonteCarloSample& s) { return s.keeps_all(); }));
  const auto [low, high] = wilson_interval(kept, samples.size());
  say(fmt::format("{:.1f} % of {} arms keep every limit (95 % confidence: {:.1f} .. {:.1f} %):\n",
                  100.0 * static_cast<double>(kept) / static_cast<double>(samples.size()), samples.size(),
                  100.0 * low, 100.0 * high));
  for (const MetricLimit& limit : limits) say(fmt::format("  {}\n", to_string(limit)));
  say(fmt::format("  torque saturated in at most {:.0f} % of the periods\n", 100.0 * kSaturatedShare));
  std::map<std::pair<std::string, std::string>, std::vector<std::uint64_t>> breaks;
  for (const MonteCarloSample& sample : samples) {
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      if (!sample.broken[s].empty()) breaks[{scenarios[s].name, sample.broken[s]}].push_back(sample.number);
    }
  }
  constexpr std::size_t kShown = 8;
  for (const auto& [what, numbers] : breaks) {
    say(fmt::format(
        "{}: {} of {} break '{}': samples {}{}\n", what.first, numbers.size(), samples.size(), what.second,
        fmt::join(numbers.begin(),
                  numbers.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, numbers.size())), " "),
        numbers.size() > kShown ? " ..." : ""));
  }
}

void print_spreads(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples) {
  const auto& headline = headline_metrics();
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    say(fmt::format("\n{:<36}{:>12}{:>12}{:>12}{:>12}{:>10}\n", scenarios[s].name, "median", "95 %", "99 %",
                    "worst", "sample"));
    for (const MetricSpread& spread : spreads(samples, s)) {
      if (std::find(headline.begin(), headline.end(), spread.metric) == headline.end()) continue;
      const MetricField& f = field(spread.metric);
      say(fmt::format("{:<36}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}{:>10}\n",
                      fmt::format("  {} [{}]", f.name, f.unit), spread.median, spread.p95, spread.p99,
                      spread.worst, spread.worst_sample));
    }
  }
}

RunHeader header_of(const std::vector<Scenario>& scenarios, const Gains& gains,
                    const MonteCarloOptions& options) {
  std::vector<std::string> inputs;
  add_inputs(scenarios, inputs);
  std::string uncertainty;
  for (const PerturbationField& f : perturbation_fields()) {
    uncertainty += fmt::format("{}: {}\n", f.name, options.perturbation.*f.width);
  }
  uncertainty += fmt::format("phases: {}\n", options.perturbation.phases);
  std::string names;  // a record's results are in their order
  for (const Scenario& scenario : scenarios) names += scenario.name + '\n';
  std::string limits;
  for (const MetricLimit& limit : options.limits) limits += to_string(limit) + '\n';
  return run_header({{"seed", fmt::format("{}", options.seed)},
                     {"samples", fmt::format("{}", options.samples)},
                     {"scenarios", names},
                     {"uncertainty", uncertainty},
                     {"limits", limits},
                     {"stepper", name(options.stepper)},
                     {"gains", gains_yaml(gains, {})}},
                    inputs);
}

int run(Arguments args, RankGroup& team) {
  MonteCarloOptions& options = args.options;
  options.stepper = stepper_from_name(args.stepper);
  options.seed = static_cast<std::uint64_t>(args.seed);
  options.limits = parse_limits(args.limits);
  if (args.only >= 0) {
    options.first = static_cast<std::uint64_t>(args.only);
    options.samples = 1;
  }
  // Unless others are asked for: the ones that come near limits.
  const std::vector<Scenario> scenarios = load_inputs(args.resume, [&args] {
    return scenarios_of(args.set, args.scenarios, {"realistic_target_switch", "realistic_obstacle_pass"});
  });
  if (!args.payload_given) {
    options.perturbation.payload = default_perturbation(scenarios).payload;
  }
  const GainSet set = load_inputs(args.resume, [&] { return load_gain_set(args.set, scenarios); });
  std::vector<std::string> inputs = {set.path};
  add_inputs(scenarios, inputs);
  RolloutPlan plan = monte_carlo_plan(scenarios, options);
  plan.deadline = args.deadline;
  plan.facts = {{"gains", hash_of_input(set.path)}};
  if (!team.begin(std::move(plan), options.workers)) return kDone;
  const auto pool = team.pool();
  const bool resumed = !args.resume.empty();
  if (resumed) args.folder = args.resume;
  if (args.folder.empty() && args.only < 0) args.folder = default_run_folder("robustness");
  FolderLock lock;
  std::unique_ptr<Journal> journal;
  if (!args.folder.empty()) {
    const RunHeader header = header_of(scenarios, set.gains, options);
    require_recording_memory(scenarios, SimulateOptions().record_stride, options.workers);
    if (!resumed) lock = make_run_folder(args.folder);
    journal = open_journal(args.folder, args.resume, header, inputs);
    if (journal->exit_code()) {
      say(fmt::format("{}: this run is finished; there is nothing to resume\n", args.folder));
      return *journal->exit_code();
    }
    if (resumed) say(fmt::format("goes on after {} finished samples\n", journal->records()));
    options.known = [&journal](std::uint64_t number) {
      auto record = journal->find(number);
      return record ? std::optional(std::move(record->results)) : std::nullopt;
    };
  }

  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [began] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  const double before = journal ? journal->seconds() : 0.0;  // of the sessions of a run that goes on
  ProgressLine line;
  options.progress = [&](std::size_t done, std::size_t all) {
    line.show(fmt::format("{} of {} rollouts, {:.0f} s left", done, all,
                          seconds() / static_cast<double>(done) * static_cast<double>(all - done)));
  };
  std::optional<AppendFile> rows;
  if (!args.folder.empty()) {
    rows.emplace(args.folder + "/samples.csv", AppendFile::Open::kReplace);
    rows->append(samples_header(), false);
    options.finished = [&](const MonteCarloSample& sample) {
      rows->append(sample_rows(scenarios, sample), false);
    };
    options.whole = [&](const MonteCarloSample& sample) {
      journal->append({sample.number, "sample", before + seconds(), {}, sample.results});
      rows->publish();
    };
  }
  std::vector<MonteCarloSample> samples;
  try {
    samples = monte_carlo(*pool, set.gains, options, stop_requested());
  } catch (...) {
    if (journal) tell_how_to_go_on("robustness", args.folder);
    throw;
  }
  // Interrupted, those before the first gap: what samples.csv holds.
  samples.resize(
      static_cast<std::size_t>(std::find_if(samples.begin(), samples.end(),
                                            [&, next = options.first](const MonteCarloSample& s) mutable {
                                              return s.number != next++;
                                            }) -
                               samples.begin()));
  line.clear();
  if (rows) {
    rows->publish();
    rows->sync();
  }
  SimulationVerdict verdict;
  if (!samples.empty() && !stop_requested()) verdict = yield_verdict(scenarios, samples, options);
  std::string wrote;
  if (!args.folder.empty()) {
    write_text_file(args.folder + "/summary.csv", summary_csv(scenarios, samples));
    Provenance p;
    p.command = command_line();
    p.inputs = inputs;
    p.seed = options.seed;
    p.workers = pool->count();
    p.wall_seconds = before + seconds();
    std::vector<std::string> limits;
    for (const MetricLimit& limit : options.limits) limits.push_back(to_string(limit));
    p.extra = {{"samples", fmt::format("{}", samples.size())},
               {"stepper", args.stepper},
               {"limits", fmt::format("{}", fmt::join(limits, "; "))}};
    write_provenance(args.folder, p);
    if (!verdict.checks.empty()) write_verdict(args.folder, verdict);
    const bool recorded = !stop_requested();
    const std::string report = add_report(args.folder, [&] {
      const std::string label = stem(set.path);
      report::SceneSet nominal = {label, "nominal", "nominal/errors.csv"};
      if (recorded) {
        nominal = record_set(label, args.folder, "nominal", scenarios, set.gains,
                             {options.stepper, options.workers});
      }
      return report::scene_of(scenarios, {nominal}, set.gains.obstacleInfluenceRadius);
    });
    wrote = fmt::format("\nwrote {}: samples.csv, summary.csv, run.yaml, inputs/{}{}{}\n", args.folder,
                        verdict.checks.empty() ? "" : ", verdict.yaml", report,
                        recorded ? "; the arm of the scenarios itself in nominal/" : "");
  }
  if (!samples.empty()) {
    print_yield(scenarios, samples, options.limits);
    print_spreads(scenarios, samples);
  }
  say(wrote);
  if (stop_requested()) {
    if (!args.folder.empty())
      say(fmt::format("interrupted; to go on: {} robustness --resume {}\n", program_name(), args.folder));
    return kInterrupted;
  }
  const int exit_code = conclude(verdict);
  if (journal) journal->complete(exit_code);
  return exit_code;
}

}  // namespace

void add_robustness_command(CLI::App& app, int& exit_code) {
  auto args = std::make_shared<Arguments>();
  args->options.workers = default_workers();
  Perturbation& p = args->options.perturbation;
  CLI::App* command = app.add_subcommand(
      "robustness", "Simulate gains on many arms that differ at random from the model: yield and quantiles");
  command->add_option("RUN_OR_GAINS", args->set, "a run folder, bundled gains or a YAML file")->required();
  command->add_option(
      "--scenarios", args->scenarios,
      "what every arm does; unless given, the run's study says, or realistic_target_switch and "
      "realistic_obstacle_pass");
  command->add_option("--samples", args->options.samples, "how many arms")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--seed", args->seed, "of the draws")
      ->check(CLI::Range(0L, 1000000000000L))
      ->capture_default_str();
  command->add_option("--sample", args->only, "only this one, the same to the byte as among the others")
      ->check(CLI::Range(0L, 1000000000L));
  command->add_option(
      "--limit", args->limits,
      "METRIC<=VALUE or METRIC>=VALUE, as often as there are limits; unless given, joint "
      "velocities and positions inside the arm's own, and no obstacle touched, which the first "
      "--limit replaces");
  CLI::Option* payload = nullptr;
  for (const PerturbationField& f : perturbation_fields()) {
    std::string option = fmt::format("--{}", f.name);
    std::replace(option.begin(), option.end(), '_', '-');
    CLI::Option* width = command->add_option(option, p.*f.width, fmt::format("{} [{}]", f.meaning, f.unit))
                             ->capture_default_str()
                             ->group("Uncertainty (uniform)");
    if (f.width == &Perturbation::payload)
      payload = width->default_str("three times the scenarios' heaviest");
  }
  command->add_flag("!--fixed-phases", p.phases, "targets and obstacles start where the scenario says")
      ->group("Uncertainty (uniform)");
  add_stepper_option(*command, args->stepper);
  command->add_option(
      "--out", args->folder,
      "new folder for samples.csv, summary.csv, verdict.yaml, run.yaml and report.html (default: "
      "runs/robustness_<time>; with --sample none)");
  command->add_option("--resume", args->resume, kResumeHelp);
  command->add_option("--workers", args->options.workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->add_option("--rollout-deadline", args->deadline, kDeadlineHelp)->check(CLI::PositiveNumber);
  command->footer(
      "Example:\n  armtune robustness extended_tuned --scenarios identified_realistic_target_switch "
      "--limit 'joint_velocity/max_ratio<=0.9'\n");
  command->callback([args, payload, &exit_code] {
    args->payload_given = payload->count() > 0;
    exit_code = run(*args, team());
  });
}

}  // namespace armtune::cli
