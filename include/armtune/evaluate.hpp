#pragma once
// Simulates and scores gains of a study in the same way as the study's search. Use this to replace the search
// by an optimiser of your own.

#include <memory>
#include <optional>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/study.hpp"
#include "armtune/tune.hpp"

namespace armtune {

struct EvaluatorOptions {
  /// Engine of all evaluations. Empty: the engine in which the study searches. If that is the native engine,
  /// the study's own search still judges its best gains with Simbody.
  std::optional<Engine> engine = std::nullopt;
  int workers = 1;        ///< threads; results do not depend on it
  double deadline = 0.0;  ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
};

/// Evaluates points of a study. An Evaluator can be moved, but not copied. A moved-from Evaluator may only be
/// destroyed or assigned to. Use an Evaluator from one thread at a time.
class Evaluator {
 public:
  /// Simulates the start gains, whose objective is 1. Throws InputError if they cannot serve as a reference,
  /// for example because a scenario does not complete, and FailedError if `watch` stopped it.
  explicit Evaluator(const Study& study, const EvaluatorOptions& options = {}, const Watch& watch = {});
  Evaluator(Evaluator&& other) noexcept;
  Evaluator& operator=(Evaluator&& other) noexcept;
  ~Evaluator();

  /// Returns the evaluation of the start gains.
  const TunePoint& start() const;

  /// Returns one evaluation for each point, in order. points: one coordinate for each of Study::parameters,
  /// 0 at the lower bound of its gain and 1 at the upper bound. As in the search, the rollout of a point that
  /// breaks a constraint by far may end early. Returns an empty vector if `watch` stopped it. Throws
  /// InputError if a point has another number of coordinates, or a coordinate outside 0 to 1.
  std::vector<TunePoint> evaluate(const std::vector<std::vector<double>>& points, const Watch& watch = {});

  /// Returns the gains at a point. Throws as evaluate() does.
  Gains gains_at(const std::vector<double>& point) const;

  /// Returns the simulated time of all rollouts so far [s].
  double simulated() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace armtune
