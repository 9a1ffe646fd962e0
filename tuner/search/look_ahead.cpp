#include "tuner/search/look_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

namespace armtune {
namespace {

/// How many points are looked for at a time: a generation of ISRES over fifty gains. More than are handed out
/// at once, for it is the search so far that takes time.
constexpr std::size_t kFar = 1024;

/// Value number `count` of points not known: each better (or worse) than all before it. To one that only
/// compares values these are out of all reach: what stands for values above its bar must make no difference.
SolverValue extreme(const SolverProblem& problem, double best, double worst, std::size_t count, bool better,
                    bool compares) {
  constexpr double kOutOfReach = 1e15;
  const double step =
      static_cast<double>(count + 1) * (compares ? kOutOfReach : 1.0 + std::abs(worst - best));
  return {better ? best - step : worst + step,
          std::vector<double>(problem.constraint_count, better ? -1.0 : 1.0 + static_cast<double>(count))};
}

}  // namespace

std::vector<std::vector<double>> LookAhead::replay(const Known& known, bool better) const {
  std::vector<std::vector<double>> asked;
  Known supposed;
  double best = 0.0;
  double worst = 0.0;
  for (const auto* told : history_) {
    best = std::min(best, told->second.objective);
    worst = std::max(worst, told->second.objective);
  }
  auto told = history_.begin();
  std::size_t repeats = 0;
  const bool compares = Bar(options_.algorithm, problem_.start.size()).exists();
  run_algorithm(problem_, options_,
                [&](const std::vector<double>& x, bool, const Bar&, SolverAnswer& answer) {
                  if (told != history_.end()) {
                    if ((*told)->first != x) return false;
                    answer.value = (*told++)->second;
                    return true;
                  }
                  auto found = known.find(x);
                  if (found == known.end()) {
                    if (const auto place = supposed.find(x); place != supposed.end()) {
                      answer.value = place->second;
                      return ++repeats < kFar;
                    }
                    if (asked.size() == kFar) return false;
                    answer.value = extreme(problem_, best, worst, asked.size(), better, compares);
                    supposed[x] = answer.value;
                    asked.push_back(x);
                    return true;
                  }
                  answer.value = found->second;
                  return ++repeats < kFar;
                });
  return asked;
}

std::vector<std::vector<double>> LookAhead::agreed(const Known& known) const {
  // In threads of their own: NLopt's random numbers are one stream per thread, and the search's is under way.
  auto if_better = std::async(std::launch::async, [&] { return replay(known, true); });
  auto if_worse = std::async(std::launch::async, [&] { return replay(known, false); });
  auto points = if_better.get();
  const auto others = if_worse.get();
  points.erase(std::mismatch(points.begin(), points.end(), others.begin(), others.end()).first, points.end());
  return points;
}

std::vector<std::vector<double>> LookAhead::next(const std::vector<double>& x, const Known& known) {
  if (foreseen_.empty() || foreseen_.front() != x) {
    foreseen_.clear();
    if (skip_ > 0) {
      --skip_;
      return {x};
    }
    const auto points = agreed(known);
    foreseen_.assign(points.begin(), points.end());
    if (foreseen_.empty() || foreseen_.front() != x) foreseen_ = {x};
    if (foreseen_.size() > 1) {
      next_skip_ = 1;
    } else {
      skip_ = next_skip_;
      next_skip_ *= 2;
    }
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(foreseen_.size(), options_.look_ahead));
  std::vector<std::vector<double>> points(foreseen_.begin(), foreseen_.begin() + count);
  foreseen_.erase(foreseen_.begin(), foreseen_.begin() + count);
  return points;
}

}  // namespace armtune
