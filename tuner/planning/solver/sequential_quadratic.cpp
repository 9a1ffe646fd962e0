#include "tuner/planning/solver/sequential_quadratic.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/planning/solver/sparse_cholesky.hpp"
#include "tuner/planning/solver/step_filter.hpp"
#include "tuner/planning/solver/violation_price.hpp"

namespace armtune::internal {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kSubproblemPart = 1e4;          // factor on a subproblem's tolerances: this times the error,
constexpr double kSubproblemLast = 0.9;          // but at least this
constexpr double kSubproblemFirst = 3.0;         // and at most this
constexpr double kStartComplementarity = 100.0;  // x last change: initial sum of slack x multiplier,
constexpr double kLeastMu = 1e-10;               // and least mean of these products
constexpr int kHalvings = 4;                     // most halvings of a step before the damping is increased
constexpr double kLargestDamping = 1e6;
constexpr double kSmallestDamping = 3e-7;  // keeps steps short in directions in which nothing changes
constexpr double kCorrectable = 0.01;      // violation after a step that a correction can remove,
constexpr int kCorrectionSteps = 25;       // and the number of iterations that this may take
constexpr double kTighter = 1e-2;

class Solver {
 public:
  Solver(NonlinearProgram& program, const SequentialQuadraticOptions& options)
      : program_(program),
        options_(options),
        interior_(program.variables(), program.residuals, program.curvature, program.rows,
                  make_sparse_cholesky) {
    quadratic_.residuals = &program.residuals;
    quadratic_.rows = &program.rows;
    quadratic_.curvature = &program.curvature;
    quadratic_.bounds = program.bounds;
    quadratic_.scale = program.metric.minCoeff();
  }

  SequentialQuadraticResult run(VectorXd z, VectorXd y, const PlanObserver& observer) {
    SequentialQuadraticResult result;
    auto& now = result.last;
    const bool warm = y.size() == program_.rows.rows();
    if (!warm) y.setZero(program_.rows.rows());
    ViolationPrice price(program_.bounds, options_.violation, y);
    charge(price);
    now.damping = options_.damping;
    mu_ = warm ? 1e-4 : 1.0;
    program_.linearize(z, residual_, row_);
    for (;; ++now.iteration) {
      measure(z, y, now);
      if (now.violation <= options_.violation && is_optimal(now, 1.0)) {
        result.status = PlanStatus::kSolved;
        break;
      }
      // Multipliers as large as penalties cause larger rounding errors.
      const bool settled = is_optimal(now, std::max(1.0, 0.1 * y.lpNorm<Eigen::Infinity>()));
      const bool stuck = price.no_less_violated(now.iteration, row_);
      if ((settled || stuck) && price.paid(row_, y)) {
        // The violations remain at this price. If it is the highest, the problem is infeasible.
        if (price.highest()) {
          result.status = PlanStatus::kInfeasible;
          break;
        }
        raise(price);
      }
      // Subproblems of long trajectories take long, so the observer is called in each of their iterations.
      const auto go_on = [&] { return !(stopped_ = observer && !observer(now)); };
      const bool last = now.iteration == options_.max_iterations;
      if (last || !advance(z, y, now, go_on)) {
        if (stopped_) {
          result.status = PlanStatus::kInterrupted;
          break;
        }
        const bool paid = price.paid(row_, y);
        if (!last && paid && !price.highest()) {  // no progress at this price
          raise(price);
          now.damping = options_.damping;
          continue;
        }
        // No progress. If violated rows have reached the highest penalties, or no step was found with them,
        // the problem counts as infeasible, although the tolerances are not met.
        if (price.highest() && (paid || (untried_ && !last))) result.status = PlanStatus::kInfeasible;
        break;
      }
      untried_ = false;
    }
    result.z = std::move(z);
    result.multipliers = std::move(y);
    return result;
  }

 private:
  void measure(const VectorXd& z, const VectorXd& y, SequentialQuadraticProgress& now) {
    gradient_ = program_.cost;
    program_.residuals.add_transposed(residual_, gradient_);
    VectorXd lagrangian = gradient_;
    program_.rows.add_transposed(y, lagrangian);
    now.stationarity = lagrangian.lpNorm<1>();
    now.objective = program_.cost.dot(z) + 0.5 * residual_.squaredNorm();
    now.violation = 0.0;
    now.complementarity = 0.0;
    for (Index i = 0; i < row_.size(); ++i) {
      const double v = violation(program_.bounds, i, row_[i]);
      now.violation = std::max(now.violation, v);
      if (v > options_.violation) continue;
      const double bound = y[i] > 0.0 ? program_.bounds.upper[i] : program_.bounds.lower[i];
      const double slack = std::isfinite(bound) ? std::abs(row_[i] - bound) : 1.0;
      now.complementarity += std::abs(y[i]) * slack;
    }
  }

