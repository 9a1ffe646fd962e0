#include "tuner/identification/regression.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "armtune/error.hpp"
#include "tuner/identification/sparse_qr.hpp"

namespace armtune::internal {
namespace {

/// Number of rows of a joint that are collected before they are factorised.
constexpr std::size_t kBlock = 2000;
/// Number of lags whose autocorrelation counts. The rows' filter correlates neighbouring rows; after this
/// many rows the correlation has died away.
constexpr std::size_t kLags = 24;
/// Each pass corrects the variance of the residuals by the part of the noise that the fit has absorbed. After
/// the third pass the result no longer changes.
constexpr int kCovariancePasses = 3;
constexpr int kWeightIterations = 20;
/// Standard deviation of the prior, as a multiple of a base parameter's size.
constexpr double kPriorDeviation = 100.0;
/// A base parameter whose standard deviation is at least this multiple of its size was not excited.
constexpr double kUnknown = 10.0;
/// The noise is assumed to be at least this share of a joint's torque, which covers the rounding of
/// noise-free logs.
constexpr double kLeastNoise = 1e-6;

/// Returns a sparse matrix with the factor, and below it the rows that were added since the factorisation.
SparseMatrix stacked(const Eigen::MatrixXd& factor, const std::vector<Eigen::VectorXd>& rows) {
  const Eigen::Index columns = factor.cols();
  std::vector<Eigen::Triplet<double, long>> entries;
  entries.reserve(static_cast<std::size_t>(factor.size()) + rows.size() * static_cast<std::size_t>(columns));
  const auto add = [&entries](Eigen::Index r, Eigen::Index c, double value) {
    if (value != 0.0) entries.emplace_back(r, c, value);
  };
  for (Eigen::Index r = 0; r < factor.rows(); ++r) {
    for (Eigen::Index c = r; c < columns; ++c) add(r, c, factor(r, c));
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (Eigen::Index c = 0; c < columns; ++c)
      add(factor.rows() + static_cast<Eigen::Index>(k), c, rows[k][c]);
  }
  SparseMatrix matrix(factor.rows() + static_cast<Eigen::Index>(rows.size()), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Replaces negative eigenvalues of W by zero. In a short log, the terms of the lags can outweigh the
/// variances. Directions with a negative variance then count as exactly known.
void make_positive(Eigen::MatrixXd& W) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(W);
  if (eigen.eigenvalues().minCoeff() >= 0.0) return;
  const Eigen::VectorXd kept = eigen.eigenvalues().cwiseMax(0.0);
  W = eigen.eigenvectors() * kept.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Returns the flat-top taper (Politis and Romano, 1995): 1 over the first half of the lags, then falling to
/// 0. It does not shorten the correlation that the rows' filter causes.
double taper(std::size_t lag) {
  return std::min(1.0, 2.0 - 2.0 * static_cast<double>(lag) / static_cast<double>(kLags + 1));
}

/// Returns (-theta, 1). The residual is the row (Y, tau) times this vector.
Eigen::VectorXd residual_of(const Eigen::VectorXd& theta) {
  Eigen::VectorXd a(theta.size() + 1);
  a << -theta, 1.0;
  return a;
}

}  // namespace

Eigen::VectorXd Estimate::deviation() const {
  Eigen::VectorXd deviation = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  for (const int group : not_excited) deviation[group] = std::numeric_limits<double>::infinity();
  return deviation;
}

Regression::Regression(int joints, int rank)
    : joints_(joints),
      rank_(rank),
      waiting_(static_cast<std::size_t>(joints)),
      factor_(static_cast<std::size_t>(joints), Eigen::MatrixXd::Zero(0, rank + 1)),
      moments_(static_cast<std::size_t>(joints),
               std::vector<Eigen::MatrixXd>(kLags + 1, Eigen::MatrixXd::Zero(rank + 1, rank + 1))),
      pairs_(kLags + 1, 0) {}

void Regression::add(const Eigen::MatrixXd& rows) {
  ++rows_;
  last_.insert(last_.begin(), rows);
  if (last_.size() > kLags + 1) last_.pop_back();
  for (std::size_t lag = 0; lag < last_.size(); ++lag) {
    ++pairs_[lag];
    for (std::size_t j = 0; j < waiting_.size(); ++j) {
      const auto joint = static_cast<Eigen::Index>(j);
      moments_[j][lag].noalias() += last_[lag].row(joint).transpose() * rows.row(joint);
    }
  }
  for (std::size_t j = 0; j < waiting_.size(); ++j) {
    waiting_[j].emplace_back(rows.row(static_cast<Eigen::Index>(j)).transpose());
    if (waiting_[j].size() >= kBlock) compress(j);
  }
}

void Regression::compress(std::size_t joint) {
  if (waiting_[joint].empty()) return;
  factor_[joint] = triangular_factor(stacked(factor_[joint], waiting_[joint]));
  waiting_[joint].clear();
}

Eigen::VectorXd Regression::solve_weighted(const Eigen::VectorXd& deviation, const WeakPrior& prior,
                                           Estimate& out) const {
  Eigen::MatrixXd all =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(joints_ + 1) * (rank_ + 1), rank_ + 1);
  for (int j = 0; j < joints_; ++j) {
    all.middleRows(static_cast<Eigen::Index>(j) * (rank_ + 1), rank_ + 1) =
        factor_[static_cast<std::size_t>(j)] / deviation[j];
  }
  const Eigen::VectorXd weight = (kPriorDeviation * prior.size).cwiseInverse();
  all.block(static_cast<Eigen::Index>(joints_) * (rank_ + 1), 0, rank_, rank_).diagonal() = weight;
  all.col(rank_).segment(static_cast<Eigen::Index>(joints_) * (rank_ + 1), rank_) =
      weight.cwiseProduct(prior.value);
  const Eigen::VectorXd length = all.leftCols(rank_).colwise().norm();
  all.leftCols(rank_) *= length.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd R = triangular_factor(SparseMatrix(all.sparseView()));
  const auto upper = R.topLeftCorner(rank_, rank_);
  const Eigen::VectorXd singular = upper.jacobiSvd().singularValues();
  out.condition = singular[0] / singular[singular.size() - 1];
  const Eigen::VectorXd x = upper.triangularView<Eigen::Upper>().solve(R.col(rank_).head(rank_));
  return x.cwiseQuotient(length);
}

double Regression::autocovariance(std::size_t joint, std::size_t lag, const Eigen::VectorXd& a) const {
  return pairs_[lag] > 0 ? a.dot(moments_[joint][lag] * a) / static_cast<double>(pairs_[lag]) : 0.0;
}

Eigen::MatrixXd Regression::covariance(const Eigen::VectorXd& a, const Eigen::VectorXd& deviation,
                                       const WeakPrior& prior, const Eigen::MatrixXd& last) const {
  const Eigen::VectorXd weak = (kPriorDeviation * prior.size).cwiseAbs2().cwiseInverse();
  Eigen::MatrixXd information = weak.asDiagonal();
  Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(rank_, rank_);
  for (std::size_t j = 0; j < factor_.size(); ++j) {
    const double weight = std::pow(deviation[static_cast<Eigen::Index>(j)], -2.0);
    const auto Y = [&](std::size_t lag) { return moments_[j][lag].topLeftCorner(rank_, rank_); };
    // The fit absorbs a part of the noise. The second term adds it again; it follows from the covariance of
    // theta.
    const auto noise = [&](std::size_t lag) {
      if (pairs_[lag] == 0) return 0.0;
      return autocovariance(j, lag, a) + last.cwiseProduct(Y(lag)).sum() / static_cast<double>(pairs_[lag]);
    };
    information += weight * Y(0);
    meat += weight * weight * noise(0) * Y(0);
    for (std::size_t lag = 1; lag <= kLags; ++lag) {
      meat += weight * weight * taper(lag) * noise(lag) * (Y(lag) + Y(lag).transpose());
    }
  }
  const Eigen::VectorXd unscale = information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd H = unscale.asDiagonal() * information * unscale.asDiagonal();
  Eigen::MatrixXd W = unscale.asDiagonal() * meat * unscale.asDiagonal();
  make_positive(W);
  W.diagonal() += unscale.cwiseAbs2().cwiseProduct(weak);
  const Eigen::LDLT<Eigen::MatrixXd> factor(H);
  const Eigen::MatrixXd half = factor.solve(W);
  return unscale.asDiagonal() * factor.solve(half.transpose()) * unscale.asDiagonal();
}

Estimate Regression::solve(const WeakPrior& prior) {
  for (std::size_t j = 0; j < waiting_.size(); ++j) compress(j);
  Estimate out;
  out.rows = rows_;
  const double freedom = std::max(1.0, static_cast<double>(rows_) - static_cast<double>(rank_) / joints_);
  Eigen::VectorXd least(joints_);
  for (int j = 0; j < joints_; ++j)
    least[j] = kLeastNoise * factor_[static_cast<std::size_t>(j)].col(rank_).norm() / std::sqrt(freedom);
  least = least.cwiseMax(1e-12 + 1e-3 * least.maxCoeff());
  Eigen::VectorXd deviation = Eigen::VectorXd::Ones(joints_);
  for (int iteration = 0; iteration < kWeightIterations; ++iteration) {
    out.theta = solve_weighted(deviation, prior, out);
    const Eigen::VectorXd a = residual_of(out.theta);
    Eigen::VectorXd next(joints_);
    for (int j = 0; j < joints_; ++j)
      next[j] = (factor_[static_cast<std::size_t>(j)] * a).norm() / std::sqrt(freedom);
    next = next.cwiseMax(least);
    const bool settled = (next - deviation).cwiseAbs().maxCoeff() < 1e-6 * next.maxCoeff();
    deviation = next;
    if (settled) break;
  }
  out.torque_residual = deviation;
  out.covariance = Eigen::MatrixXd::Zero(rank_, rank_);
  for (int k = 0; k < kCovariancePasses; ++k)
    out.covariance = covariance(residual_of(out.theta), deviation, prior, out.covariance);
  for (Eigen::Index group = 0; group < rank_; ++group) {
    if (std::sqrt(std::max(0.0, out.covariance(group, group))) >= kUnknown * prior.size[group])
      out.not_excited.push_back(static_cast<int>(group));
  }
  return out;
}

}  // namespace armtune::internal
