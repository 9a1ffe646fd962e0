#include "core/control/velocity_governor.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Exponent p = 2^kSquarings of the norm. It is the smallest power of two for which the norm of 12 equal
/// shares is at most 1.17 times one of them.
constexpr int kSquarings = 4;
constexpr double kNorm = 1 << kSquarings;

double to_the_norm(double x) {
  for (int i = 0; i < kSquarings; ++i) x *= x;
  return x;
}

}  // namespace

double govern(const JointVector& bound, JointReference& reference) {
  const JointVector share = reference.velocity.cwiseQuotient(bound);
  const double largest = share.cwiseAbs().maxCoeff();
  // Below this even the p-norm of equal shares stays under the knee.
  const double n = static_cast<double>(share.size());
  if (!(largest * std::pow(n, 1.0 / kNorm) > kGovernorKnee)) return 1.0;

  double sum = 0.0;
  double sum_dot = 0.0;  // derivative of sum, divided by p and multiplied by largest
  for (Eigen::Index i = 0; i < share.size(); ++i) {
    const double relative = share[i] / largest;
    const double power = to_the_norm(relative);
    sum += power;
    if (power > 0.0) sum_dot += power / relative * (reference.acceleration[i] / bound[i]);
  }
  const double root = std::pow(sum, 1.0 / kNorm);
  const double r = largest * root;
  if (r <= kGovernorKnee) return 1.0;
  const double r_dot = root / sum * sum_dot;
  constexpr double kRoom = 1.0 - kGovernorKnee;
  const double bend = std::tanh((r - kGovernorKnee) / kRoom);
  const double f = kGovernorKnee + kRoom * bend;
  const double f_slope = 1.0 - bend * bend;
  const double sigma = f / r;
  // The motion is slowed by the factor sigma, and so is the change of r.
  const double sigma_dot = (f_slope - sigma) / r * (sigma * r_dot);
  reference.acceleration = sigma * sigma * reference.acceleration + sigma_dot * reference.velocity;
  reference.velocity *= sigma;
  return sigma;
}

double shortest_duration(const TaskInverse& inverse, const Vec6& displacement, const JointVector& bound) {
  JointVector way;
  inverse.apply(displacement, way);
  const double share = way.cwiseQuotient(bound).cwiseAbs().maxCoeff();
  return std::max(15.0 / 8.0 * share, std::sqrt(10.0 / std::sqrt(3.0) * share * kRampTime));
}

}  // namespace armtune::internal
