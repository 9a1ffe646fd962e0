#include "tuner/validation/residual_moments.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Huber's constant, as in identification: 95 % of the efficiency of least squares on normal errors.
constexpr double kHuberBound = 1.345;
/// Standard deviation of normal errors over their median absolute value.
constexpr double kNormalFromMedian = 1.4826;
constexpr int kRobustPasses = 4;
/// Relative size of the ridge that keeps unknowns without influence at zero.
constexpr double kRidge = 1e-9;

/// Returns the terms of one row and its residual.
Eigen::Matrix<double, kLocalTerms + kSharedTerms + 1, 1> terms(const Eigen::MatrixXd& rows, Eigen::Index i) {
  Eigen::Matrix<double, kLocalTerms + kSharedTerms + 1, 1> y;
  y << 1.0, rows(i, kCoulombDirection), rows(i, kJointVelocity), rows(i, kJointAcceleration),
      rows(i, kPredictedTorque), rows.row(i).segment<4>(kPayloadMass).transpose(),
      rows.row(i).segment<3>(kGravityX).transpose(), rows(i, kMeasuredTorque) - rows(i, kPredictedTorque);
  return y;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

ResidualMoments::ResidualMoments(const TorqueRows& rows, double negligible) {
  const auto n = static_cast<Eigen::Index>(rows.joint.size());
  torque_.resize(n);
  for (Eigen::Index j = 0; j < n; ++j)
    torque_[j] = rows.joint[static_cast<std::size_t>(j)].col(kMeasuredTorque).squaredNorm() /
                 static_cast<double>(rows.count());
  // Half of a torque that does not matter; the smallest normal torque where a joint has none at all.
  floor_ = (0.25 * negligible * negligible * torque_).cwiseMax(1e-12 * torque_.maxCoeff() + 1e-12);
  std::vector<Eigen::VectorXd> weight(rows.joint.size(), Eigen::VectorXd::Ones(rows.count()));
  weight_ = JointVector::Ones(n);
  for (int pass = 0;; ++pass) {
    add_moments(rows, weight);
    const ResidualFit all = fit(std::vector<bool>(static_cast<std::size_t>(unknowns()), true));
    weight_ = (all.mean_square + floor_).cwiseInverse();
    if (pass == kRobustPasses) break;
    weight = huber_weights(rows, all.solution);
  }
}

void ResidualMoments::add_moments(const TorqueRows& rows, const std::vector<Eigen::VectorXd>& weight) {
  moment_.assign(rows.joint.size(), Moment::Zero());
  raw_.resize(static_cast<Eigen::Index>(rows.joint.size()));
  for (std::size_t j = 0; j < rows.joint.size(); ++j) {
    for (Eigen::Index i = 0; i < rows.count(); ++i) {
      const auto y = terms(rows.joint[j], i);
      moment_[j].noalias() += weight[j][i] * y * y.transpose();
    }
    moment_[j] /= weight[j].sum();
    raw_[static_cast<Eigen::Index>(j)] = moment_[j](kTerms, kTerms);
  }
}

std::vector<Eigen::VectorXd> ResidualMoments::huber_weights(const TorqueRows& rows,
                                                            const Eigen::VectorXd& solution) const {
  std::vector<Eigen::VectorXd> weight(rows.joint.size(), Eigen::VectorXd::Ones(rows.count()));
  std::vector<double> left(static_cast<std::size_t>(rows.count()));
  for (std::size_t j = 0; j < rows.joint.size(); ++j) {
    const auto own = terms_of(j, solution);
    for (Eigen::Index i = 0; i < rows.count(); ++i) {
      const auto y = terms(rows.joint[j], i);
      left[static_cast<std::size_t>(i)] = std::abs(y[kTerms] - y.head<kTerms>().dot(own));
    }
    const double bound = kHuberBound * std::max(kNormalFromMedian * median(left),
                                                std::sqrt(floor_[static_cast<Eigen::Index>(j)]));
    for (Eigen::Index i = 0; i < rows.count(); ++i)
      weight[j][i] = std::min(1.0, bound / std::max(bound, left[static_cast<std::size_t>(i)]));
  }
  return weight;
}

Eigen::Matrix<double, ResidualMoments::kTerms, 1> ResidualMoments::terms_of(
    std::size_t joint, const Eigen::VectorXd& solution) const {
  Eigen::Matrix<double, kTerms, 1> own;
  own << solution.segment<kLocalTerms>(static_cast<Eigen::Index>(joint) * kLocalTerms),
      solution.tail<kSharedTerms>();
  return own;
}

ResidualFit ResidualMoments::fit(const std::vector<bool>& used) const {
  const Eigen::Index size = unknowns();
  const Eigen::Index shared = size - kSharedTerms;
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd c = Eigen::VectorXd::Zero(size);
  for (std::size_t j = 0; j < moment_.size(); ++j) {
    const Moment own = weight_[static_cast<Eigen::Index>(j)] * moment_[j];
    const Eigen::Index first = static_cast<Eigen::Index>(j) * kLocalTerms;
    H.block<kLocalTerms, kLocalTerms>(first, first) = own.topLeftCorner<kLocalTerms, kLocalTerms>();
    H.block<kLocalTerms, kSharedTerms>(first, shared) = own.block<kLocalTerms, kSharedTerms>(0, kLocalTerms);
    H.block<kSharedTerms, kLocalTerms>(shared, first) = own.block<kSharedTerms, kLocalTerms>(kLocalTerms, 0);
    H.bottomRightCorner<kSharedTerms, kSharedTerms>() +=
        own.block<kSharedTerms, kSharedTerms>(kLocalTerms, kLocalTerms);
    c.segment<kLocalTerms>(first) = own.block<kLocalTerms, 1>(0, kTerms);
    c.tail<kSharedTerms>() += own.block<kSharedTerms, 1>(kLocalTerms, kTerms);
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < size; ++k) {
    if (used[static_cast<std::size_t>(k)] && H(k, k) > 0.0) kept.push_back(k);
  }
  ResidualFit out;
  out.solution = Eigen::VectorXd::Zero(size);
  if (!kept.empty()) {
    const Eigen::VectorXd scale = H.diagonal()(kept).cwiseSqrt().cwiseInverse();
    Eigen::MatrixXd A = scale.asDiagonal() * H(kept, kept) * scale.asDiagonal();
    A.diagonal().array() += kRidge;
    const Eigen::VectorXd b = scale.cwiseProduct(c(kept));
    out.solution(kept) = scale.cwiseProduct(A.ldlt().solve(b));
  }
  out.mean_square.resize(static_cast<Eigen::Index>(moment_.size()));
  for (std::size_t j = 0; j < moment_.size(); ++j) {
    Eigen::Matrix<double, kTerms + 1, 1> a;
    a << -terms_of(j, out.solution), 1.0;
    out.mean_square[static_cast<Eigen::Index>(j)] = std::max(0.0, a.dot(moment_[j] * a));
  }
  return out;
}

}  // namespace armtune::internal
