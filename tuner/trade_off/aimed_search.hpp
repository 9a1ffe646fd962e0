#pragma once
// Searches for single points of a Pareto front. Each search minimises one criterion and sets upper limits for
// the others. A gain set that one search has simulated is not simulated again for another.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/solver/together.hpp"
#include "tuner/trade_off/archive.hpp"

namespace armtune::internal {

/// The task of one search: minimise criterion k with all others at most `levels` (infinite: no limit).
struct Aim {
  std::size_t k = 0;
  Costs levels;
  std::vector<double> x;  ///< start of the search
  long budget = 0;        ///< evaluations
  SolverOptions solver;
};

class AimedSearch {
 public:
  /// All arguments but the journal, which may be null, must outlive the search. callbacks: as in pareto().
  AimedSearch(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
              const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal);

  /// Simulates the start, and the start of a warm start if there is one. Returns false if the run was
  /// interrupted. Throws InputError if a criterion of the start cannot be a reference.
  bool start();
  /// Searches for all aims at once, or for none if the run was interrupted. shown: text for the progress.
  void minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims);

  /// Returns every feasible point that no other dominates.
  const Archive& archive() const { return archive_; }
  /// Returns the best of all points in the study's own order. If no point is feasible, it is the one that
  /// comes nearest to the constraints.
  const Evaluation& best() const { return *best_; }
  /// Returns the start, the number of evaluations and whether the run was interrupted; no front or levels.
  const ParetoResult& so_far() const { return out_; }

 private:
  struct Known {
    SolverValue value;  ///< the study's objective and constraints
    Costs costs;
  };

  /// Simulates candidates and stores them in order. Returns false if the run was interrupted.
  bool evaluate(const std::vector<Candidate>& candidates);
  void take_in(const char* phase, Evaluation e);
  void serve(const char* phase, const std::vector<Aim>& aims, std::vector<long>& left,
             std::vector<Request>& requests);
  SolverValue seen_from(const Aim& aim, const Known& known) const;
  void check_reference(const Costs& start) const;

  const Study& study_;
  const ParetoOptions& options_;
  const ParetoCallbacks& callbacks_;
  Evaluator evaluator_;
  WarmPoint box_;  ///< empty without a warm start
  std::optional<Objective> objective_;
  std::map<std::vector<double>, Known> known_;
  Archive archive_;
  std::optional<Evaluation> best_;
  ParetoResult out_;
  std::string shown_;
};

}  // namespace armtune::internal
