#include "armtune/evaluate.hpp"

#include <fmt/format.h>

#include <atomic>
#include <utility>

#include "armtune/error.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/interface/tune_point.hpp"
#include "tuner/study/objective.hpp"

namespace armtune {

struct Evaluator::Inside {
  Inside(const Study& given, const EvaluatorOptions& options)
      : study(given),
        engine(options.engine ? internal_of(*options.engine) : given.inside().engine),
        workers(std::make_unique<internal::RolloutPool>(internal::plan_of(given.inside(), options.deadline),
                                                        options.workers),
                given.inside().robust) {}

  void require(const std::vector<double>& point) const {
    const std::size_t count = study.inside().space.free.size();
    if (point.size() != count)
      throw InputError(InputPlace{.key = "point"},
                       fmt::format("it has {} coordinates; the study {} has {} parameters", point.size(),
                                   study.name(), count))
          .with_value(std::to_string(point.size()), fmt::format("{} coordinates", count));
    for (const double x : point) {
      if (!(x >= 0.0 && x <= 1.0))
        throw InputError(InputPlace{.key = "point"},
                         fmt::format("a coordinate of the point is {}; all must lie between 0 and 1", x))
            .with_value(fmt::to_string(x), "0 to 1");
    }
  }

  std::optional<std::vector<internal::Evaluation>> simulate(const std::vector<std::vector<double>>& points,
                                                            const std::vector<internal::EndLimits>& limits,
                                                            const Watch& watch) {
    const std::atomic<bool> never{false};
    long done = 0;
    return internal::simulate_points(
        study.inside(), points, workers, watch.stop != nullptr ? *watch.stop : never, {engine, limits},
        [&](std::size_t, const internal::Evaluation&) {
          if (watch.progress)
            watch.progress({"evaluations", ++done, static_cast<long>(points.size()), NAN, {}});
        });
  }

  Study study;
  internal::Engine engine;
  internal::CandidateRunner workers;
  std::optional<internal::Objective> objective;
  TunePoint start;
};

Evaluator::Evaluator(const Study& study, const EvaluatorOptions& options, const Watch& watch) {
  require_workers(options.workers);
  inside_ = std::make_unique<Inside>(study, options);
  const internal::Study& inside = inside_->study.inside();
  auto reference = inside_->simulate({inside.space.start_point()}, {}, watch);
  if (!reference) throw FailedError("the evaluation of the start gains was stopped");
  internal::Evaluation& start = reference->front();
  inside_->objective.emplace(inside.terms, inside.constraints, internal::simulated_scenarios(inside),
                             start.results, internal::where(inside), inside.own_objective);
  inside_->objective->judge(start);
  inside_->start = tune_point(start);
}

Evaluator::Evaluator(Evaluator&&) noexcept = default;
Evaluator& Evaluator::operator=(Evaluator&&) noexcept = default;
Evaluator::~Evaluator() = default;

const TunePoint& Evaluator::start() const {
  return inside_->start;
}

std::vector<TunePoint> Evaluator::evaluate(const std::vector<std::vector<double>>& points,
                                           const Watch& watch) {
  for (const std::vector<double>& point : points) inside_->require(point);
  auto evaluations = inside_->simulate(points, inside_->objective->end_limits(), watch);
  std::vector<TunePoint> judged;
  if (!evaluations) return judged;
  judged.reserve(points.size());
  for (internal::Evaluation& evaluation : *evaluations) {
    inside_->objective->judge(evaluation);
    judged.push_back(tune_point(evaluation));
  }
  return judged;
}

Gains Evaluator::gains_at(const std::vector<double>& point) const {
  inside_->require(point);
  return Gains(inside_->study.inside().space.gains_at(point), inside_->study.start().joints());
}

double Evaluator::simulated() const {
  return inside_->workers.simulated();
}

}  // namespace armtune
