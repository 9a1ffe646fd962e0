#pragma once
// The value that the next point of a search would have to beat to make any difference to it.

#include <cmath>
#include <queue>
#include <string>

namespace armtune {

/// Follows a run of an algorithm that only compares values, by those it was told. NLopt's CRS2 and ESCH keep
/// the best 10 (n + 1) and the best 40 they have seen (Kaelo and Ali, JOTA 130, 2006; da Silva Santos,
/// Goncalves and Hernandez-Figueroa, 2010): a value above the worst of these is forgotten at once. It only
/// falls, so it holds for later points too. Others have none: DIRECT and the models use every value, ISRES
/// ranks each generation by itself, and what Nelder-Mead's simplex takes rises again when it shrinks.
class Bar {
 public:
  /// No bar at all.
  Bar() = default;
  Bar(const std::string& algorithm, std::size_t parameters);

  bool exists() const { return size_ > 0; }

  /// The value of the point asked for last, one asked for again included.
  void told(double value);

  /// The search goes on in the same way whatever value above this the next point has. HUGE_VAL: it does not.
  double now() const { return exists() && best_.size() == size_ ? best_.top() : HUGE_VAL; }

 private:
  std::size_t size_ = 0;              ///< of the population; 0: none
  std::priority_queue<double> best_;  ///< the worst of them on top
};

}  // namespace armtune