  /// Returns true if stationarity and complementarity are within `factor` times their tolerances.
  bool is_optimal(const SequentialQuadraticProgress& now, double factor) const {
    return now.stationarity <= factor * options_.stationarity &&
           now.complementarity <= factor * options_.complementarity;
  }

  /// Raises the price. The next subproblem starts cold.
  void raise(ViolationPrice& price) {
    price.raise();
    charge(price);
    untried_ = true;
    mu_ = 1.0;
  }

  /// Makes subproblems and the filter use this price. Clears the filter and the least error.
  void charge(const ViolationPrice& price) {
    error_ = INFINITY;
    quadratic_.bounds.penalty = price.penalties();
    dearest_ = price.dearest();
    filter_.clear();
  }

  /// Returns the quantities by which the filter judges a point.
  Judged judge(const VectorXd& z, const VectorXd& residual, const VectorXd& row) const {
    Judged at;
    at.objective = program_.cost.dot(z) + 0.5 * residual.squaredNorm();
    for (Index i = 0; i < row.size(); ++i) {
      const double v = violation(program_.bounds, i, row[i]);
      at.violation += v;
      at.largest = std::max(at.largest, v);
    }
    at.violation *= program_.metric[0];
    return at;
  }

  /// Takes one step. Returns false if no step is found, or if `go_on` returned false.
  bool advance(VectorXd& z, VectorXd& y, SequentialQuadraticProgress& now,
               const std::function<bool()>& go_on) {
    program_.curve(z, residual_, y);
    quadratic_.gradient = gradient_;
    InteriorPointOptions interior;
    interior.go_on = go_on;
    // Subproblems are solved only as exactly as the present error requires. A violation that remains at its
    // price is not an error; then the size of the last step counts instead.
    const double violated = now.iteration == 0 ? now.violation : std::min(now.violation, now.step);
    error_ = std::min(error_, std::max({now.stationarity, violated, now.complementarity}));
    for (;;) {
      const double exact = std::clamp(kSubproblemPart * error_, kSubproblemLast, kSubproblemFirst);
      interior.stationarity = exact * options_.stationarity;
      interior.complementarity = exact * options_.complementarity;
      interior.infeasibility = exact * options_.violation;
      quadratic_.damping = now.damping * program_.metric;
      bound_steps(row_);
      VectorXd p = VectorXd::Zero(z.size());
      VectorXd multipliers = y;
      const InteriorPointResult solved = solve_warm_or_cold(interior, p, multipliers, now);
      if (solved.interrupted) return false;
      if (solved.infeasibility < 1e-5 && p.allFinite()) {
        if (step_along(p, multipliers, interior, z, y, now)) return true;
        if (stopped_) return false;
      } else {
        mu_ = 1.0;
      }
      if (now.damping >= kLargestDamping) return false;
      error_ *= kTighter;  // the subproblem may have been solved too inexactly
      now.damping = std::max(now.damping, 1e-6) * 10.0;
    }
  }

  /// Searches along p, a solution of the subproblem, and takes the first step that the filter accepts.
  /// Returns false if it accepts none, or if the observer stopped the solver.
  bool step_along(const VectorXd& p, VectorXd& multipliers, const InteriorPointOptions& interior, VectorXd& z,
                  VectorXd& y, SequentialQuadraticProgress& now) {
    const Judged before = judge(z, residual_, row_);
    const Judged model = modelled(z, p);
    if (now.iteration == 0) filter_.allow(std::max(0.3, 2.0 * before.largest));
    filter_.allow(2.0 * model.largest);  // at this price, the subproblem allows no less
    const double price = dearest_ / program_.metric[0];
    const auto acceptable = [&](const Judged& after, double part) {
      return filter_.accepts(before, model, after, part, price);
    };
    for (int halving = 0; halving <= kHalvings; ++halving) {
      const double alpha = std::ldexp(1.0, -halving);
      VectorXd next = z + alpha * p;
      program_.evaluate(next, trial_r_, trial_c_);
      Judged after = judge(next, trial_r_, trial_c_);
      bool accepted = acceptable(after, alpha);
      const bool near = after.largest <= std::max(kCorrectable, 10.0 * before.largest);
      if (!accepted && halving == 0 && near && corrected(z, p, multipliers, next, interior, now)) {
        after = judge(next, trial_r_, trial_c_);
        accepted = acceptable(after, alpha);
      }
      if (stopped_) return false;
      if (!accepted) continue;
      if (alpha == 1.0)
        now.damping = std::max(kSmallestDamping, now.damping * 0.1);
      else if (alpha < 0.5)
        now.damping = std::min(kLargestDamping, std::max(now.damping, 1e-6) * 4.0);
      now.step = (next - z).lpNorm<Eigen::Infinity>();
      z = std::move(next);
      y = multipliers;
      // The last change shows how far the next subproblem may move. Its initial products of slack and
      // multiplier (mu) are chosen in proportion, so that they are neither too large nor too small.
      const double change = std::abs(after.objective - before.objective) + after.largest;
      mu_ = std::clamp(kStartComplementarity * change / static_cast<double>(row_.size()), kLeastMu, 1.0);
      program_.linearize(z, residual_, row_);
      return true;
    }
    return false;
  }

