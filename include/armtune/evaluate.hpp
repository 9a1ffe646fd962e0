#pragma once
// Simulates gains of a study as its search does, and judges them in the same way. With it, an optimiser of
// your own can take the place of the search.

#include <memory>
#include <optional>
#include <vector>

#include "armtune/progress.hpp"
#include "armtune/study.hpp"
#include "armtune/tune.hpp"

namespace armtune {

struct EvaluatorOptions {
  /// Engine of all evaluations; empty: the one in which the study searches. The best gains of a search in the
  /// native engine are judged by Simbody.
  std::optional<Engine> engine = std::nullopt;
  int workers = 1;        ///< threads; results do not depend on it
  double deadline = 0.0;  ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
};

/// Evaluates points of a study. May be moved, but not copied; one that was moved from may only be destroyed
/// or assigned to. Use it from one thread at a time.
class Evaluator {
 public:
  /// Simulates the start gains, whose objective is 1. Throws InputError if they cannot serve as a reference,
  /// for example because a scenario does not complete, and FailedError if it was stopped.
  explicit Evaluator(const Study& study, const EvaluatorOptions& options = {}, const Watch& watch = {});
  Evaluator(Evaluator&& other) noexcept;
  Evaluator& operator=(Evaluator&& other) noexcept;
  ~Evaluator();

  /// Returns the evaluation of the start gains.
  const TunePoint& start() const;

  /// Returns one evaluation for each point, in order. points: one coordinate for each of Study::parameters,
  /// 0 at the lower bound of its gain and 1 at the upper bound. As in the search, the rollout of a point that
  /// breaks a constraint by far may end early. Returns nothing if it was stopped. Throws InputError if a
  /// point has another number of coordinates, or a coordinate outside 0 to 1.
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
