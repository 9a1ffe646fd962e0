#include "tuner/minimax/minimax_search.hpp"

#include <algorithm>
#include <utility>

#include "tuner/minimax/damped_bfgs.hpp"
#include "tuner/minimax/epigraph_program.hpp"

namespace armtune::internal {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Ratios of actual to predicted decrease. (N&W algorithm 4.1)
constexpr double kAccept = 0.05;  // a step with less is not taken
constexpr double kShrink = 0.25;  // with less, the trust region becomes smaller,
constexpr double kGrow = 0.75;    // with more, larger, if the step reached its border
constexpr double kSmaller = 0.5;
constexpr double kLarger = 2.0;

constexpr double kDearer = 10.0;     // factor by which the penalty is raised
constexpr double kReduction = 0.5;   // share of the possible reduction of the violation that a step must make
constexpr double kSatisfied = 1e-6;  // a modelled violation as small as this is rounding

/// Returns the gradient of the Lagrangian of the step's multipliers. Each row of `model` is looked up in
/// `at`, the model of a second point; nothing if a row with a multiplier is not found there.
std::optional<VectorXd> lagrangian_gradient(const MinimaxModel& model, const EpigraphStep& step,
                                            const MinimaxModel& at) {
  VectorXd sum = VectorXd::Zero(step.d.size());
  const auto add = [&sum](const Maximum& rows, const VectorXd& multipliers, const Maximum& there) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double multiplier = multipliers[static_cast<Eigen::Index>(i)];
      if (multiplier <= 0.0) continue;
      const LinearRow* row = same_row(there, rows[i]);
      if (row == nullptr) return false;
      sum += multiplier * row->gradient;
    }
    return true;
  };
  if (at.terms.size() != model.terms.size() || at.constraints.size() != model.constraints.size()) return {};
  for (std::size_t k = 0; k < model.terms.size(); ++k) {
    if (!add(model.terms[k].rows, step.terms[k], at.terms[k].rows)) return {};
  }
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    if (!add(model.constraints[c], step.constraints[c], at.constraints[c])) return {};
  }
  return sum;
}

double violation(const SolverValue& value) {
  double sum = 0.0;
  for (const double c : value.constraints) sum += std::max(0.0, c);
  return sum;
}

class TrustRegionSearch {
 public:
  TrustRegionSearch(const MinimaxProblem& problem, const VectorXd& x, const SolverValue& value,
                    const MinimaxOptions& options)
      : problem_(problem), options_(options), radius_(options.radius), penalty_(options.penalty) {
    out_.x = x;
    out_.value = value;
  }

  MinimaxResult run();

 private:
  struct Trial {
    EpigraphStep step;
    VectorXd x;
    SolverValue value;      ///< at x
    double decrease = 0.0;  ///< predicted decrease of the merit
    double ratio = 0.0;     ///< actual by predicted decrease
  };

  double merit(const SolverValue& value) const;
  /// Returns the decrease of the merit that the model predicts for the step.
  double predicted(const VectorXd& d) const;
  StepBounds bounds() const;
  /// Returns the step in the trust region. Raises the penalty until the step reduces the violation by
  /// kReduction of what is possible, and satisfies the linearised constraints if that is possible (Byrd,
  /// Nocedal and Waltz, Optim. Methods Softw. 23, 2008).
  EpigraphStep step();
  /// Returns a Hessian with which a step along the objective's gradient alone has the length of the trust
  /// region.
  MatrixXd first_hessian() const;
  void update_hessian(const MinimaxModel& next, const EpigraphStep& step, const VectorXd& s);
  /// Adapts the trust region to a trial. Returns true if it has become larger.
  bool resize(const Trial& trial);
  /// Returns the model with each constraint shifted to its value at the trial (second order correction; N&W
  /// section 18.3).
  MinimaxModel corrected(const Trial& trial) const;
  /// Evaluates the step d. Returns false if the search must end.
  bool evaluate(const VectorXd& d, Trial& trial);
  /// Tries the step of the model and, if it violates constraints more than predicted, a corrected one.
  /// Returns nothing if the search ends, and sets the reason.
  std::optional<Trial> try_step();
  /// Moves to the trial. Returns false if the search must end.
  bool accept(const Trial& trial);

  const MinimaxProblem& problem_;
  const MinimaxOptions& options_;
  double radius_;
  double penalty_;
  MinimaxModel model_;  ///< at out_.x
  MatrixXd hessian_;
  bool updated_ = false;  ///< true if the Hessian has been updated at least once
  MinimaxResult out_;
};

double TrustRegionSearch::merit(const SolverValue& value) const {
  return value.objective + penalty_ * violation(value);
}

double TrustRegionSearch::predicted(const VectorXd& d) const {
  const VectorXd here = VectorXd::Zero(d.size());
  return objective_at(model_, here) - objective_at(model_, d) +
         penalty_ * (violation_at(model_, here) - violation_at(model_, d)) - 0.5 * d.dot(hessian_ * d);
}

StepBounds TrustRegionSearch::bounds() const {
  return {(problem_.lower - out_.x).cwiseMax(-radius_).cwiseMin(0.0),
          (problem_.upper - out_.x).cwiseMin(radius_).cwiseMax(0.0)};
}

