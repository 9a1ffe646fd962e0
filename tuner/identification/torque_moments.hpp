#pragma once
// Computes statistics of each joint's residual tau - Y_base * theta_base for any base parameters theta_base,
// where tau are the logged torques and Y_base is the regressor. Only the first two moments of the rows
// (Y_base, tau) are stored, not the rows. Identification and validation both compute their residuals here. In
// validation, Y_base has one column, the torque that the unfitted model predicts, and theta_base is 1.

#include <Eigen/Core>
#include <vector>

namespace armtune::internal {

class TorqueMoments {
 public:
  TorqueMoments(int joints, int rank)
      : moments_(static_cast<std::size_t>(joints), Eigen::MatrixXd::Zero(rank + 1, rank + 1)),
        sums_(Eigen::MatrixXd::Zero(joints, rank + 1)) {}

  /// Adds the rows of one instant: n x (rank + 1), columns (Y_base, tau).
  void add(const Eigen::MatrixXd& rows);
  /// Returns the number of instants added.
  long count() const { return count_; }
  /// Returns the RMS of the torque of every joint (n) [N m, N]; zeros without rows.
  Eigen::VectorXd torque_rms() const;
  /// Returns the RMS of Y_base * theta_base of every joint (n) [N m, N]; zeros without rows.
  Eigen::VectorXd predicted_rms(const Eigen::VectorXd& theta_base) const;
  /// Returns the RMS of tau - Y_base * theta_base of every joint (n) [N m, N]; zeros without rows. Rounding
  /// errors are about 1e-8 of the torque.
  Eigen::VectorXd residual_rms(const Eigen::VectorXd& theta_base) const;
  /// Returns the share of the variance of every joint's torque that Y_base * theta_base explains (n): 1 -
  /// var(tau - Y_base * theta_base) / var(tau), each variance about its own mean. Zero where tau is constant.
  Eigen::VectorXd explained(const Eigen::VectorXd& theta_base) const;

 private:
  Eigen::VectorXd rms(const Eigen::VectorXd& combination) const;
  Eigen::VectorXd variance(const Eigen::VectorXd& combination) const;

  std::vector<Eigen::MatrixXd> moments_;  ///< [joint]: sum of y y^T, y = (Y_base, tau)
  Eigen::MatrixXd sums_;                  ///< n x (rank + 1): sums of y
  long count_ = 0;
};

}  // namespace armtune::internal
