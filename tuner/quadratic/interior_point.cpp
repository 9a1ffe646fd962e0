#include "tuner/quadratic/interior_point.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/quadratic/interior_point_iteration.hpp"

namespace armtune::internal {
namespace {

// If rounding errors prevent further progress, a solution close to the tolerances is accepted.
constexpr double kProgress = 0.9;
constexpr int kPatience = 8;
constexpr int kPatienceFarAway = 25;
constexpr double kNearEnough = 30.0;  // times the tolerances

}  // namespace

InteriorPoint::InteriorPoint(int variables, const BlockRows& residuals, const CurvatureBlocks& curvature,
                             const BlockRows& rows, MakeCholesky make_cholesky)
    : normal_(variables, curvature, {&residuals, &rows}), cholesky_(make_cholesky(normal_.matrix())) {}

InteriorPointResult InteriorPoint::solve(const QuadraticProgram& program, const InteriorPointOptions& options,
                                         Eigen::VectorXd& x, Eigen::VectorXd& y) {
  InteriorPointIteration iteration(program, normal_, *cholesky_);
  iteration.start(x, y, options.start_mu);
  InteriorPointResult result;
  double best = INFINITY;
  int best_iteration = 0;
  for (;; ++result.iterations) {
    iteration.measure(result);
    // Large multipliers cause large rounding errors.
    const double rounding = std::max(1.0, 1e-2 * iteration.at().y.lpNorm<Eigen::Infinity>());
    const double worst = std::max({result.stationarity / (rounding * options.stationarity),
                                   result.infeasibility / options.infeasibility,
                                   result.complementarity / (rounding * options.complementarity)});
    if (worst < kProgress * best) {
      best = worst;
      best_iteration = result.iterations;
    }
    const bool near = worst <= kNearEnough;
    const bool stalled = result.iterations - best_iteration >= (near ? kPatience : kPatienceFarAway);
    result.solved = worst <= 1.0 || (stalled && near);
    if (result.solved || stalled || result.iterations == options.max_iterations || !std::isfinite(worst))
      break;
    if (options.go_on && !options.go_on()) {
      result.interrupted = true;
      break;
    }
    if (!iteration.advance(options)) break;
  }
  x = iteration.at().x;
  y = iteration.at().y;
  return result;
}

}  // namespace armtune::internal