  /// Sets the bounds of the subproblem's rows, which are those of the program minus the present values `row`.
  void bound_steps(const VectorXd& row) {
    quadratic_.bounds.lower = program_.bounds.lower - row;
    quadratic_.bounds.upper = program_.bounds.upper - row;
    for (Index i = 0; i < row.size(); ++i) {  // the bounds of an equation stay exactly equal
      if (program_.bounds.lower[i] == program_.bounds.upper[i])
        quadratic_.bounds.lower[i] = quadratic_.bounds.upper[i];
    }
    for (const Index i : program_.halving_rows) {
      quadratic_.bounds.lower[i] = std::max(quadratic_.bounds.lower[i], -0.5 * row_[i]);
      quadratic_.bounds.upper[i] = std::min(quadratic_.bounds.upper[i], row_[i]);
    }
  }

  /// Solves the subproblem from p and the multipliers, and again from zero if that fails, in case the start
  /// was bad.
  InteriorPointResult solve_warm_or_cold(InteriorPointOptions& interior, VectorXd& p, VectorXd& multipliers,
                                         SequentialQuadraticProgress& now) {
    interior.start_mu = mu_;
    const InteriorPointResult warm = solve_quadratic(interior, p, multipliers, now);
    if (warm.interrupted || warm.solved) return warm;
    interior.start_mu = 1.0;
    p.setZero();
    multipliers.setZero();
    return solve_quadratic(interior, p, multipliers, now);
  }

  InteriorPointResult solve_quadratic(const InteriorPointOptions& interior, VectorXd& p,
                                      VectorXd& multipliers, SequentialQuadraticProgress& now) {
    const InteriorPointResult solved = interior_.solve(quadratic_, interior, p, multipliers);
    now.interior_iterations += solved.iterations;
    return solved;
  }

  /// Returns the values that the subproblem predicts for the step p.
  Judged modelled(const VectorXd& z, const VectorXd& p) {
    program_.residuals.multiply(p, change_r_);
    program_.rows.multiply(p, change_c_);
    Judged model = judge(z + p, residual_ + change_r_, row_ + change_c_);
    VectorXd Cp = VectorXd::Zero(p.size());
    program_.curvature.add_product(p, Cp);
    model.objective += 0.5 * p.dot(Cp);
    return model;
  }

  /// Computes the second order correction (Nocedal and Wright, 18.3): solves the subproblem again with the
  /// row values at the end of the step (trial_c_). This makes up for the curvature that linearised rows lack.
  /// Returns false if the subproblem is not solved.
  bool corrected(const VectorXd& z, const VectorXd& p, VectorXd& multipliers, VectorXd& next,
                 InteriorPointOptions interior, SequentialQuadraticProgress& now) {
    program_.rows.multiply(p, change_c_);
    bound_steps(trial_c_ - change_c_);
    interior.start_mu = 1e-6;
    interior.max_iterations = kCorrectionSteps;
    VectorXd second = p;
    VectorXd y = multipliers;
    const InteriorPointResult solved = solve_quadratic(interior, second, y, now);
    if (!solved.solved || !second.allFinite()) return false;
    next = z + second;
    multipliers = y;
    program_.evaluate(next, trial_r_, trial_c_);
    return true;
  }

  NonlinearProgram& program_;
  const SequentialQuadraticOptions& options_;
  InteriorPoint interior_;
  QuadraticProgram quadratic_;
  StepFilter filter_;
  double dearest_ = 0.0;     ///< largest penalty of an elastic row
  double error_ = INFINITY;  ///< least error so far at this price
  double mu_ = 1.0;          ///< initial slack x multiplier of the next subproblem
  bool untried_ = false;     ///< true if no step was found since the price was raised
  bool stopped_ = false;     ///< true if the observer stopped the solver
  VectorXd residual_, row_, gradient_, change_r_, change_c_, trial_r_, trial_c_;
};

}  // namespace

SequentialQuadraticResult solve(NonlinearProgram& program, VectorXd z, VectorXd multipliers,
                                const SequentialQuadraticOptions& options, const PlanObserver& observer) {
  return Solver(program, options).run(std::move(z), std::move(multipliers), observer);
}

}  // namespace armtune::internal
