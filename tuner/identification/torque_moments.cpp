#include "tuner/identification/torque_moments.hpp"

#include <cmath>

namespace armtune::internal {

void TorqueMoments::add(const Eigen::MatrixXd& rows) {
  ++count_;
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

}  // namespace armtune::internal
