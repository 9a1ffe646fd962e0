// minimize of solver.hpp: an algorithm that asks for one point at a time, served from batches.

#include <algorithm>
#include <iterator>

#include "tuner/search/differences.hpp"
#include "tuner/search/look_ahead.hpp"
#include "tuner/search/solver.hpp"

namespace armtune {
namespace {

/// A search that asks this often in a row for points it knows is going round in a circle.
constexpr long kMostRepeats = 10000;

/// One search's answers: what it is told, from what was evaluated for it.
class Served {
 public:
  Served(const SolverProblem& problem, const SolverOptions& options)
      : problem_(problem),
        options_(options),
        looks_ahead_(options.look_ahead > 1 && !algorithm_from_name(options.algorithm).uses_differences),
        ahead_(problem, options) {}

  bool answer(const std::vector<double>& x, bool derivatives, const Bar& bar, SolverAnswer& out);
  bool circling() const { return repeats_ >= kMostRepeats; }

 private:
  bool answer_with_derivatives(const std::vector<double>& x, SolverAnswer& out);
  /// What is known of a point and may be told; null if nothing.
  const LookAhead::Known::value_type* known(const std::vector<double>& x, double bar) const {
    const auto found = known_.find(x);
    return found == known_.end() || !found->second.good_for(bar) ? nullptr : &*found;
  }
  /// Asks for those of the points that are not known. False if the search is to end at once.
  bool fetch(const std::vector<SolverPoint>& points);

  const SolverProblem& problem_;
  const SolverOptions& options_;
  bool looks_ahead_;
  LookAhead::Known known_;
  LookAhead ahead_;
  bool ended_ = false;
  long repeats_ = 0;
};

bool Served::fetch(const std::vector<SolverPoint>& points) {
  std::vector<SolverPoint> unknown;
  std::copy_if(points.begin(), points.end(), std::back_inserter(unknown),
               [this](const SolverPoint& p) { return known(p.x, p.bar) == nullptr; });
  if (unknown.empty()) return true;
  if (ended_) return false;
  std::vector<SolverValue> values;
  ended_ = !problem_.evaluate(unknown, values);
  const bool told_to_end = ended_;
  ended_ = ended_ || values.size() < unknown.size();
  for (std::size_t i = 0; i < values.size(); ++i) known_[unknown[i].x] = std::move(values[i]);
  return !told_to_end;
}

/// The point and all differences around it in one batch.
bool Served::answer_with_derivatives(const std::vector<double>& x, SolverAnswer& out) {
  std::vector<SolverPoint> points = {{x, false}};
  for (auto& point : difference_points(problem_, options_, x)) points.push_back({std::move(point), true});
  repeats_ = known_.contains(x) ? repeats_ + 1 : 0;
  if (circling() || !fetch(points)) return false;
  std::vector<SolverValue> values;
  values.reserve(points.size());
  for (const SolverPoint& point : points) {
    const auto found = known_.find(point.x);
    if (found == known_.end()) return false;
    values.push_back(found->second);
  }
  out.value = values.front();
  values.erase(values.begin());
  set_gradients(problem_, options_, x, values, out);
  return true;
}

bool Served::answer(const std::vector<double>& x, bool derivatives, const Bar& bar, SolverAnswer& out) {
  if (derivatives) return answer_with_derivatives(x, out);
  const double now = bar.now();
  const auto* found = known(x, now);
  if (found == nullptr) {
    repeats_ = 0;
    std::vector<SolverPoint> points;
    if (looks_ahead_) {
      for (auto& point : ahead_.next(x, known_)) points.push_back({std::move(point), false, now});
    } else {
      points.push_back({x, false, now});
    }
    if (!fetch(points)) return false;
    found = known(x, now);
    if (found == nullptr) return false;
  } else if (++repeats_ >= kMostRepeats) {
    return false;
  }
  if (looks_ahead_) ahead_.note(*found);
  out.value = found->second;
  return true;
}

}  // namespace

SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options) {
  Served served(problem, options);
  SolverOutcome outcome =
      run_algorithm(problem, options,
                    [&served](const std::vector<double>& x, bool derivatives, const Bar& bar,
                              SolverAnswer& answer) { return served.answer(x, derivatives, bar, answer); });
  if (served.circling()) outcome = {false, false, "ended: it asks for nothing new any more"};
  return outcome;
}

}  // namespace armtune
