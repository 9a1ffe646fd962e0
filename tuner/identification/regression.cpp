#include "tuner/identification/regression.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/common/error.hpp"
#include "tuner/identification/sparse_qr.hpp"

namespace armtune {
namespace {

/// Rows that wait for the next factorisation.
constexpr std::size_t kBlock = 2000;
/// The rows' filter makes neighbours alike: its autocorrelation has died away after this many rows.
constexpr std::size_t kLags = 24;
/// Each pass adds to the residuals' variance what the fit has taken out of them; the third changes nothing.
constexpr int kCovariancePasses = 3;
constexpr int kWeightIterations = 20;
/// A column of unit length counts as not excited when less than this is left of it beside the others.
constexpr double kNotExcited = 1e-7;
/// A group takes part in an open direction when its torque is more than this share of the largest part.
constexpr double kInvolved = 1e-3;

/// The factor under the rows that came after it, sparse.
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

/// Lags of a short log may outweigh its variances: directions of negative variance are taken for exactly
/// known.
void make_positive(Eigen::MatrixXd& W) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(W);
  if (eigen.eigenvalues().minCoeff() >= 0.0) return;
  const Eigen::VectorXd kept = eigen.eigenvalues().cwiseMax(0.0);
  W = eigen.eigenvectors() * kept.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Flat-top taper (Politis and Romano, 1995): 1 over the first half of the lags, then down to 0. It does not
/// shorten the correlation that the rows' filter makes.
double taper(std::size_t lag) {
  return std::min(1.0, 2.0 - 2.0 * static_cast<double>(lag) / static_cast<double>(kLags + 1));
}

/// Each dead column is a combination of live ones: moving its parameter up and theirs down changes no torque.
void find_open_directions(const RankRevealed& revealed, const Eigen::VectorXd& length, Estimate& out) {
  const auto live = static_cast<Eigen::Index>(revealed.live.size());
  const auto dead = static_cast<Eigen::Index>(revealed.dead.size());
  const Eigen::MatrixXd combination =
      revealed.R.leftCols(live).triangularView<Eigen::Upper>().solve(revealed.R.rightCols(dead));
  out.open_directions = Eigen::MatrixXd::Zero(length.size(), dead);
  std::vector<bool> open(static_cast<std::size_t>(length.size()), false);
  const auto set = [&](int group, Eigen::Index k, double scaled) {
    if (std::abs(scaled) < kNotExcited) return;
    out.open_directions(group, k) = scaled / length[group];
    if (std::abs(scaled) > kInvolved) open[static_cast<std::size_t>(group)] = true;
  };
  for (Eigen::Index k = 0; k < dead; ++k) {
    set(revealed.dead[static_cast<std::size_t>(k)], k, 1.0);
    for (Eigen::Index i = 0; i < live; ++i)
      set(revealed.live[static_cast<std::size_t>(i)], k, -combination(i, k));
  }
  out.not_excited.clear();
  for (std::size_t group = 0; group < open.size(); ++group)
    if (open[group]) out.not_excited.push_back(static_cast<int>(group));
}

/// (-theta, 1): (Y, tau) times it is the residual.
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

Eigen::VectorXd Regression::solve_weighted(const Eigen::VectorXd& deviation, const Eigen::VectorXd& prior,
                                           Estimate& out) {
  Eigen::MatrixXd all(static_cast<Eigen::Index>(joints_) * (rank_ + 1), rank_ + 1);
  for (int j = 0; j < joints_; ++j) {
    all.middleRows(static_cast<Eigen::Index>(j) * (rank_ + 1), rank_ + 1) =
        factor_[static_cast<std::size_t>(j)] / deviation[j];
  }
  Eigen::VectorXd length = all.leftCols(rank_).colwise().norm();
  length = (length.array() > 0.0).select(length, 1.0);
  Eigen::MatrixXd scaled = all.leftCols(rank_) * length.cwiseInverse().asDiagonal();
  const RankRevealed revealed = rank_revealing_factor(SparseMatrix(scaled.sparseView()), kNotExcited);
  find_open_directions(revealed, length, out);
  dead_ = revealed.dead;

  // A dead column keeps its prior; the rest is solved for beside it.
  Eigen::VectorXd theta = prior;
  Eigen::VectorXd torque = all.col(rank_);
  for (const int dead : revealed.dead) torque -= all.col(dead) * prior[dead];
  const auto live = static_cast<Eigen::Index>(revealed.live.size());
  if (live == 0) throw InputError("the logs excite no parameter: does the arm move in them at all?");
  Eigen::MatrixXd system(all.rows(), live + 1);
  for (Eigen::Index k = 0; k < live; ++k)
    system.col(k) = scaled.col(revealed.live[static_cast<std::size_t>(k)]);
  system.col(live) = torque;
  const Eigen::MatrixXd R = triangular_factor(SparseMatrix(system.sparseView()));
  const Eigen::VectorXd x =
      R.topLeftCorner(live, live).triangularView<Eigen::Upper>().solve(R.col(live).head(live));
  for (Eigen::Index k = 0; k < live; ++k) {
    const int b = revealed.live[static_cast<std::size_t>(k)];
    theta[b] = x[k] / length[b];
  }
  const Eigen::VectorXd singular = R.topLeftCorner(live, live).jacobiSvd().singularValues();
  out.condition = singular[0] / singular[singular.size() - 1];
  return theta;
}

double Regression::autocovariance(std::size_t joint, std::size_t lag, const Eigen::VectorXd& a) const {
  return pairs_[lag] > 0 ? a.dot(moments_[joint][lag] * a) / static_cast<double>(pairs_[lag]) : 0.0;
}

Eigen::MatrixXd Regression::covariance(const Eigen::VectorXd& a, const Eigen::VectorXd& deviation,
                                       const Estimate& estimate) const {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(rank_, rank_);
  Eigen::MatrixXd meat = Eigen::MatrixXd::Zero(rank_, rank_);
  for (std::size_t j = 0; j < factor_.size(); ++j) {
    const double weight = std::pow(deviation[static_cast<Eigen::Index>(j)], -2.0);
    const auto Y = [&](std::size_t lag) { return moments_[j][lag].topLeftCorner(rank_, rank_); };
    // The fit takes a part of the noise out of the residuals: as much as theta is uncertain.
    const auto noise = [&](std::size_t lag) {
      if (pairs_[lag] == 0) return 0.0;
      return autocovariance(j, lag, a) +
             estimate.covariance.cwiseProduct(Y(lag)).sum() / static_cast<double>(pairs_[lag]);
    };
    information += weight * Y(0);
    meat += weight * weight * noise(0) * Y(0);
    for (std::size_t lag = 1; lag <= kLags; ++lag) {
      meat += weight * weight * taper(lag) * noise(lag) * (Y(lag) + Y(lag).transpose());
    }
  }
  Eigen::VectorXd scale = information.diagonal().cwiseSqrt();
  for (const int dead : dead_) {
    information.row(dead).setZero();
    information.col(dead).setZero();
    meat.row(dead).setZero();
    meat.col(dead).setZero();
    scale[dead] = 1.0;
    information(dead, dead) = 1.0;
  }
  const Eigen::VectorXd unscale = scale.cwiseInverse();
  const Eigen::MatrixXd H = unscale.asDiagonal() * information * unscale.asDiagonal();
  Eigen::MatrixXd W = unscale.asDiagonal() * meat * unscale.asDiagonal();
  make_positive(W);
  const Eigen::LDLT<Eigen::MatrixXd> factor(H);
  const Eigen::MatrixXd half = factor.solve(W);
  return unscale.asDiagonal() * factor.solve(half.transpose()) * unscale.asDiagonal();
}

Estimate Regression::solve(const Eigen::VectorXd& prior) {
  for (std::size_t j = 0; j < waiting_.size(); ++j) compress(j);
  Estimate out;
  out.rows = rows_;
  const double freedom = std::max(1.0, static_cast<double>(rows_) - static_cast<double>(rank_) / joints_);
  Eigen::VectorXd deviation = Eigen::VectorXd::Ones(joints_);
  for (int iteration = 0; iteration < kWeightIterations; ++iteration) {
    out.theta = solve_weighted(deviation, prior, out);
    const Eigen::VectorXd a = residual_of(out.theta);
    Eigen::VectorXd next(joints_);
    for (int j = 0; j < joints_; ++j) {
      next[j] = (factor_[static_cast<std::size_t>(j)] * a).norm() / std::sqrt(freedom);
    }
    // Noise-free data must not divide by zero.
    next = next.cwiseMax(1e-9 * std::max(1e-12, next.maxCoeff()));
    const bool settled = (next - deviation).cwiseAbs().maxCoeff() < 1e-6 * next.maxCoeff();
    deviation = next;
    if (settled) break;
  }
  out.torque_residual = deviation;

  const Eigen::VectorXd a = residual_of(out.theta);
  out.covariance = Eigen::MatrixXd::Zero(rank_, rank_);
  for (int k = 0; k < kCovariancePasses; ++k) out.covariance = covariance(a, deviation, out);
  return out;
}

}  // namespace armtune
