#include "tuner/planning/solver/interior_point.hpp"

#include <algorithm>

#include <cmath>
#include <limits>

namespace armtune {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPrimalProximal = 1e-8;
constexpr double kDualProximal = 1e-7;
constexpr int kRefinements = 3;
constexpr double kLinearAccuracy = 1e-4;  // of a direction, beside the residuals it removes
constexpr double kStepBack = 0.995;       // fraction to the boundary

/// One direction of all unknowns.
struct Direction {
  VectorXd x, y, w, upper, lower, over, under;
};

}  // namespace

/// The unknowns beside x: y multiplies G x - w - over + under = 0, w lies between the bounds.
struct InteriorPoint::Iterate {
  VectorXd w;      ///< value of the row, strictly between its bounds; of an equation the bound
  VectorXd upper;  ///< multiplier of w <= upper bound, 0 where there is none
  VectorXd lower;
  VectorXd over;   ///< elastic violation of the upper bound; its multiplier is penalty - y
  VectorXd under;  ///< of the lower one; its multiplier is penalty + y
};

InteriorPoint::InteriorPoint(int variables, const BlockRows& residuals, const CurvatureBlocks& curvature,
                             const BlockRows& rows)
    : normal_(variables, curvature, {&residuals, &rows}), cholesky_(normal_.matrix()) {}

namespace {

bool is_equation(const RowBounds& bounds, Index i) {
  return bounds.lower[i] == bounds.upper[i];
}
bool has_upper(const RowBounds& bounds, Index i) {
  return std::isfinite(bounds.upper[i]) && !is_equation(bounds, i);
}
bool has_lower(const RowBounds& bounds, Index i) {
  return std::isfinite(bounds.lower[i]) && !is_equation(bounds, i);
}
bool is_elastic(const RowBounds& bounds, Index i) {
  return std::isfinite(bounds.penalty[i]);
}

}  // namespace

