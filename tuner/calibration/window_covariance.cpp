#include "tuner/calibration/window_covariance.hpp"

#include <Eigen/Cholesky>
#include <algorithm>

namespace armtune::internal {
namespace {

/// Returns the 95 % quantile of Student's distribution with the given degrees of freedom, relative to that of
/// the normal distribution, by the series of Abramowitz and Stegun, 26.7.5. It is within 1 % from 3 degrees
/// of freedom on.
double student_factor(double freedom) {
  constexpr double x = 1.959964;
  constexpr double x2 = x * x;
  const double first = (x2 + 1.0) / 4.0;
  const double second = ((5.0 * x2 + 16.0) * x2 + 3.0) / 96.0;
  const double third = (((3.0 * x2 + 19.0) * x2 + 17.0) * x2 - 15.0) / 384.0;
  return 1.0 + first / freedom + second / (freedom * freedom) + third / (freedom * freedom * freedom);
}

}  // namespace

Eigen::MatrixXd window_covariance(const std::vector<WindowInformation>& windows) {
  const Eigen::Index p = windows.front().score.size();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(p, p);
  Eigen::MatrixXd H = identity;
  for (const WindowInformation& w : windows) H += w.information;
  const Eigen::MatrixXd inverse = H.llt().solve(identity);
  Eigen::ArrayXd scatter = Eigen::ArrayXd::Zero(p);
  for (const WindowInformation& w : windows)
    scatter += (H - w.information).llt().solve(w.score).array().square();
  const auto count = static_cast<double>(windows.size());
  const double factor = student_factor(std::max(1.0, count - 1.0));
  const Eigen::ArrayXd white = inverse.diagonal().array();
  const Eigen::ArrayXd between =
      inverse.colwise().squaredNorm().transpose().array() + factor * factor * (count - 1.0) / count * scatter;
  const Eigen::VectorXd ratio = (white.max(between) / white).sqrt();
  return ratio.asDiagonal() * inverse * ratio.asDiagonal();
}

}  // namespace armtune::internal
