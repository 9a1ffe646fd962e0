#include "tuner/search/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "tuner/journal/evaluator.hpp"
#include "tuner/search/starts.hpp"
#include "tuner/search/sweep.hpp"
#include "tuner/search/together.hpp"
#include "tuner/workers/simulate_points.hpp"

namespace armtune {
namespace {

/// A study without a warm start begins at its start gains.
WarmStart at_start(const Study& study) {
  WarmStart warm;
  warm.gains = study.space.start;
  return warm;
}

/// How many of the native engine's best points Simbody simulates again.
constexpr std::size_t kVerified = 3;
/// Step of the last search, on Simbody, from the best of them: of the box between the bounds.
constexpr double kLastStep = 0.02;

constexpr const char* kSweep = "sweep";

/// What was seen in one engine.
struct Seen {
  std::map<std::vector<double>, SolverValue> values;  ///< the search simulates no point again
  std::vector<Evaluation> best;                       ///< first the best, at most kVerified
  std::optional<Evaluation> best_inside;              ///< the box
};

/// One run of the loop: what was seen so far and how to see more.
class Run {
 public:
  Run(const Study& study, Workers& workers, const std::atomic<bool>& stop, const TuneCallbacks& callbacks,
      Journal* journal)
      : study_(study),
        workers_(workers),
        stop_(stop),
        callbacks_(callbacks),
        evaluator_(study, workers, stop, journal),
        box_(warm_point(study.space, study.warm ? *study.warm : at_start(study))) {}

  bool start();
  bool sweep();
  /// From where the search begins to why it ended.
  void search();
  /// The last steps of a search in the native engine: what it found, judged and refined by Simbody.
  void verify();
  void interrupt();
  TuneResult result() &&;

 private:
  /// Simulates candidates and takes them in, in order. False if the run was interrupted.
  bool evaluate(const std::vector<Candidate>& candidates);
  void take_in(const char* phase, Evaluation e);
  bool budget_left();
  Seen& seen() { return seen_[engine_]; }
  bool inside_box(const std::vector<double>& x) const;
  /// Evaluations that the run may have when the study's engine is done.
  long most_in_engine() const;
  void judge_unverified();
  /// Evaluations until there are `most`; none once time is up.
  std::size_t evaluations_left(long most);
  bool begin_warm();
  /// Runs searches together until the run has `most` evaluations. False if interrupted.
  bool search_together(const char* phase, const std::vector<JoinedSearch>& searches, long most);
  void serve(const char* phase, std::vector<Request>& requests, long most);
  std::string reason(const std::vector<SolverOutcome>& outcomes) const;

