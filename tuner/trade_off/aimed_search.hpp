#pragma once
// Searches for single points of a front: one criterion becomes least, the others held. All that is simulated
// for one is known to the next.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/solver/together.hpp"
#include "tuner/trade_off/archive.hpp"

namespace armtune::internal {

/// One search: criterion k becomes least, all others held at or under `levels` (infinite: free).
struct Aim {
  std::size_t k = 0;
  Costs levels;
  std::vector<double> x;  ///< where it begins
  long budget = 0;        ///< evaluations
  SolverOptions solver;
};

class AimedSearch {
 public:
  /// All but the journal, which may be null, must outlive it; callbacks as of pareto().
  AimedSearch(const Study& study, const ParetoOptions& options, CandidateRunner& workers,
              const std::atomic<bool>& stop, const ParetoCallbacks& callbacks, Journal* journal);

  /// Simulates the start and where a warm start begins. False if the run was interrupted. Throws InputError
  /// if a criterion of the start is no reference.
  bool start();
  /// Searches for all aims at once; for none if the run was interrupted. shown: of progress.
  void minimise(const char* phase, const std::string& shown, const std::vector<Aim>& aims);

  /// Every feasible point that no other dominates.
  const Archive& archive() const { return archive_; }
  /// Best of all points by the study's own order: what comes nearest to its constraints where none keeps
  /// them.
  const Evaluation& best() const { return *best_; }
  /// Start, evaluations and whether interrupted; neither front nor levels.
  const ParetoResult& so_far() const { return out_; }

 private:
  struct Known {
    SolverValue value;  ///< of the study
    Costs costs;
  };

  /// Simulates candidates and takes them in, in order. False if the run was interrupted.
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
