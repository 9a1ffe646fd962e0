#include "tuner/search/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "tuner/journal/evaluator.hpp"
#include "tuner/search/starts.hpp"
#include "tuner/search/sweep.hpp"
#include "tuner/search/together.hpp"

namespace armtune {
namespace {

/// A study without a warm start begins at its start gains.
WarmStart at_start(const Study& study) {
  WarmStart warm;
  warm.gains = study.space.start;
  return warm;
}

/// One run of the loop: what was seen so far and how to see more.
class Run {
 public:
  Run(const Study& study, Workers& workers, const std::atomic<bool>& stop, const TuneCallbacks& callbacks,
      Journal* journal)
      : study_(study),
        stop_(stop),
        callbacks_(callbacks),
        evaluator_(study, workers, stop, journal),
        box_(warm_point(study.space, study.warm ? *study.warm : at_start(study))) {}

  bool start();
  bool sweep();
  /// From where the search begins to why it ended.
  void search();
  TuneResult result() &&;

 private:
  /// Simulates candidates and takes them in, in order. False if the run was interrupted.
  bool evaluate(const std::vector<Candidate>& candidates);
  void take_in(const char* phase, Evaluation e);
  bool budget_left();
  bool inside_box(const std::vector<double>& x) const;
  /// Evaluations until there are `most`; none once time is up.
  std::size_t evaluations_left(long most);
  bool begin_warm();
  /// Runs searches together until the run has `most` evaluations. False if interrupted.
  bool search_together(const char* phase, const std::vector<JoinedSearch>& searches, long most);
  void serve(const char* phase, std::vector<Request>& requests, long most);
  std::string reason(const std::vector<SolverOutcome>& outcomes) const;

  const Study& study_;
  const std::atomic<bool>& stop_;
  const TuneCallbacks& callbacks_;
  Evaluator evaluator_;
  WarmPoint box_;  ///< where the search begins and what it keeps to
  std::optional<Objective> objective_;
  std::optional<Evaluation> best_inside_;            ///< the box
  std::map<std::vector<double>, SolverValue> seen_;  ///< the search simulates no point again
  TuneResult out_;
};

bool Run::budget_left() {
  return out_.evaluations < study_.max_evaluations && evaluator_.time_left();
}

bool Run::inside_box(const std::vector<double>& x) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < box_.lower[i] || x[i] > box_.upper[i]) return false;
  }
  return true;
}

void Run::take_in(const char* phase, Evaluation e) {
  if (!objective_) {
    objective_.emplace(study_.terms, study_.constraints, study_.scenarios, e.results, study_.source);
    if (callbacks_.begin) callbacks_.begin(*objective_);
  }
  objective_->judge(e);
  seen_[e.x] = {e.objective, e.relative};
  const bool first = out_.evaluations++ == 0;
  if (first || better(e, out_.best)) out_.best = e;
  if (inside_box(e.x) && (!best_inside_ || better(e, *best_inside_))) best_inside_ = e;
  if (callbacks_.evaluated) callbacks_.evaluated(phase, e);
  if (callbacks_.progress) {
    callbacks_.progress({phase, out_.evaluations, study_.max_evaluations, &e, &out_.best});
  }
  if (first) out_.start = std::move(e);
}

bool Run::evaluate(const std::vector<Candidate>& candidates) {
  return evaluator_.next(candidates, end_limits(objective_),
                         [this](const char* phase, Evaluation e) { take_in(phase, std::move(e)); });
}

bool Run::start() {
  return evaluate({{"start", study_.space.start_point()}});
}

bool Run::sweep() {
  const auto points = sweep_points(study_);
  if (points.empty()) return true;
  Evaluation before = out_.best;
  out_.best.feasible = false;
  out_.best.violation = HUGE_VAL;
  const std::size_t count = std::min(points.size(), evaluations_left(study_.max_evaluations));
  std::vector<Candidate> candidates;
  candidates.reserve(count);
  for (std::size_t p = 0; p < count; ++p) candidates.push_back({"sweep", points[p]});
  const bool whole = evaluate(candidates);
  if (out_.best.violation < HUGE_VAL) out_.best_of_sweep = out_.best;
  if (better(before, out_.best)) out_.best = std::move(before);
  return whole;
}

std::size_t Run::evaluations_left(long most) {
  return budget_left() ? static_cast<std::size_t>(std::max(0L, most - out_.evaluations)) : 0;
}

void Run::serve(const char* phase, std::vector<Request>& requests, long most) {
  const std::size_t left = evaluations_left(most);
  std::vector<Candidate> candidates;
  std::set<std::vector<double>> chosen;
  for (const Request& request : requests) {
    for (const SolverPoint& point : request.points) {
      if (seen_.contains(point.x) || chosen.contains(point.x)) continue;
      if (candidates.size() == left) break;
      candidates.push_back({point.difference ? "gradient" : phase, point.x});
      chosen.insert(point.x);
    }
  }
  out_.interrupted = stop_ || (!candidates.empty() && !evaluate(candidates));
  for (Request& request : requests) {
    request.go_on = !out_.interrupted;
    for (const SolverPoint& point : request.points) {
      const auto known = seen_.find(point.x);
      if (known == seen_.end()) break;
      request.values.push_back(known->second);
    }
  }
}

std::string Run::reason(const std::vector<SolverOutcome>& outcomes) const {
  if (out_.interrupted) return "interrupted";
  for (const SolverOutcome& outcome : outcomes) {
    if (outcome.stopped) return fmt::format("budget used up after {} evaluations", out_.evaluations);
  }
  if (outcomes.size() == 1) return outcomes.front().reason;
  return fmt::format("all {} searches ended, the first: {}", outcomes.size(), outcomes.front().reason);
}

bool Run::search_together(const char* phase, const std::vector<JoinedSearch>& searches, long most) {
  const auto outcomes =
      minimize_together(searches, [&](std::vector<Request>& requests) { serve(phase, requests, most); });
  out_.reason = reason(outcomes);
  return !out_.interrupted;
}

/// Simulates where a warm start begins. False if there is no search after it.
bool Run::begin_warm() {
  if (!study_.warm || seen_.contains(box_.x)) return true;
  if (!budget_left()) {
    out_.reason = fmt::format("budget used up after {} evaluations", out_.evaluations);
    return false;
  }
  out_.interrupted = !evaluate({{"warm", box_.x}});
  if (out_.interrupted) out_.reason = "interrupted";
  return !out_.interrupted;
}

void Run::search() {
  if (!begin_warm()) return;
  JoinedSearch local;
  local.problem.start = box_.x;
  local.problem.lower = box_.lower;
  local.problem.upper = box_.upper;
  local.problem.constraint_count = objective_->constraint_count();
  local.options = solver_of(study_);
  if (!study_.global_algorithm.empty()) {
    JoinedSearch global = local;
    global.options.algorithm = study_.global_algorithm;
    const long left = study_.max_evaluations - out_.evaluations;
    const long share = std::lround(study_.global_share * static_cast<double>(left));
    if (!search_together("global", {global}, out_.evaluations + share)) return;
    local.problem.start = best_inside_->x;
  }
  std::vector<JoinedSearch> searches(study_.starts, local);
  const auto others = spread_starts(local.problem, study_.starts - 1, study_.solver.seed);
  for (std::size_t s = 1; s < searches.size(); ++s) {
    searches[s].problem.start = others[s - 1];
    searches[s].options.seed += s;
  }
  search_together("search", searches, study_.max_evaluations);
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