EpigraphStep TrustRegionSearch::step() {
  const StepBounds box = bounds();
  EpigraphStep step = solve_epigraph(model_, hessian_, box, penalty_);
  if (violation_at(model_, step.d) <= kSatisfied) return step;
  const double now = violation_at(model_, VectorXd::Zero(step.d.size()));
  const double least =
      violation_at(model_, solve_epigraph(model_, hessian_, box, options_.largest_penalty).d);
  const double wanted = least <= kSatisfied ? kSatisfied : now - kReduction * std::max(0.0, now - least);
  while (violation_at(model_, step.d) > wanted && kDearer * penalty_ <= options_.largest_penalty) {
    penalty_ *= kDearer;
    step = solve_epigraph(model_, hessian_, box, penalty_);
  }
  return step;
}

MatrixXd TrustRegionSearch::first_hessian() const {
  const VectorXd here = VectorXd::Zero(out_.x.size());
  VectorXd gradient = here;
  for (const WeightedMaximum& term : model_.terms)
    gradient += term.weight * largest_row(term.rows, here).gradient;
  const double size = gradient.norm();
  return (size > 0.0 ? size / radius_ : 1.0) * MatrixXd::Identity(here.size(), here.size());
}

void TrustRegionSearch::update_hessian(const MinimaxModel& next, const EpigraphStep& step,
                                       const VectorXd& s) {
  const auto before = lagrangian_gradient(model_, step, model_);
  const auto after = lagrangian_gradient(model_, step, next);
  if (!before || !after) return;
  const VectorXd y = *after - *before;
  // The first step shows how large the curvature is. (N&W 6.20 has y^T y / s^T y, which is never smaller.)
  const double curvature = s.dot(y) / s.squaredNorm();
  if (!updated_ && curvature > 0.0) hessian_ = curvature * MatrixXd::Identity(s.size(), s.size());
  update_damped_bfgs(hessian_, s, y);
  updated_ = true;
}

bool TrustRegionSearch::resize(const Trial& trial) {
  const double length = trial.step.d.lpNorm<Eigen::Infinity>();
  if (!(trial.ratio >= kShrink)) radius_ = kSmaller * length;
  if (!(trial.ratio > kGrow) || length < 0.9 * radius_ || radius_ >= options_.largest_radius) return false;
  radius_ = std::min(kLarger * radius_, options_.largest_radius);
  return true;
}

MinimaxModel TrustRegionSearch::corrected(const Trial& trial) const {
  MinimaxModel model = model_;
  for (std::size_t c = 0; c < model.constraints.size(); ++c) {
    Maximum& rows = model.constraints[c];
    if (rows.empty()) continue;
    const LinearRow& largest = largest_row(rows, trial.step.d);
    const double missed = trial.value.constraints[c] - largest.value - largest.gradient.dot(trial.step.d);
    for (LinearRow& row : rows) row.value += missed;
  }
  return model;
}

bool TrustRegionSearch::evaluate(const VectorXd& d, Trial& trial) {
  trial.x = (out_.x + d).cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  const auto value = problem_.evaluate(trial.x);
  if (!value) return false;
  trial.value = *value;
  trial.ratio = (merit(out_.value) - merit(*value)) / trial.decrease;
  return true;
}

std::optional<TrustRegionSearch::Trial> TrustRegionSearch::try_step() {
  Trial trial;
  trial.step = step();
  trial.decrease = predicted(trial.step.d);
  // A Hessian that has become too large also predicts little. A new one costs no evaluation.
  if (!(trial.decrease > options_.least_decrease) && std::exchange(updated_, false)) {
    hessian_ = first_hessian();
    trial.step = step();
    trial.decrease = predicted(trial.step.d);
  }
  if (!(trial.decrease > options_.least_decrease)) {
    out_.ended = MinimaxEnd::kDecrease;
    return std::nullopt;
  }
  if (!evaluate(trial.step.d, trial)) return std::nullopt;
  if (violation(trial.value) <= violation_at(model_, trial.step.d) + kSatisfied) return trial;
  Trial second = trial;
  const VectorXd d = solve_epigraph(corrected(trial), hessian_, bounds(), penalty_).d;
  return evaluate(d, second) && second.ratio > trial.ratio ? second : trial;
}

MinimaxResult TrustRegionSearch::run() {
  auto first = problem_.model(out_.x);
  if (!first) return std::move(out_);
  model_ = std::move(*first);
  hessian_ = first_hessian();
  for (;;) {
    auto trial = try_step();
    if (!trial) return std::move(out_);
    // While the model is right up to its border, a longer step costs one evaluation, a new model many.
    // (Conn, Gould and Toint, Trust-region methods, 2000, section 10.5.2)
    while (resize(*trial)) {
      auto longer = try_step();
      if (!longer || merit(longer->value) >= merit(trial->value)) {
        radius_ /= kLarger;
        break;
      }
      trial = std::move(longer);
    }
    if (trial->ratio >= kAccept && !accept(*trial)) return std::move(out_);
    if (radius_ < options_.smallest_radius) {
      out_.ended = MinimaxEnd::kRadius;
      return std::move(out_);
    }
  }
}

bool TrustRegionSearch::accept(const Trial& trial) {
  const VectorXd s = trial.x - out_.x;
  out_.x = trial.x;
  out_.value = trial.value;
  ++out_.accepted;
  if (radius_ < options_.smallest_radius) return true;
  auto next = problem_.model(out_.x);
  if (!next) {
    out_.ended = MinimaxEnd::kStopped;
    return false;
  }
  update_hessian(*next, trial.step, s);
  model_ = std::move(*next);
  return true;
}

}  // namespace

MinimaxResult minimize_maxima(const MinimaxProblem& problem, const VectorXd& x, const SolverValue& value,
                              const MinimaxOptions& options) {
  return TrustRegionSearch(problem, x, value, options).run();
}

}  // namespace armtune::internal
