#pragma once
// Searches for single points of a Pareto front (pareto.hpp). Each search minimises one criterion, with upper
// limits on the others. A gain set that one search has simulated is not simulated again for another search.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/solver/together.hpp"
#include "tuner/trade_off/archive.hpp"

namespace armtune::internal {

/// The task of one search: minimise criterion k while the costs of all criteria stay at or below `levels`.
struct Aim {
  std::size_t k = 0;      ///< index of the criterion that is minimised
  Costs levels;           ///< upper limits of the costs, one per criterion; infinite: no limit
  std::vector<double> x;  ///< search coordinates where the search starts
  long budget = 0;        ///< largest number of evaluations
  SolverOptions solver;
};

class AimedSearch {
 public:
  /// All arguments must outlive the search. callbacks: as in pareto(); journal: may be null.
  AimedSearch(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
              const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal);

  /// Simulates the start gains and, if the study has a warm start, the gains of the warm start. Returns false
  /// if the run was interrupted. Throws InputError if a criterion is not finite, or is zero, with the start
  /// gains.
  bool start();
  /// Runs the searches for all aims at the same time. Does nothing if the run was interrupted. shown: text
  /// that names these searches in the progress display.
  void minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims);

  /// Returns the archive. It contains every feasible point that no other one dominates.
  const Archive& archive() const { return archive_; }
  /// Returns the best of all points, compared by better() (evaluation.hpp). If no point is feasible, this is
  /// the point with the smallest violation of the constraints.
  const Evaluation& best() const { return *best_; }
  /// Returns a result without front and levels. It contains the evaluation of the start gains, the number of
  /// evaluations, and whether the run was interrupted or ran out of time.
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
  WarmPoint box_;  ///< bounds of the search; empty without a warm start
  std::optional<Objective> objective_;
  std::map<std::vector<double>, Known> known_;
  Archive archive_;
  std::optional<Evaluation> best_;
  ParetoResult out_;
  std::string shown_;
};

}  // namespace armtune::internal
