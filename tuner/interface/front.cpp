#include "armtune/front.hpp"

#include "armtune/error.hpp"
#include "tuner/interface/kept_inputs.hpp"
#include "tuner/interface/observing.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/session/front_session.hpp"

namespace armtune {

Front front(const Study& study, const std::vector<std::string>& criteria, const FrontOptions& options) {
  require_workers(options.workers);
  if (options.max_evaluations < 0) throw InputError("max_evaluations: must not be negative");
  const KeptInputs inputs(options.folder, files_of(study), "the study " + study.name());
  internal::FrontSettings settings;
  settings.place = {options.folder, options.resume};
  settings.criteria = criteria;
  settings.levels = options.levels;
  settings.max_evaluations = options.max_evaluations;
  settings.workers = options.workers;
  settings.deadline = options.deadline;
  Observing<internal::FrontObserver> observer(options.watch);
  internal::RankGroup alone(nullptr);
  internal::FrontSession session(study.inside(), settings, context_of(options.watch), observer);
  const internal::FrontOutcome outcome = session.run(alone).value();
  if (outcome.was_finished)
    throw InputError(InputPlace{options.folder}, "this run is finished; there is nothing to resume");

  const Gains start = study.start();
  const auto point_of = [&](const internal::ParetoPoint& point) {
    FrontPoint given{Gains(point.e.gains, start.joints()), {}};
    for (const internal::Criterion& criterion : outcome.options.criteria) {
      given.values.push_back(internal::value(criterion, point.e, study.inside().scenarios));
    }
    return given;
  };
  const internal::ParetoResult& result = outcome.result;
  Front front{.start = {start, {}}};
  front.interrupted = outcome.ending == internal::Ending::kInterrupted;
  front.files = outcome.files;
  if (result.evaluations == 0) return front;
  front.start = point_of(result.start);
  for (const internal::ParetoPoint& point : result.front) front.points.push_back(point_of(point));
  front.hypervolume = result.hypervolume;
  return front;
}

}  // namespace armtune
