#include "tuner/search/tune.hpp"

#include <fmt/format.h>

#include <map>

#include "tuner/journal/evaluator.hpp"

namespace armtune {
namespace {

/// A search that asks this often in a row for points it knows is going round in a circle.
constexpr long kMostRepeats = 10000;

/// One run of the loop: what was seen so far and how to see more.
class Run {
 public:
  Run(const Study& study, Workers& workers, const std::atomic<bool>& stop, const TuneCallbacks& callbacks,
      Journal* journal)
      : study_(study),
        workers_(workers),
        stop_(stop),
        callbacks_(callbacks),
        evaluator_(study, workers, stop, journal) {}

  bool start();
  bool sweep();
  void search();
  TuneResult result() &&;

 private:
  /// Simulates candidates and takes them in, in order. False if the run was interrupted.
  bool evaluate(const char* phase, const std::vector<std::vector<double>>& points);
  bool budget_left();

  const Study& study_;
  Workers& workers_;
  const std::atomic<bool>& stop_;
  const TuneCallbacks& callbacks_;
  Evaluator evaluator_;
  std::optional<Objective> objective_;
  std::map<std::vector<double>, SolverValue> seen_;  ///< the search simulates no point again
  TuneResult out_;
};

bool Run::budget_left() {
  return out_.evaluations < study_.max_evaluations && evaluator_.time_left();
}

bool Run::evaluate(const char* phase, const std::vector<std::vector<double>>& points) {
  auto evaluations = evaluator_.next(phase, points, end_limits(objective_));
  if (!evaluations) return false;
  for (Evaluation& e : *evaluations) {
    if (!objective_) {
      objective_.emplace(study_.terms, study_.constraints, study_.scenarios, e.results, study_.source);
      if (callbacks_.begin) callbacks_.begin(*objective_);
    }
    objective_->judge(e);
    seen_[e.x] = {e.objective, e.relative};
    const bool first = out_.evaluations++ == 0;
    if (first || better(e, out_.best)) out_.best = e;
    if (callbacks_.evaluated) callbacks_.evaluated(phase, e);
    if (callbacks_.progress) {
      callbacks_.progress({phase, out_.evaluations, study_.max_evaluations, &e, &out_.best});
    }
    if (first) out_.start = std::move(e);
  }
  return true;
}

bool Run::start() {
  return evaluate("start", {study_.space.start_point()});
}

bool Run::sweep() {
  if (study_.sweep.empty()) return true;
  std::vector<std::vector<double>> points;
  std::vector<std::size_t> index(study_.sweep.size(), 0);
  for (bool more = true; more;) {
    Gains gains = study_.space.start;
    for (std::size_t a = 0; a < index.size(); ++a) {
      for (const std::size_t p : study_.sweep[a].parameters) {
        value(gains, study_.space.free[p].entry) *= study_.sweep[a].factors[index[a]];
      }
    }
    points.push_back(study_.space.point_of(gains));
    more = false;
    for (std::size_t a = 0; a < index.size() && !more; ++a) {
      more = ++index[a] < study_.sweep[a].factors.size();
      if (!more) index[a] = 0;
    }
  }
  // In portions, so that progress shows and an interrupt loses little.
  const auto portion = static_cast<std::size_t>(workers_.count());
  Evaluation before = out_.best;
  out_.best.feasible = false;
  out_.best.violation = HUGE_VAL;
  bool whole = true;
  for (std::size_t i = 0; i < points.size() && whole && budget_left(); i += portion) {
    const auto left = static_cast<std::size_t>(study_.max_evaluations - out_.evaluations);
    const auto end = std::min({points.size(), i + portion, i + left});
    whole = evaluate("sweep", {points.begin() + static_cast<std::ptrdiff_t>(i),
                               points.begin() + static_cast<std::ptrdiff_t>(end)});
  }
  if (out_.best.violation < HUGE_VAL) out_.best_of_sweep = out_.best;
  if (better(before, out_.best)) out_.best = std::move(before);
  return whole;
}

void Run::search() {
  SolverProblem problem;
  problem.start = out_.start.x;
  problem.constraint_count = objective_->constraint_count();
  bool interrupted = false;
  long repeats = 0;
  problem.evaluate = [&](const std::vector<double>& x, SolverValue& value) {
    if (stop_) {
      interrupted = true;
      return false;
    }
    if (const auto known = seen_.find(x); known != seen_.end()) {
      value = known->second;
      return ++repeats < kMostRepeats;
    }
    repeats = 0;
    if (!budget_left()) return false;
    if (!evaluate("search", {x})) {
      interrupted = true;
      return false;
    }
    value = seen_[x];
    return true;
  };
  const SolverOutcome outcome = minimize(problem, study_.solver);
  out_.interrupted = interrupted;
  out_.reason = interrupted       ? "interrupted"
                : outcome.stopped ? fmt::format("budget used up after {} evaluations", out_.evaluations)
                                  : outcome.reason;
}

TuneResult Run::result() && {
  return std::move(out_);
}

}  // namespace

double largest_velocity_ratio(const Evaluation& e) {
  double largest = 0.0;
  for (const RolloutResult& r : e.results) {
    largest = std::max(largest, r.metrics[Metric::kJointVelocityMaxRatio]);
  }
  return largest;
}

TuneResult tune(const Study& study, Workers& workers, const std::atomic<bool>& stop,
                const TuneCallbacks& callbacks, Journal* journal) {
  Run run(study, workers, stop, callbacks, journal);
  if (run.start() && run.sweep()) {
    run.search();
    return std::move(run).result();
  }
  TuneResult result = std::move(run).result();
  result.interrupted = true;
  result.reason = "interrupted";
  return result;
}

}  // namespace armtune
