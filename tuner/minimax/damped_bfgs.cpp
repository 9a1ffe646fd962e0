#include "tuner/minimax/damped_bfgs.hpp"

namespace armtune::internal {
namespace {

/// Least curvature along the step after the update, as a share of the curvature before it.
constexpr double kLeastCurvature = 0.2;

}  // namespace

void update_damped_bfgs(Eigen::MatrixXd& B, const Eigen::VectorXd& s, const Eigen::VectorXd& y) {
  const Eigen::VectorXd Bs = B * s;
  const double sBs = s.dot(Bs);
  if (!(sBs > 0.0) || !y.allFinite()) return;
  const double sy = s.dot(y);
  // r = theta y + (1 - theta) B s, with s^T r >= kLeastCurvature s^T B s. (N&W 18.14, 18.15)
  const double theta = sy >= kLeastCurvature * sBs ? 1.0 : (1.0 - kLeastCurvature) * sBs / (sBs - sy);
  const Eigen::VectorXd r = theta * y + (1.0 - theta) * Bs;
  // B+ = B - B s s^T B / (s^T B s) + r r^T / (s^T r). (N&W 18.16)
  B += r * r.transpose() / s.dot(r) - Bs * Bs.transpose() / sBs;
}

}  // namespace armtune::internal
