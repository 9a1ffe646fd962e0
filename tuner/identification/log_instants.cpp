#include "tuner/identification/log_instants.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Median of |z| for a standard normal z.
constexpr double kNormalMedian = 0.6745;
/// Variance of the second differences of white noise, as a multiple of the noise's variance: 1 + 4 + 1.
constexpr double kVarianceOfSecondDifference = 6.0;

}  // namespace

void LogInstants::add_logged_torque(const JointVector& torque) {
  if (before_last_.size() > 0 && last_.size() > 0)
    second_differences_.add(filter_norm_ * (torque - 2.0 * last_ + before_last_).cwiseAbs());
  before_last_ = last_;
  last_ = torque;
}

JointVector LogInstants::torque_noise() const {
  const std::vector<JointVector>& differences = second_differences_.kept();
  if (differences.empty()) return {};
  JointVector noise(differences.front().size());
  std::vector<double> sizes(differences.size());
  for (Eigen::Index j = 0; j < noise.size(); ++j) {
    std::transform(differences.begin(), differences.end(), sizes.begin(),
                   [j](const JointVector& difference) { return difference[j]; });
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    noise[j] = *middle / (kNormalMedian * std::sqrt(kVarianceOfSecondDifference));
  }
  return noise;
}

}  // namespace armtune::internal
