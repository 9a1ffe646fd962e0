#pragma once
// The robust regression behind the causes of a misfit. Every joint's residual is a linear function of its own
// unknowns and of those of the whole arm. The normal equations of all unknowns are computed once; subsets are
// solved from them.

#include <vector>

#include "tuner/validation/torque_rows.hpp"

namespace armtune::internal {

/// Unknowns of each joint: offset, Coulomb friction, viscous friction, rotor inertia, scale of the torque
/// minus 1.
inline constexpr int kLocalTerms = 5;
/// Unknowns of the arm: mass and first moment of a payload, change of the vector of gravity.
inline constexpr int kSharedTerms = 7;

struct ResidualFit {
  Eigen::VectorXd solution;  ///< of all unknowns; zero for those that were left out
  JointVector mean_square;   ///< weighted mean square of every joint's residual that remains (n)
};

class ResidualMoments {
 public:
  /// Computes Huber's weights from the fit of all unknowns, and the moments with them. negligible: share of a
  /// joint's RMS torque below which a residual does not matter.
  ResidualMoments(const TorqueRows& rows, double negligible);

  int unknowns() const { return static_cast<int>(moment_.size()) * kLocalTerms + kSharedTerms; }
  /// Fits the used unknowns. Their order: kLocalTerms of each joint, then kSharedTerms.
  ResidualFit fit(const std::vector<bool>& used) const;
  /// Returns the weighted mean square of every joint's residual (n).
  const JointVector& raw() const { return raw_; }
  /// Returns the mean square of every joint's measured torque (n).
  const JointVector& torque() const { return torque_; }
  /// Returns the mean square of every joint's negligible residual (n), above zero.
  const JointVector& floor() const { return floor_; }

 private:
  static constexpr int kTerms = kLocalTerms + kSharedTerms;
  using Moment = Eigen::Matrix<double, kTerms + 1, kTerms + 1>;

  void add_moments(const TorqueRows& rows, const std::vector<Eigen::VectorXd>& weight);
  std::vector<Eigen::VectorXd> huber_weights(const TorqueRows& rows, const Eigen::VectorXd& solution) const;
  /// Returns the solution of a joint's own terms and the arm's, in the order of its moments.
  Eigen::Matrix<double, kTerms, 1> terms_of(std::size_t joint, const Eigen::VectorXd& solution) const;

  std::vector<Moment> moment_;  ///< [joint]: weighted mean of y y^T, y = (terms, residual)
  JointVector raw_, torque_, floor_;
  JointVector weight_;  ///< of each joint in the fit of the arm's unknowns (n)
};

}  // namespace armtune::internal