  const Study& study_;
  Workers& workers_;
  const std::atomic<bool>& stop_;
  const TuneCallbacks& callbacks_;
  Evaluator evaluator_;
  WarmPoint box_;  ///< where the search begins and what it keeps to
  std::optional<Objective> objective_;
  Engine engine_ = Engine::kSimbody;  ///< that simulates now
  std::map<Engine, Seen> seen_;
  std::optional<Evaluation> best_of_sweep_;
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
  seen().values[e.x] = {e.objective, e.relative};
  const bool first = out_.evaluations++ == 0;
  auto& best = seen().best;
  best.insert(std::upper_bound(best.begin(), best.end(), e, better), e);
  if (best.size() > kVerified) best.pop_back();
  if (inside_box(e.x) && (!seen().best_inside || better(e, *seen().best_inside))) seen().best_inside = e;
  const bool sweeping = std::string_view(phase) == kSweep;
  if (sweeping ? !best_of_sweep_ || better(e, *best_of_sweep_) : best_of_sweep_ && e.x == best_of_sweep_->x) {
    best_of_sweep_ = e;
  }
  if (callbacks_.evaluated) callbacks_.evaluated(phase, e);
  if (callbacks_.progress) {
    callbacks_.progress({phase, out_.evaluations, study_.max_evaluations, &e, &best.front()});
  }
  if (first) out_.start = std::move(e);
}

bool Run::evaluate(const std::vector<Candidate>& candidates) {
  return evaluator_.next(candidates, {engine_, end_limits(objective_)},
                         [this](const char* phase, Evaluation e) { take_in(phase, std::move(e)); });
}

long Run::most_in_engine() const {
  if (study_.engine == Engine::kSimbody) return study_.max_evaluations;
  const double share = std::round(study_.verify_share * static_cast<double>(study_.max_evaluations));
  const long kept = std::max(static_cast<long>(kVerified) + 1, static_cast<long>(share));  // 1: of the sweep
  return std::max(0L, study_.max_evaluations - kept);
}

bool Run::start() {
  const bool whole = evaluate({{"start", study_.space.start_point()}});
  engine_ = study_.engine;
  return whole;
}

bool Run::sweep() {
  const auto points = sweep_points(study_);
  const std::size_t count = std::min(points.size(), evaluations_left(most_in_engine()));
  std::vector<Candidate> candidates;
  candidates.reserve(count);
  for (std::size_t p = 0; p < count; ++p) candidates.push_back({kSweep, points[p]});
  return candidates.empty() || evaluate(candidates);
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
      if (seen().values.contains(point.x) || chosen.contains(point.x)) continue;
      if (candidates.size() == left) break;
      candidates.push_back({point.difference ? "gradient" : phase, point.x});
      chosen.insert(point.x);
    }
  }
  out_.interrupted = stop_ || (!candidates.empty() && !evaluate(candidates));
  for (Request& request : requests) {
    request.go_on = !out_.interrupted;
    for (const SolverPoint& point : request.points) {
      const auto known = seen().values.find(point.x);
      if (known == seen().values.end()) break;
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
  if (!study_.warm || seen().values.contains(box_.x)) return true;
  if (!budget_left()) {
    out_.reason = fmt::format("budget used up after {} evaluations", out_.evaluations);
    return false;
  }
  if (evaluate({{"warm", box_.x}})) return true;
  interrupt();
  return false;
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
    const long left = std::max(0L, most_in_engine() - out_.evaluations);
    const long share = std::lround(study_.global_share * static_cast<double>(left));
    if (!search_together("global", {global}, out_.evaluations + share)) return;
    if (seen().best_inside) local.problem.start = seen().best_inside->x;
  }
  std::vector<JoinedSearch> searches(study_.starts, local);
  const auto others = spread_starts(local.problem, study_.starts - 1, study_.solver.seed);
  for (std::size_t s = 1; s < searches.size(); ++s) {
    searches[s].problem.start = others[s - 1];
    searches[s].options.seed += s;
  }
  search_together("search", searches, most_in_engine());
}

void Run::interrupt() {
  out_.interrupted = true;
  out_.reason = "interrupted";
}

void Run::verify() {
  if (engine_ == Engine::kSimbody || out_.interrupted) return;
  const std::vector<Evaluation> found = seen().best;
  engine_ = Engine::kSimbody;
  std::vector<Candidate> candidates;
  const auto add = [&](const std::vector<double>& x) {
    if (!seen().values.contains(x)) candidates.push_back({"verify", x});
  };
  for (const Evaluation& e : found) add(e.x);
  const bool sweep_is_among =
      best_of_sweep_ &&
      std::any_of(found.begin(), found.end(), [this](const auto& e) { return e.x == best_of_sweep_->x; });
  if (best_of_sweep_ && !sweep_is_among) add(best_of_sweep_->x);
  if (!candidates.empty() && !evaluate(candidates)) return interrupt();
  if (!seen().best_inside) return;
  JoinedSearch last;
  last.problem.start = seen().best_inside->x;
  last.problem.lower = box_.lower;
  last.problem.upper = box_.upper;
  last.problem.constraint_count = objective_->constraint_count();
  last.options = solver_of(study_);
  last.options.initial_step = std::min(last.options.initial_step, kLastStep);
  if (!algorithm_from_name(last.options.algorithm).local) last.options.algorithm = SolverOptions().algorithm;
  search_together("verify", {last}, study_.max_evaluations);
}

/// An interrupted run still ends with Simbody's figures.
void Run::judge_unverified() {
  const auto unverified = seen_.find(Engine::kNative);
  const Evaluation& judged = seen_[Engine::kSimbody].best.front();
  if (unverified == seen_.end() || unverified->second.best.empty()) return;
  const std::vector<double> x = unverified->second.best.front().x;
  if (!better(unverified->second.best.front(), judged)) return;
  const std::atomic<bool> never{false};
  const auto again = simulate_points(study_, {x}, workers_, never, {engine_, end_limits(objective_)});
  Evaluation e = again->front();
  objective_->judge(e);
  if (better(e, judged)) seen_[Engine::kSimbody].best.front() = e;
}

TuneResult Run::result() && {
  if (out_.evaluations == 0) return std::move(out_);
  engine_ = Engine::kSimbody;
  if (out_.interrupted) judge_unverified();
  out_.best = seen().best.front();
  out_.best_of_sweep = best_of_sweep_;
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
    run.verify();
  } else {
    run.interrupt();
  }
  return std::move(run).result();
}

}  // namespace armtune
