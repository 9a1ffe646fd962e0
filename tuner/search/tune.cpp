#include "tuner/search/tune.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "tuner/evaluation/evaluator.hpp"
#include "tuner/search/final_phase.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/search/requests.hpp"
#include "tuner/search/seen.hpp"
#include "tuner/search/sweep.hpp"
#include "tuner/solver/starts.hpp"
#include "tuner/solver/together.hpp"

namespace armtune::internal {
namespace {

/// Returns the start gains as a warm start, for a study that has no other.
WarmStart at_start(const Study& study) {
  WarmStart warm;
  warm.gains = study.space.start;
  return warm;
}

constexpr const char* kSweep = "sweep";

/// One run of the search, with the evaluations that it has made so far.
class Run {
 public:
  Run(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
      const TuneCallbacks& callbacks, Journal* journal)
      : study_(study),
        workers_(workers),
        stop_(stop),
        callbacks_(callbacks),
        evaluator_(study, workers, stop, journal),
        box_(warm_point(study.space, study.warm ? *study.warm : at_start(study))) {}

  bool start();
  bool sweep();
  /// Simulates the point of a warm start, then runs the searches. Sets the reason why they ended.
  void search();
  /// Makes the last steps after a search in the native engine: Simbody evaluates and refines the best gains.
  void verify();
  /// If the best gains have a fault, looks for gains without one between the start gains and the best gains.
  void turn_back();
  void interrupt();
  TuneResult result() &&;

 private:
  /// Simulates candidates, and passes them to take_in() in order. Returns false if the run was interrupted.
  bool evaluate(const std::vector<Candidate>& candidates);
  void take_in(const char* phase, Evaluation e);
  Seen& seen() { return seen_[engine_]; }
  /// Returns the number of evaluations that the run may have when the search in this engine ends.
  long most_in(Engine engine) const {
    return study_.max_evaluations - (engine == Engine::kSimbody ? 0 : kept_evaluations(study_));
  }
  /// Returns the number of evaluations so far, perturbed copies included.
  long spent() const { return out_.evaluations + out_.copies; }
  /// Returns how many evaluations are left until the run has `most`; 0 if time is up.
  std::size_t evaluations_left(long most);
  void conclude_budget();
  bool begin_warm();
  /// Returns the time that is left to the search [s]. It is computed from the time of the latest evaluation,
  /// because this is the same in a resumed run.
  double rest() const { return std::max(0.0, 60.0 * study_.max_minutes - kept_ - seconds_); }
  /// Ends the time budget of a phase: from now on, all the time that is left to the search may be used.
  void use_rest() { evaluator_.use(engine_ == Engine::kSimbody ? Minutes::kRun : Minutes::kSearch, kept_); }
  /// Returns a search that starts at x, with the bounds of box_ and the study's options.
  JoinedSearch search_from(const std::vector<double>& x);
  /// Runs the global search with its share of evaluations and minutes. Returns false if it was interrupted.
  bool search_globally(JoinedSearch search);
  /// Runs searches at the same time until the run has `most` evaluations. Returns false if interrupted.
  bool search_together(const char* phase, const std::vector<JoinedSearch>& searches, long most);
  void serve(const char* phase, std::vector<Request>& requests, long most);
  void conclude(const std::vector<SolverOutcome>& outcomes);
  /// Runs the final phase until the run has `most` evaluations. Sets the reason why it ended.
  void search_finally(long most);

