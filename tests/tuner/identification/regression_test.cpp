#include "tuner/identification/regression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace regression_test {

using test::WorstError;

constexpr int kJoints = 2;
constexpr int kRank = 4;

/// Rows y of two joints and their torque, with noise of a standard deviation per joint, smoothed over
/// neighbours where asked for, as a filter does it.
class Stream {
 public:
  explicit Stream(unsigned seed) : generator_(seed) {}

  Eigen::Vector4d theta{1.0, -2.0, 0.5, 3.0};
  Eigen::Vector2d noise{0.1, 0.4};
  int smooth = 1;

  Eigen::MatrixXd next() {
    Eigen::MatrixXd rows(kJoints, kRank + 1);
    ++k_;
    for (Eigen::Index j = 0; j < kJoints; ++j) {
      for (Eigen::Index c = 0; c < kRank; ++c) {
        // Slow regressors, as filtered motion gives them.
        rows(j, c) = std::sin(0.01 * k_ * (1.0 + 0.37 * static_cast<double>(c)) + static_cast<double>(j));
      }
    }
    rows(0, 3) = 0.0;  // a parameter that only the second joint feels
    white_.push_back(Eigen::Vector2d(normal_(generator_), normal_(generator_)));
    if (white_.size() > static_cast<std::size_t>(smooth)) white_.erase(white_.begin());
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto& w : white_) sum += w;
    rows.col(kRank) = rows.leftCols(kRank) * theta + noise.cwiseProduct(sum) / std::sqrt(smooth);
    return rows;
  }

 private:
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
  std::vector<Eigen::Vector2d> white_;
  double k_ = 0.0;
};

Estimate estimate(Stream& stream, int rows, const Eigen::VectorXd& prior = Eigen::VectorXd::Zero(kRank)) {
  Regression regression(kJoints, kRank);
  for (int k = 0; k < rows; ++k) regression.add(stream.next());
  return regression.solve({prior, Eigen::VectorXd::Ones(kRank)});
}

TEST(Regression, FindsWhatNoiseFreeRowsHoldWhateverTheBlocks) {
  for (const int rows : {50, 1999, 2000, 6500}) {
    Stream stream(821);
    stream.noise.setZero();
    const Estimate found = estimate(stream, rows);
    EXPECT_LT((found.theta - stream.theta).norm(), 1e-9) << rows;
    EXPECT_EQ(found.rows, rows);
  }
}

TEST(Regression, WeighsJointsByWhatTheyLeaveUnexplained) {
  Stream stream(822);
  const Estimate found = estimate(stream, 20000);
  EXPECT_NEAR(found.torque_residual[0], 0.1, 0.003);
  EXPECT_NEAR(found.torque_residual[1], 0.4, 0.012);
}

/// RMS of (estimate - truth) / stated deviation over many streams.
double normalised_error(int smooth) {
  double squares = 0.0;
  constexpr int kStreams = 60;
  for (unsigned seed = 0; seed < kStreams; ++seed) {
    Stream stream(900 + seed);
    stream.smooth = smooth;
    const Estimate found = estimate(stream, 3000);
    squares += (found.theta - stream.theta).cwiseQuotient(found.deviation()).squaredNorm();
  }
  return std::sqrt(squares / (kStreams * kRank));
}

TEST(Regression, ItsDeviationsHoldForWhiteAndForFilteredNoise) {
  // 240 numbers: their RMS is known to about 5 %.
  EXPECT_NEAR(normalised_error(1), 1.0, 0.15);
  EXPECT_NEAR(normalised_error(5), 1.0, 0.15);
}

TEST(Regression, WhatIsNotExcitedKeepsItsPrior) {
  Regression regression(kJoints, kRank);
  Stream stream(823);
  stream.noise.setZero();
  for (int k = 0; k < 500; ++k) {
    Eigen::MatrixXd rows = stream.next();
    rows.col(kRank) -= stream.theta[1] * rows.col(1);
    rows.col(1).setZero();
    regression.add(rows);
  }
  Eigen::VectorXd prior = Eigen::VectorXd::Constant(kRank, 7.0);
  const Estimate found = regression.solve({prior, Eigen::VectorXd::Ones(kRank)});
  EXPECT_EQ(found.not_excited, std::vector<int>{1});
  EXPECT_NEAR(found.theta[1], 7.0, 1e-9);
  EXPECT_TRUE(std::isinf(found.deviation()[1]));
  EXPECT_NEAR(found.theta[0], stream.theta[0], 1e-9);
  EXPECT_NEAR(found.theta[3], stream.theta[3], 1e-9);
}

}  // namespace regression_test
}  // namespace armtune::internal
