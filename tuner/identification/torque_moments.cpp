#include "tuner/identification/torque_moments.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// A variance below this share of the mean square is a rounding error of a constant.
constexpr double kConstantTorque = 1e-12;

}  // namespace

void TorqueMoments::add(const Eigen::MatrixXd& rows) {
  ++count_;
  sums_ += rows;
  for (std::size_t j = 0; j < moments_.size(); ++j) {
    const auto row = rows.row(static_cast<Eigen::Index>(j));
    moments_[j].noalias() += row.transpose() * row;
  }
}

Eigen::VectorXd TorqueMoments::rms(const Eigen::VectorXd& combination) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(moments_.size()));
  if (count_ == 0) return result;
  for (std::size_t j = 0; j < moments_.size(); ++j) {
    const double squares = combination.dot(moments_[j] * combination);
    result[static_cast<Eigen::Index>(j)] = std::sqrt(std::max(0.0, squares) / static_cast<double>(count_));
  }
  return result;
}

Eigen::VectorXd TorqueMoments::variance(const Eigen::VectorXd& combination) const {
  const Eigen::VectorXd mean = sums_ * combination / static_cast<double>(std::max(1L, count_));
  return rms(combination).cwiseAbs2() - mean.cwiseAbs2();
}

Eigen::VectorXd TorqueMoments::torque_rms() const {
  return rms(Eigen::VectorXd::Unit(moments_.front().cols(), moments_.front().cols() - 1));
}

Eigen::VectorXd TorqueMoments::predicted_rms(const Eigen::VectorXd& theta_base) const {
  Eigen::VectorXd combination(theta_base.size() + 1);
  combination << theta_base, 0.0;
  return rms(combination);
}

Eigen::VectorXd TorqueMoments::residual_rms(const Eigen::VectorXd& theta_base) const {
  Eigen::VectorXd combination(theta_base.size() + 1);
  combination << -theta_base, 1.0;
  return rms(combination);
}

Eigen::VectorXd TorqueMoments::explained(const Eigen::VectorXd& theta_base) const {
  Eigen::VectorXd combination(theta_base.size() + 1);
  combination << -theta_base, 1.0;
  const Eigen::VectorXd residual = variance(combination);
  const Eigen::VectorXd torque = variance(Eigen::VectorXd::Unit(combination.size(), theta_base.size()));
  const Eigen::VectorXd rounding = kConstantTorque * torque_rms().cwiseAbs2();
  Eigen::VectorXd share = Eigen::VectorXd::Zero(torque.size());
  for (Eigen::Index j = 0; j < share.size(); ++j) {
    if (torque[j] > rounding[j]) share[j] = 1.0 - std::max(0.0, residual[j]) / torque[j];
  }
  return share;
}

}  // namespace armtune::internal