InteriorPointResult InteriorPoint::solve(const QuadraticProgram& program, const InteriorPointOptions& options,
                                         VectorXd& x, VectorXd& y) {
  const BlockRows& R = *program.residuals;
  const BlockRows& G = *program.rows;
  const RowBounds& bounds = program.bounds;
  const Index n = x.size();
  const Index m = G.rows();
  const double mu0 = options.start_mu;

  Iterate it;
  it.w.resize(m);
  it.upper.setZero(m);
  it.lower.setZero(m);
  it.over.setZero(m);
  it.under.setZero(m);
  VectorXd Gx(m), Rx(R.rows());
  G.multiply(x, Gx);
  Index pairs = 0;
  for (Index i = 0; i < m; ++i) {
    if (is_elastic(bounds, i)) {
      const double rho = bounds.penalty[i];
      y[i] = std::clamp(y[i], -0.9 * rho, 0.9 * rho);
    }
    if (is_equation(bounds, i)) {
      it.w[i] = bounds.lower[i];
    } else {
      // Where y says that a bound is active, w starts beside that bound and y is kept.
      const double range = bounds.upper[i] - bounds.lower[i];
      const double root = std::sqrt(mu0);
      const double room = std::min(0.25 * range, root);
      double w = Gx[i];
      if (has_upper(bounds, i))
        w = y[i] > root ? bounds.upper[i] - std::min(room, mu0 / y[i]) : std::min(w, bounds.upper[i] - room);
      if (has_lower(bounds, i))
        w = y[i] < -root ? bounds.lower[i] + std::min(room, -mu0 / y[i])
                         : std::max(w, bounds.lower[i] + room);
      it.w[i] = w;
      if (has_upper(bounds, i)) it.upper[i] = std::max(y[i], mu0 / (bounds.upper[i] - w));
      if (has_lower(bounds, i)) it.lower[i] = std::max(-y[i], mu0 / (w - bounds.lower[i]));
      y[i] = it.upper[i] - it.lower[i];
      if (is_elastic(bounds, i)) y[i] = std::clamp(y[i], -0.9 * bounds.penalty[i], 0.9 * bounds.penalty[i]);
    }
    if (is_elastic(bounds, i)) {
      it.over[i] = mu0 / (bounds.penalty[i] - y[i]);
      it.under[i] = mu0 / (bounds.penalty[i] + y[i]);
    }
    pairs +=
        (has_upper(bounds, i) ? 1 : 0) + (has_lower(bounds, i) ? 1 : 0) + (is_elastic(bounds, i) ? 2 : 0);
  }

  const auto complementarity = [&](const Iterate& at, const VectorXd& multipliers) {
    double sum = 0.0;
    for (Index i = 0; i < m; ++i) {
      if (has_upper(bounds, i)) sum += at.upper[i] * (bounds.upper[i] - at.w[i]);
      if (has_lower(bounds, i)) sum += at.lower[i] * (at.w[i] - bounds.lower[i]);
      if (is_elastic(bounds, i))
        sum += at.over[i] * (bounds.penalty[i] - multipliers[i]) +
               at.under[i] * (bounds.penalty[i] + multipliers[i]);
    }
    return pairs == 0 ? 0.0 : sum / static_cast<double>(pairs);
  };

  VectorXd rd(n), rp(m), rw(m), D(m), inverse_D(m), e(m), r(n), r1(n), r2(m), Hx(n), theta(m);
  Direction step, corrector;
  const auto hessian_times = [&](const VectorXd& v, VectorXd& result) {
    R.multiply(v, Rx);
    result = program.damping.cwiseProduct(v);
    R.add_transposed(Rx, result);
    program.curvature->add_product(v, result);
  };

  // Right-hand sides of the pairs, then the direction that solves the linearised conditions.
  VectorXd cu(m), cl(m), co(m), cn(m);
  const auto direction = [&](Direction& d, int refinements) {
    for (Index i = 0; i < m; ++i) {
      double right = rp[i];
      if (theta[i] > 0.0) {
        double t = rw[i];
        if (has_upper(bounds, i)) t -= cu[i] / (bounds.upper[i] - it.w[i]);
        if (has_lower(bounds, i)) t += cl[i] / (it.w[i] - bounds.lower[i]);
        right += t / theta[i];
      }
      if (is_elastic(bounds, i)) {
        const double rho = bounds.penalty[i];
        right += co[i] / (rho - y[i]) - cn[i] / (rho + y[i]);
      }
      e[i] = right;
    }
    // [H + delta, G^T; G, -1/D] (dx, dy) = (rd, e), condensed, then refined against the system as it stands.
    d.x.setZero(n);
    d.y.setZero(m);
    r1 = rd;
    r2 = e;
    for (int pass = 0;; ++pass) {
      r = r1;
      r2.array() *= D.array();
      G.add_transposed(r2, r);
      cholesky_.solve(r);
      d.x += r;
      G.multiply(r, Gx);
      d.y += D.cwiseProduct(Gx) - r2;
      if (pass == refinements) break;
      hessian_times(d.x, Hx);
      r1 = rd - Hx - kPrimalProximal * d.x;
      r2 = -d.y;
      G.add_transposed(r2, r1);
      G.multiply(d.x, Gx);
      r2 = e - Gx + inverse_D.cwiseProduct(d.y);
      if (r1.lpNorm<Eigen::Infinity>() <= kLinearAccuracy * rd.lpNorm<Eigen::Infinity>() + 1e-13 &&
          r2.lpNorm<Eigen::Infinity>() <= kLinearAccuracy * e.lpNorm<Eigen::Infinity>() + 1e-13)
        break;
    }
    d.w.setZero(m);
    d.upper.setZero(m);
    d.lower.setZero(m);
    d.over.setZero(m);
    d.under.setZero(m);
    for (Index i = 0; i < m; ++i) {
      if (theta[i] > 0.0) {
        double t = rw[i] + d.y[i];
        if (has_upper(bounds, i)) t -= cu[i] / (bounds.upper[i] - it.w[i]);
        if (has_lower(bounds, i)) t += cl[i] / (it.w[i] - bounds.lower[i]);
        d.w[i] = t / theta[i];
        if (has_upper(bounds, i)) d.upper[i] = (cu[i] + it.upper[i] * d.w[i]) / (bounds.upper[i] - it.w[i]);
        if (has_lower(bounds, i)) d.lower[i] = (cl[i] - it.lower[i] * d.w[i]) / (it.w[i] - bounds.lower[i]);
      }
      if (is_elastic(bounds, i)) {
        const double rho = bounds.penalty[i];
        d.over[i] = (co[i] + it.over[i] * d.y[i]) / (rho - y[i]);
        d.under[i] = (cn[i] - it.under[i] * d.y[i]) / (rho + y[i]);
      }
    }
  };
  const auto longest = [&](const Direction& d) {
    double alpha = 1.0;
    const auto limit = [&](double value, double change) {
      if (change < 0.0) alpha = std::min(alpha, -value / change);
    };
    for (Index i = 0; i < m; ++i) {
      if (has_upper(bounds, i)) {
        limit(bounds.upper[i] - it.w[i], -d.w[i]);
        limit(it.upper[i], d.upper[i]);
      }
      if (has_lower(bounds, i)) {
        limit(it.w[i] - bounds.lower[i], d.w[i]);
        limit(it.lower[i], d.lower[i]);
      }
      if (is_elastic(bounds, i)) {
        limit(it.over[i], d.over[i]);
        limit(it.under[i], d.under[i]);
        limit(bounds.penalty[i] - y[i], -d.y[i]);
        limit(bounds.penalty[i] + y[i], d.y[i]);
      }
    }
    return alpha;
  };

  InteriorPointResult result;
  for (;; ++result.iterations) {
    hessian_times(x, Hx);
    rd = -Hx - program.gradient;
    rp = -y;  // as scratch
    G.add_transposed(rp, rd);
    G.multiply(x, Gx);
    rp = it.w + it.over - it.under - Gx;
    for (Index i = 0; i < m; ++i) rw[i] = is_equation(bounds, i) ? 0.0 : y[i] - it.upper[i] + it.lower[i];
    const double mu = complementarity(it, y);
    result.stationarity = std::max(rd.lpNorm<Eigen::Infinity>(), rw.lpNorm<Eigen::Infinity>());
    result.infeasibility = rp.lpNorm<Eigen::Infinity>();
    result.complementarity = mu;
    const double rounding = std::max(1.0, 1e-2 * y.lpNorm<Eigen::Infinity>());  // of large multipliers
    result.solved = result.stationarity <= rounding * options.tolerance &&
                    result.infeasibility <= options.tolerance && mu <= rounding * options.tolerance;
    if (result.solved || result.iterations == options.max_iterations || !std::isfinite(result.stationarity))
      break;

    for (Index i = 0; i < m; ++i) {
      theta[i] = (has_upper(bounds, i) ? it.upper[i] / (bounds.upper[i] - it.w[i]) : 0.0) +
                 (has_lower(bounds, i) ? it.lower[i] / (it.w[i] - bounds.lower[i]) : 0.0);
      inverse_D[i] = kDualProximal + (theta[i] > 0.0 ? 1.0 / theta[i] : 0.0);
      if (is_elastic(bounds, i))
        inverse_D[i] += it.over[i] / (bounds.penalty[i] - y[i]) + it.under[i] / (bounds.penalty[i] + y[i]);
      D[i] = 1.0 / inverse_D[i];
    }
    static const VectorXd ones;
    normal_.assemble((program.damping.array() + kPrimalProximal).matrix(), {&ones, &D});
    if (!cholesky_.factorize(normal_.matrix())) break;

    const auto pair_terms = [&](double target, const Direction* affine) {
      for (Index i = 0; i < m; ++i) {
        if (has_upper(bounds, i))
          cu[i] = target - it.upper[i] * (bounds.upper[i] - it.w[i]) +
                  (affine == nullptr ? 0.0 : affine->upper[i] * affine->w[i]);
        if (has_lower(bounds, i))
          cl[i] = target - it.lower[i] * (it.w[i] - bounds.lower[i]) -
                  (affine == nullptr ? 0.0 : affine->lower[i] * affine->w[i]);
        if (is_elastic(bounds, i)) {
          const double rho = bounds.penalty[i];
          co[i] =
              target - it.over[i] * (rho - y[i]) + (affine == nullptr ? 0.0 : affine->over[i] * affine->y[i]);
          cn[i] = target - it.under[i] * (rho + y[i]) -
                  (affine == nullptr ? 0.0 : affine->under[i] * affine->y[i]);
        }
      }
    };
    pair_terms(0.0, nullptr);
    direction(step, pairs > 0 ? 0 : kRefinements);
    if (pairs > 0) {
      const double reach = longest(step);
      Iterate moved = it;
      moved.w += reach * step.w;
      moved.upper += reach * step.upper;
      moved.lower += reach * step.lower;
      moved.over += reach * step.over;
      moved.under += reach * step.under;
      const double affine_mu = complementarity(moved, y + reach * step.y);
      const double ratio = affine_mu / mu;
      pair_terms(std::max(ratio * ratio * ratio * mu, 0.1 * options.tolerance), &step);
      direction(corrector, kRefinements);
      step.x.swap(corrector.x);
      step.y.swap(corrector.y);
      step.w.swap(corrector.w);
      step.upper.swap(corrector.upper);
      step.lower.swap(corrector.lower);
      step.over.swap(corrector.over);
      step.under.swap(corrector.under);
    }
    const double alpha = std::min(1.0, kStepBack * longest(step));
    x += alpha * step.x;
    y += alpha * step.y;
    it.w += alpha * step.w;
    it.upper += alpha * step.upper;
    it.lower += alpha * step.lower;
    it.over += alpha * step.over;
    it.under += alpha * step.under;
  }
  return result;
}

}  // namespace armtune
