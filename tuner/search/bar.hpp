#pragma once
// The value that the next point of a search would have to beat to make any difference to it.

#include <cmath>
#include <queue>
#include <string>
#include <vector>

namespace armtune {

/// Follows a run of an algorithm that only compares values, by those it was told. Of NLopt's algorithms:
/// CRS2 and ESCH keep the best 10 (n + 1) and the best 40 they have seen (Kaelo and Ali, JOTA 130, 2006; da
/// Silva Santos, Goncalves and Hernandez-Figueroa, 2010), so a value above the worst of these is forgotten at
/// once. Nelder-Mead's simplex takes no point above its worst, while it is not built anew. The others have no
/// such bar: DIRECT and the models use every value, and ISRES ranks each generation by itself.
class Bar {
 public:
  /// No bar at all.
  Bar() = default;
  Bar(const std::string& algorithm, std::size_t parameters);

  /// The value of the point asked for last, one asked for again included.
  void told(double value);

  /// The search goes on in the same way whatever value above this the next point has. HUGE_VAL: it does not.
  double now() const;

  /// It never rises again, so that it holds for later points too.
  bool only_falls() const { return kind_ != Kind::kSimplex; }

 private:
  enum class Kind { kNone, kElite, kSimplex };
  enum class Step { kBuild, kReflect, kExpand, kContract };

  void told_simplex(double value);
  /// Puts a value in the place of the simplex' worst.
  void replace_worst(double value);

  Kind kind_ = Kind::kNone;
  std::size_t size_ = 0;               ///< of population or simplex
  std::priority_queue<double> elite_;  ///< the best seen, the worst of them on top
  std::vector<double> simplex_;        ///< ascending once it is whole
  Step step_ = Step::kBuild;           ///< of Nelder-Mead, that the next point belongs to
  double reflected_ = HUGE_VAL;
};

}  // namespace armtune
