#pragma once
// The covariance of parameters that are fitted to windows whose residuals are correlated in time. Lost
// commands, for example, push the arm off its simulated path for the rest of a window. Windows are nearly
// independent of each other, so the scatter of their contributions to the fit shows how uncertain it is. This
// is the jackknife over clusters (CR3: Bell and McCaffrey, Bias reduction in standard errors for linear
// regression with multi-stage samples, 2002).

#include <Eigen/Core>
#include <vector>

namespace armtune::internal {

/// What a window says about p standardised parameters at the solution of a fit.
struct WindowInformation {
  Eigen::MatrixXd information;  ///< p x p, second derivative of its loss
  Eigen::VectorXd score;        ///< p, gradient of its loss
};

/// Returns the covariance (p x p) of parameters with independent standard normal priors. With H = I + sum_w
/// H_w, the variance of parameter i is the larger one of (H^-1)_ii, which holds for white residuals of the
/// assumed size, and
///   (H^-2)_ii + (W - 1)/W sum_w ((H - H_w)^-1 g_w)_i^2,
/// which holds for residuals that are correlated within W windows. (H - H_w)^-1 g_w is the change of the
/// solution if window w is left out. The sum is multiplied by the square of t / 1.96, where t is
/// the 95 % quantile of Student's distribution with W - 1 degrees of freedom. The correlations are those of
/// H^-1.
Eigen::MatrixXd window_covariance(const std::vector<WindowInformation>& windows);

}  // namespace armtune::internal
