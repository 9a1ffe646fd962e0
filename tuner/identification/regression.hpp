#pragma once
// Estimates an arm's base parameters theta_base (base_parameters.hpp) by weighted least squares. The data
// are any number of rows (Y_base, tau), that is, a joint's row of the regressor and its torque. The rows
// themselves are not stored. One triangular QR factor is stored for each joint, so that the weights of the
// joints can change without reading the logs again. The moments that the covariance needs are stored as
// well.

#include <Eigen/Core>
#include <vector>

namespace armtune::internal {

struct Estimate {
  Eigen::VectorXd theta;            ///< theta_base (rank)
  Eigen::MatrixXd covariance;       ///< of theta_base; near that of the prior where the rows determine little
  Eigen::VectorXd torque_residual;  ///< RMS per joint (n) [N m, N]
  /// Base parameters (0 .. rank - 1, in order) that the rows hardly excite, so that they stay near the prior.
  std::vector<int> not_excited;
  double condition = 0.0;  ///< condition number of the weighted regressor, columns of unit length
  long rows = 0;           ///< number of rows per joint

  /// Returns the standard deviations (rank); infinite for base parameters that were not excited.
  Eigen::VectorXd deviation() const;
};

/// A weak prior for theta_base. Its mean is `value` (rank), and its standard deviation is a hundred times
/// `size` (rank, above zero).
struct WeakPrior {
  Eigen::VectorXd value;
  Eigen::VectorXd size;
};

class Regression {
 public:
  Regression(int joints, int rank);

  /// Adds the rows of one instant: n x (rank + 1), columns (Y_base, tau). The caller has multiplied each row
  /// by the root of its weight. The instants of a log must come in order; `begin_log` separates logs.
  void add(const Eigen::MatrixXd& rows);
  void begin_log() { last_.clear(); }

  /// Solves the weighted least squares. The weights of the joints are 1/sigma_j^2, where sigma_j is the RMS
  /// of joint j's residual. Solution and weights are computed alternately until they converge. The prior is
  /// so weak that it counts only along directions that the rows do not excite. The covariance is the
  /// sandwich estimator with the residuals' autocorrelation (White, Asymptotic Theory for Econometricians,
  /// 1984, chapter 6), since rows filtered from the same samples are not independent.
  Estimate solve(const WeakPrior& prior);

 private:
  void compress(std::size_t joint);
  Eigen::VectorXd solve_weighted(const Eigen::VectorXd& deviation, const WeakPrior& prior,
                                 Estimate& out) const;
  Eigen::MatrixXd covariance(const Eigen::VectorXd& a, const Eigen::VectorXd& deviation,
                             const WeakPrior& prior, const Eigen::MatrixXd& last) const;
  double autocovariance(std::size_t joint, std::size_t lag, const Eigen::VectorXd& a) const;

  int joints_;
  int rank_;
  long rows_ = 0;
  std::vector<std::vector<Eigen::VectorXd>> waiting_;  ///< [joint]: rows not yet in the factor
  std::vector<Eigen::MatrixXd> factor_;                ///< [joint]: triangular factor of (Y_base, tau)
  std::vector<std::vector<Eigen::MatrixXd>> moments_;  ///< [joint][lag]: sum of y_t y_(t+lag)^T, y: a row
  std::vector<long> pairs_;                            ///< [lag]: number of pairs of instants
  std::vector<Eigen::MatrixXd> last_;                  ///< rows of the last instants, newest first
};

}  // namespace armtune::internal