  const Study& study_;
  CandidateRunner& workers_;
  const std::atomic<bool>& stop_;
  const TuneCallbacks& callbacks_;
  Evaluator evaluator_;
  WarmPoint box_;                     ///< start and bounds of the search
  Engine engine_ = Engine::kSimbody;  ///< engine that simulates now
  std::map<Engine, Seen> seen_;
  std::optional<Evaluation> best_of_sweep_;
  std::optional<Evaluation> last_;       ///< latest evaluation
  std::optional<Evaluation> faultless_;  ///< gains that replace best gains with a fault
  double kept_ = 0.0;                    ///< time reserved for Simbody's last steps [s]
  double seconds_ = 0.0;                 ///< wall time at the latest evaluation, as in the journal [s]
  TuneResult out_;
};

void Run::take_in(const char* phase, Evaluation e) {
  const bool first = out_.evaluations++ == 0;
  e.copies = out_.copies;
  seconds_ = std::max(seconds_, e.seconds);
  auto& objective = seen().objective;
  if (!objective) {
    objective.emplace(study_.terms, study_.constraints, simulated_scenarios(study_), e.results, where(study_),
                      study_.own_objective);
    if (first && callbacks_.begin) callbacks_.begin(*objective);
  }
  objective->judge(e);
  seen().take(e, box_);
  const bool of_sweep = std::string_view(phase) == kSweep;
  if (of_sweep ? !best_of_sweep_ || better(e, *best_of_sweep_) : best_of_sweep_ && e.x == best_of_sweep_->x) {
    best_of_sweep_ = e;
  }
  last_ = e;
  if (callbacks_.evaluated) callbacks_.evaluated(phase, e);
  if (callbacks_.progress) {
    callbacks_.progress({phase, spent(), study_.max_evaluations, &e, &seen().best().front()});
  }
}

bool Run::evaluate(const std::vector<Candidate>& candidates) {
  return evaluator_.next(candidates, {engine_, end_limits(seen().objective)},
                         [this](const char* phase, Evaluation e) { take_in(phase, std::move(e)); });
}

bool Run::start() {
  const std::vector<double> x = study_.space.start_point();
  if (!evaluate({{"start", x}})) return false;
  const Engine engine = engine_of_search(study_);
  if (engine == Engine::kSimbody) return true;
  kept_ = kept_seconds(study_, seen().start->seconds);
  evaluator_.use(Minutes::kSearch, kept_);
  if (evaluations_left(most_in(engine)) == 0) {  // too little time for both engines: Simbody searches
    kept_ = 0.0;
    evaluator_.use(Minutes::kRun);
    return true;
  }
  engine_ = engine;
  return evaluate({{"start", x}});
}

bool Run::sweep() {
  const auto points = sweep_points(study_);
  const std::size_t count = std::min(points.size(), evaluations_left(most_in(engine_)));
  std::vector<Candidate> candidates;
  candidates.reserve(count);
  for (std::size_t p = 0; p < count; ++p) candidates.push_back({kSweep, points[p]});
  return candidates.empty() || evaluate(candidates);
}

std::size_t Run::evaluations_left(long most) {
  if (spent() >= most || !evaluator_.time_left()) return 0;
  return static_cast<std::size_t>(most - spent());
}

/// Sets the reason why the search ended: its evaluations or its time were used up.
void Run::conclude_budget() {
  const bool time = evaluator_.time_was_up();
  out_.ended = time ? SearchEnd::kTime : SearchEnd::kEvaluations;
  out_.reason = fmt::format("{} used up after {} evaluations{}", time ? "time" : "budget", out_.evaluations,
                            out_.copies > 0 ? fmt::format(" and {} perturbed copies", out_.copies) : "");
}

void Run::serve(const char* phase, std::vector<Request>& requests, long most) {
  std::size_t left = evaluations_left(most);
  const auto candidates = candidates_of(
      requests, phase, [this](const SolverPoint& point) { return seen().at(point.x) != nullptr; },
      [&left](std::size_t) { return left > 0 && left-- > 0; });
  out_.interrupted = evaluator_.stopped() || (!candidates.empty() && !evaluate(candidates));
  answer(requests, !out_.interrupted, [this](std::size_t, const SolverPoint& point) {
    const SolverValue* known = seen().at(point.x);
    return known ? std::optional(*known) : std::nullopt;
  });
}

/// Sets the reason why the search ended, from the outcomes of the solvers.
void Run::conclude(const std::vector<SolverOutcome>& outcomes) {
  if (out_.interrupted) return interrupt();
  for (const SolverOutcome& outcome : outcomes) {
    if (outcome.stopped) return conclude_budget();
  }
  const SolverOutcome& first = outcomes.front();
  out_.ended = first.converged ? SearchEnd::kConverged : SearchEnd::kSolverGaveUp;
  out_.reason = outcomes.size() == 1
                    ? first.reason
                    : fmt::format("all {} searches ended, the first with: {}", outcomes.size(), first.reason);
}

bool Run::search_together(const char* phase, const std::vector<JoinedSearch>& searches, long most) {
  const auto outcomes =
      minimize_together(searches, [&](std::vector<Request>& requests) { serve(phase, requests, most); });
  conclude(outcomes);
  return !out_.interrupted;
}

/// Simulates the point of a warm start. Returns false if no search follows.
bool Run::begin_warm() {
  if (!study_.warm || seen().at(box_.x)) return true;
  if (evaluations_left(most_in(engine_)) == 0) {
    conclude_budget();
    return false;
  }
  if (evaluate({{"warm", box_.x}})) return true;
  interrupt();
  return false;
}

JoinedSearch Run::search_from(const std::vector<double>& x) {
  JoinedSearch search;
  search.problem.start = x;
  search.problem.lower = box_.lower;
  search.problem.upper = box_.upper;
  search.problem.constraint_count = seen_[Engine::kSimbody].objective->constraint_count();
  search.options = solver_of(study_);
  return search;
}

bool Run::search_globally(JoinedSearch search) {
  search.options.algorithm = global_of(study_);
  const long left = std::max(0L, most_in(engine_) - out_.evaluations);
  const long share = std::lround(study_.global_share * static_cast<double>(left));
  evaluator_.use(Minutes::kGlobal, kept_ + (1.0 - study_.global_share) * rest());
  const bool whole = search_together("global", {search}, out_.evaluations + share);
  use_rest();
  return whole;
}

void Run::search() {
  if (!begin_warm()) return;
  JoinedSearch local = search_from(box_.x);
  if (!global_of(study_).empty()) {
    if (!search_globally(local)) return;
    if (seen().best_inside()) local.problem.start = seen().best_inside()->x;
  }
  std::vector<JoinedSearch> searches(study_.starts, local);
  const auto others = spread_starts(local.problem, study_.starts - 1, study_.solver.seed);
  for (std::size_t s = 1; s < searches.size(); ++s) {
    searches[s].problem.start = others[s - 1];
    searches[s].options.seed += s;
  }
  const long most = most_in(engine_);
  const long kept = final_evaluations(study_, most - out_.evaluations);
  if (kept > 0) evaluator_.use(Minutes::kLocal, kept_ + study_.final_share * rest());
  const bool whole = search_together("search", searches, most - kept);
  if (kept == 0) return;
  if (whole) search_finally(most);
  use_rest();
}

void Run::search_finally(long most) {
  if (!seen().best_inside() || !seen().best_inside()->completed) return;
  const Evaluation best = *seen().best_inside();
  evaluator_.use(Minutes::kFinal, kept_);
  // The time is checked once after each evaluation. A resumed run then ends at the same one.
  bool time = evaluator_.time_left();
  FinalPhaseRollouts rollouts;
  rollouts.differentiate = [&](const std::vector<double>& x) -> std::optional<MetricDerivatives> {
    const long copies = copies_per_iteration(study_);
    if (!time || spent() + copies >= most) return std::nullopt;
    auto derivatives = metric_derivatives(study_, x, metrics_in_use(study_), workers_, stop_);
    if (derivatives) out_.copies += copies;
    out_.interrupted = !derivatives;
    return derivatives;
  };
  rollouts.evaluate = [&](const std::vector<double>& x) -> const Evaluation* {
    if (!time || spent() >= most) return nullptr;
    out_.interrupted = evaluator_.stopped() || !evaluate({{"final", x}});
    if (out_.interrupted) return nullptr;
    time = evaluator_.time_left();
    return &*last_;
  };
  const MinimaxEnd ended = run_final_phase(study_, *seen().objective, best, box_, rollouts).ended;
  if (out_.interrupted) return interrupt();
  if (ended == MinimaxEnd::kStopped) return conclude_budget();
  out_.ended = SearchEnd::kConverged;
  out_.reason = ended == MinimaxEnd::kRadius ? "the final phase's steps became shorter than x_tolerance"
                                             : "the final phase's model predicts no further improvement";
}

void Run::verify() {
  if (engine_ == Engine::kSimbody || out_.interrupted) return;
  const long most = std::min(study_.max_evaluations, spent() + kept_evaluations(study_));
  const std::string searched = out_.reason;
  const SearchEnd ended = out_.ended;
  // These few points are simulated even if time is up, because there is no result without them.
  const auto candidates = to_judge(seen(), best_of_sweep_, seen_[Engine::kSimbody]);
  engine_ = Engine::kSimbody;
  evaluator_.use(Minutes::kRun);
  if (!candidates.empty() && !evaluate(candidates)) return interrupt();
  if (!seen().best_inside()) return;
  JoinedSearch last = search_from(seen().best_inside()->x);
  last.options.initial_step = std::min(last.options.initial_step, kLastStep);
  if (!algorithm_from_name(last.options.algorithm).local) last.options.algorithm = SolverOptions().algorithm;
  if (!search_together("verify", {last}, most)) return;
  out_.ended = ended;
  out_.reason = fmt::format("{}, in the {} engine; Simbody then simulated and refined the best gains",
                            searched, name(study_.engine));
}

void Run::turn_back() {
  const Seen& judged = seen_[Engine::kSimbody];
  if (!callbacks_.fault || out_.interrupted || judged.best().empty()) return;
  const Evaluation start = *judged.start;
  const Evaluation best = judged.best().front();
  if (!best.feasible || best.x == start.x) return;
  const std::string fault = callbacks_.fault(best.gains);
  if (fault.empty()) return;
  for (const double share : kSharesOfTheWay) {
    if (!evaluator_.time_left()) return;
    std::vector<double> x = start.x;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += share * (best.x[i] - start.x[i]);
    if (!evaluate({{"verify", x}})) return interrupt();
    if (!last_->feasible || !better(*last_, start) || !callbacks_.fault(last_->gains).empty()) continue;
    faultless_ = last_;
    out_.passed_over = fmt::format(
        "the best gains found (objective {:.4f}) fail a check ({}); the resulting gains pass it. They lie at "
        "{:.0f} % of the way from the start gains to the best gains",
        best.objective, fault, 100.0 * share);
    return;
  }
}

void Run::interrupt() {
  out_.interrupted = true;
  out_.ended = SearchEnd::kInterrupted;
  out_.reason = "interrupted";
}

TuneResult Run::result() && {
  if (out_.evaluations == 0) return std::move(out_);
  const Seen& judged = seen_[Engine::kSimbody];
  out_.start = *judged.start;
  out_.best = judged.best().front();
  // The best gains of an interrupted run may be gains that Simbody has not simulated yet.
  for (const auto& [engine, seen] : seen_) {
    if (out_.interrupted && !seen.best().empty() && better(seen.best().front(), out_.best)) {
      out_.best = seen.best().front();
    }
  }
  if (faultless_ && !out_.interrupted) out_.best = *faultless_;
  if (best_of_sweep_ && best_of_sweep_->engine != Engine::kSimbody) {
    // If the best of the sweep is the start, Simbody does not simulate it again. Its evaluation is known.
    best_of_sweep_ = best_of_sweep_->x == out_.start.x ? std::optional(out_.start) : std::nullopt;
  }
  out_.best_of_sweep = best_of_sweep_;
  return std::move(out_);
}

}  // namespace

double largest_velocity_ratio(const Study& study, const Evaluation& e) {
  double largest = 0.0;
  for (std::size_t s = 0; s < study.scenarios.size(); ++s) {
    largest = std::max(largest, e.results[s].metrics[Metric::kJointVelocityMaxRatio]);
  }
  return largest;
}

TuneResult tune(const Study& study, CandidateRunner& workers, const std::atomic<bool>& stop,
                const TuneCallbacks& callbacks, Journal* journal) {
  Run run(study, workers, stop, callbacks, journal);
  if (run.start() && run.sweep()) {
    run.search();
    run.verify();
    run.turn_back();
  } else {
    run.interrupt();
  }
  return std::move(run).result();
}

}  // namespace armtune::internal
