#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/rollout/limit_watch.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/interface/kept_inputs.hpp"
#include "tuner/interface/observing.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/session/simulate_session.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune {

Rollout RolloutMaker::made(internal::ScenarioResult result, Rollout recording) {
  Rollout rollout = std::move(recording);
  rollout.scenario_ = result.scenario;
  rollout.status_ = internal::name(result.result.status);
  rollout.reason_ = result.result.reason;
  for (const internal::Metric metric : internal::all_metrics()) {
    rollout.metrics_[internal::name(metric)] = result.result.metrics[metric];
  }
  rollout.result_ = std::make_shared<const internal::ScenarioResult>(std::move(result));
  return rollout;
}

Rollout RolloutMaker::watched(internal::ScenarioResult result, Rollout recording) {
  std::vector<std::string> broken;
  for (const internal::BrokenLimit& limit : result.broken) broken.push_back(internal::to_string(limit));
  Rollout rollout = made(std::move(result), std::move(recording));
  rollout.broken_limits_ = std::move(broken);
  return rollout;
}

void RolloutMaker::record(Rollout& rollout, internal::Recorder recorder, bool completed) {
  for (const internal::Column& column : recorder.columns()) rollout.columns_.push_back(column.name);
  rollout.values_ = std::move(recorder).rows(completed);
}

const internal::ScenarioResult& RolloutMaker::result_of(const Rollout& rollout) {
  if (rollout.result_ == nullptr) throw InputError("a Rollout is empty; give only results of a simulation");
  return *static_cast<const internal::ScenarioResult*>(rollout.result_.get());
}

internal::Engine internal_of(Engine engine) {
  return engine == Engine::kNative ? internal::Engine::kNative : internal::Engine::kSimbody;
}

std::vector<internal::Scenario> internal_of(const std::vector<Scenario>& scenarios) {
  std::vector<internal::Scenario> all;
  all.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios) all.push_back(scenario.inside());
  return all;
}

void require_fit(const Gains& gains, const std::vector<Scenario>& scenarios) {
  if (scenarios.empty()) throw InputError("scenarios: none are given; give at least one");
  internal::validate(gains.inside(), gains.joints(), "gains");
  for (const Scenario& scenario : scenarios) {
    if (internal::joint_names(*scenario.inside().robot) != gains.joints()) {
      throw InputError(fmt::format(
          "{}: the gains are for an arm with other joints; load gains for the arm of this scenario",
          scenario.name()));
    }
  }
}

void require_workers(int workers) {
  constexpr int kMost = 1024;
  if (workers < 1 || workers > kMost) {
    throw InputError(InputPlace{.key = "workers"},
                     fmt::format("{}; it must lie between 1 and {}", workers, kMost))
        .with_value(std::to_string(workers), fmt::format("1 to {}", kMost));
  }
}

/// Throws InputError if two scenarios have the same name, as internal::simulate does.
static void require_names(const std::vector<Scenario>& scenarios) {
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (scenarios[i].name() == scenarios[k].name()) {
        throw InputError(fmt::format("{}: two scenarios have this name; rename one", scenarios[i].name()));
      }
    }
  }
}

double Rollout::metric(const std::string& name) const {
  const auto found = metrics_.find(name);
  if (found == metrics_.end()) {
    throw InputError(InputPlace{.key = "metric"},
                     fmt::format("{} is not a metric; 'armtune metrics' lists them", internal::shown(name)))
        .with_value(name);
  }
  return found->second;
}

std::vector<double> Rollout::column(const std::string& name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found == columns_.end()) {
    throw InputError(InputPlace{.key = "column"},
                     fmt::format("the recording of {} has no column {}", scenario_, internal::shown(name)))
        .with_value(name);
  }
  std::vector<double> values;
  values.reserve(rows());
  const auto first = static_cast<std::size_t>(found - columns_.begin());
  for (std::size_t at = first; at < values_.size(); at += columns_.size()) values.push_back(values_[at]);
  return values;
}

