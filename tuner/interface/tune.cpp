#include "armtune/tune.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "tuner/interface/kept_inputs.hpp"
#include "tuner/interface/observing.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/interface/tune_point.hpp"
#include "tuner/session/tune_session.hpp"

namespace armtune {
namespace {

/// An observer that keeps every evaluation.
class Keeping : public Observing<internal::TuneObserver> {
 public:
  using Observing::Observing;
  void evaluated(const internal::Evaluation& e) override { points.push_back(tune_point(e)); }

  std::vector<TunePoint> points;
};

std::vector<Rollout> rollouts_of(const internal::ComparedSet& set) {
  std::vector<Rollout> rollouts;
  for (const internal::ScenarioResult& result : set.results) rollouts.push_back(RolloutMaker::made(result));
  return rollouts;
}

}  // namespace

Tuned tune(const Study& study, const TuneOptions& options) {
  require_workers(options.workers);
  const KeptInputs inputs(options.folder, files_of(study), "the study " + study.name());
  internal::TuneSettings settings;
  settings.place = {options.folder, options.resume};
  settings.workers = options.workers;
  settings.analysis = options.analysis;
  settings.deadline = options.deadline;
  Keeping observer(options.watch);
  internal::RankGroup alone(nullptr);
  internal::TuneSession session(study.inside(), settings, context_of(options.watch), observer);
  const internal::TuneOutcome outcome = session.run(alone).value();
  if (outcome.was_finished)
    throw InputError(InputPlace{options.folder}, "this run is finished; there is nothing to resume");

  const Gains start = study.start();
  const internal::TuneResult& result = outcome.result;
  Tuned tuned{.start = start, .best = start};
  tuned.reason = result.reason;
  tuned.parameters = study.parameters();
  tuned.interrupted = outcome.ending == internal::Ending::kInterrupted;
  tuned.evaluations = std::move(observer.points);
  if (result.evaluations > 0) {
    tuned.best = Gains(result.best.gains, start.joints());
    tuned.objective = result.best.objective;
    tuned.feasible = result.best.feasible;
  }
  if (outcome.sets.size() == 2) {
    tuned.before = rollouts_of(outcome.sets[0]);
    tuned.after = rollouts_of(outcome.sets[1]);
  }
  if (!tuned.interrupted) tuned.verdict = outcome.verdict;
  tuned.files = outcome.files;
  return tuned;
}

}  // namespace armtune
