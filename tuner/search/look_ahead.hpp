#pragma once
// Which points a search will ask for, whatever the answer to the one it is waiting for.
//
// NLopt asks for one point after the other, though often the next ones do not depend on the answers it waits
// for: the members of a generation, the samples of a first model. The algorithms are deterministic, so one is
// run again over what it was told, then told once that every new point is better than all before and once
// that it is worse. What it asks for in both cases, in the same order, it will most likely ask for in truth.

#include <deque>
#include <map>
#include <vector>

#include "tuner/search/solver.hpp"

namespace armtune {

class LookAhead {
 public:
  using Known = std::map<std::vector<double>, SolverValue>;

  /// Both must outlive it. For algorithms that use no differences.
  LookAhead(const SolverProblem& problem, const SolverOptions& options)
      : problem_(problem), options_(options) {}

  /// Notes what the search was told next. `answered`: an entry of a map that stays.
  void note(const Known::value_type& answered) { history_.push_back(&answered); }

  /// The points to evaluate now that the search asks for x, x itself first; no other is in `known`, and no
  /// more than options.look_ahead. Looks ahead less and less often where it finds nothing, for it takes as
  /// long as the search so far.
  std::vector<std::vector<double>> next(const std::vector<double>& x, const Known& known);

 private:
  std::vector<std::vector<double>> replay(const Known& known, bool better) const;
  std::vector<std::vector<double>> agreed(const Known& known) const;

  const SolverProblem& problem_;
  const SolverOptions& options_;
  std::deque<const Known::value_type*> history_;  ///< in the order asked, repeats included
  std::deque<std::vector<double>> foreseen_;      ///< found, and not handed out yet
  long skip_ = 0;                                 ///< asks left before the next look ahead
  long next_skip_ = 1;
};

}  // namespace armtune