/// Throws InputError if the recordings cannot be as the options say.
static void require_recording(const SimulateOptions& options) {
  const int least = options.folder.empty() ? 0 : 1;
  if (options.record_every >= least) return;
  const std::string limit = least > 0 ? "at least 1 in a run with a folder" : "not negative";
  throw InputError(
      InputPlace{.key = "record_every"},
      InputFault{fmt::format("{} control periods per row are not possible", options.record_every),
                 std::to_string(options.record_every), limit});
}

Simulated simulate(const std::vector<Scenario>& scenarios, const Gains& gains,
                   const SimulateOptions& options) {
  require_workers(options.workers);
  require_fit(gains, scenarios);
  require_recording(options);
  const KeptInputs inputs(options.folder, files_of(scenarios), "a scenario that was changed");
  internal::RolloutSettings settings;
  settings.folder = options.folder;
  settings.scenarios = internal_of(scenarios);
  settings.stepper = internal::stepper_from_name(options.stepper);
  settings.engine = internal_of(options.engine);
  settings.workers = options.workers;
  settings.record_every = std::max(1, options.record_every);
  settings.deadline = options.deadline > 0.0 ? options.deadline : std::numeric_limits<double>::infinity();
  settings.examine = !options.folder.empty();  // takes a fifth of the time of a short rollout
  std::vector<Rollout> recordings(scenarios.size());
  if (options.record_every > 0) {
    settings.recorded = [&](std::size_t i, internal::Recorder recorder, bool completed) {
      RolloutMaker::record(recordings[i], std::move(recorder), completed);
    };
  }
  Observing<internal::SessionObserver> observer(options.watch);
  const internal::GainsToSimulate set{"gains", "", [&](const internal::Scenario&) { return gains.inside(); }};
  internal::SimulateSession session(std::move(settings), set, context_of(options.watch), observer);
  internal::SimulateOutcome outcome = session.run();

  Simulated simulated;
  simulated.interrupted = outcome.ending == internal::Ending::kInterrupted;
  if (!simulated.interrupted) simulated.verdict = std::move(outcome.verdict);
  simulated.files = std::move(outcome.files);
  for (std::size_t i = 0; i < outcome.results.size(); ++i) {
    simulated.rollouts.push_back(
        RolloutMaker::watched(std::move(outcome.results[i]), std::move(recordings[i])));
  }
  return simulated;
}

std::vector<std::vector<Rollout>> simulate_sets(const std::vector<Scenario>& scenarios,
                                                const std::vector<Gains>& sets,
                                                const SimulateOptions& options) {
  require_workers(options.workers);
  require_names(scenarios);
  if (!options.folder.empty())
    throw InputError(InputPlace{.key = "folder"},
                     "a run folder is for one gain set; simulate each set with a folder of its own");
  std::vector<internal::Gains> candidates;
  for (const Gains& gains : sets) {
    require_fit(gains, scenarios);
    candidates.push_back(gains.inside());
  }
  std::vector<std::vector<Rollout>> all(sets.size());
  internal::RolloutPlan plan =
      internal::plan_of(internal_of(scenarios), internal::stepper_from_name(options.stepper), {});
  plan.deadline = options.deadline;
  internal::CandidateRunner runner(std::make_unique<internal::RolloutPool>(std::move(plan), options.workers),
                                   {});
  long done = 0;
  const auto finished = [&](std::size_t set, const std::vector<internal::RolloutResult>& results) {
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      all[set].push_back(RolloutMaker::made({scenarios[s].name(), results[s]}));
    }
    ++done;
    if (options.watch.progress) options.watch.progress({"gain sets", done, static_cast<long>(sets.size())});
  };
  internal::Conditions conditions;
  conditions.engine = internal_of(options.engine);
  runner.run(candidates, stop_of(options.watch), finished, conditions);
  return all;
}

std::string errors_csv(const std::vector<Rollout>& rollouts) {
  std::vector<internal::ScenarioResult> results;
  results.reserve(rollouts.size());
  for (const Rollout& rollout : rollouts) results.push_back(RolloutMaker::result_of(rollout));
  return internal::errors_csv(results);
}

}  // namespace armtune
