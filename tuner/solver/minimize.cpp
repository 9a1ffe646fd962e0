// Implements minimize() of solver.hpp: answers an algorithm from known values, and requests missing values.

#include <algorithm>
#include <iterator>
#include <map>

#include "tuner/solver/differences.hpp"
#include "tuner/solver/solver.hpp"

namespace armtune::internal {
namespace {

/// A search that requests known points this often in a row is ended, because it only repeats itself.
constexpr long kMostRepeats = 10000;

/// Answers the requests of one search, and stores the values that were evaluated for it.
class Served {
 public:
  Served(const SolverProblem& problem, const SolverOptions& options) : problem_(problem), options_(options) {}

  /// Answers a request for the point x. If derivatives are requested, all points for differences around x are
  /// evaluated in one batch. Returns false if the search must end.
  bool answer(const std::vector<double>& x, bool derivatives, SolverAnswer& out);
  bool circling() const { return repeats_ >= kMostRepeats; }

 private:
  /// Requests the values of all points that are not known. Returns false if the search must end at once.
  bool fetch(const std::vector<SolverPoint>& points);

  const SolverProblem& problem_;
  const SolverOptions& options_;
  std::map<std::vector<double>, SolverValue> known_;
  bool ended_ = false;
  long repeats_ = 0;
};

bool Served::fetch(const std::vector<SolverPoint>& points) {
  std::vector<SolverPoint> unknown;
  std::copy_if(points.begin(), points.end(), std::back_inserter(unknown),
               [this](const SolverPoint& p) { return !known_.contains(p.x); });
  if (unknown.empty()) return true;
  if (ended_) return false;
  std::vector<SolverValue> values;
  ended_ = !problem_.evaluate(unknown, values);
  const bool told_to_end = ended_;
  ended_ = ended_ || values.size() < unknown.size();
  for (std::size_t i = 0; i < values.size(); ++i) known_[unknown[i].x] = std::move(values[i]);
  return !told_to_end;
}

bool Served::answer(const std::vector<double>& x, bool derivatives, SolverAnswer& out) {
  std::vector<SolverPoint> points = {{x, false}};
  if (derivatives) {
    for (auto& point : difference_points(problem_, options_, x)) points.push_back({std::move(point), true});
  }
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
  if (!derivatives) return true;
  values.erase(values.begin());
  set_gradients(problem_, options_, x, values, out);
  return true;
}

}  // namespace

SolverOutcome minimize(const SolverProblem& problem, const SolverOptions& options) {
  Served served(problem, options);
  SolverOutcome outcome = run_algorithm(
      problem, options, [&served](const std::vector<double>& x, bool derivatives, SolverAnswer& answer) {
        return served.answer(x, derivatives, answer);
      });
  if (served.circling()) outcome = {false, false, "ended: the search only repeats known points"};
  return outcome;
}

}  // namespace armtune::internal
