#include "tuner/identification/torque_moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace armtune::internal {
namespace torque_moments_test {

/// The RMS values over all instants equal those of the rows themselves, kept and summed one by one.
TEST(TorqueMoments, GiveTheRmsOfTheRowsThemselves) {
  constexpr int kJoints = 3;
  constexpr int kRank = 4;
  constexpr int kInstants = 50;
  std::srand(1);
  const Eigen::VectorXd theta = Eigen::VectorXd::Random(kRank);
  TorqueMoments moments(kJoints, kRank);
  Eigen::VectorXd torque = Eigen::VectorXd::Zero(kJoints);
  Eigen::VectorXd predicted = torque;
  Eigen::VectorXd residual = torque;
  for (int i = 0; i < kInstants; ++i) {
    const Eigen::MatrixXd rows = Eigen::MatrixXd::Random(kJoints, kRank + 1);
    moments.add(rows);
    const Eigen::VectorXd model = rows.leftCols(kRank) * theta;
    torque += rows.col(kRank).cwiseAbs2() / kInstants;
    predicted += model.cwiseAbs2() / kInstants;
    residual += (rows.col(kRank) - model).cwiseAbs2() / kInstants;
  }
  EXPECT_EQ(moments.count(), kInstants);
  EXPECT_TRUE(moments.torque_rms().isApprox(torque.cwiseSqrt(), 1e-12));
  EXPECT_TRUE(moments.predicted_rms(theta).isApprox(predicted.cwiseSqrt(), 1e-12));
  EXPECT_TRUE(moments.residual_rms(theta).isApprox(residual.cwiseSqrt(), 1e-12));
}

/// An offset of the torque changes its RMS, but not the share of its variance that is explained.
TEST(TorqueMoments, GiveTheShareOfTheVarianceThatIsExplained) {
  constexpr int kInstants = 40;
  std::srand(2);
  const Eigen::MatrixXd all = Eigen::MatrixXd::Random(kInstants, 2);
  const Eigen::VectorXd theta = Eigen::VectorXd::Constant(1, 0.7);
  const auto variance = [](const Eigen::VectorXd& x) { return (x.array() - x.mean()).square().mean(); };
  const double expected = 1.0 - variance(all.col(1) - theta[0] * all.col(0)) / variance(all.col(1));
  for (const double offset : {0.0, 5.0}) {
    TorqueMoments moments(2, 1);
    for (int i = 0; i < kInstants; ++i) {
      Eigen::MatrixXd rows(2, 2);
      rows << all(i, 0), all(i, 1) + offset, all(i, 0), 3.0;
      moments.add(rows);
    }
    EXPECT_NEAR(moments.explained(theta)[0], expected, 1e-9);
    EXPECT_EQ(moments.explained(theta)[1], 0.0) << "a constant torque has no variance";
  }
}

TEST(TorqueMoments, AreZeroWithoutRows) {
  const TorqueMoments none(2, 3);
  EXPECT_EQ(none.torque_rms(), Eigen::VectorXd::Zero(2));
  EXPECT_EQ(none.predicted_rms(Eigen::VectorXd::Ones(3)), Eigen::VectorXd::Zero(2));
  EXPECT_EQ(none.explained(Eigen::VectorXd::Ones(3)), Eigen::VectorXd::Zero(2));
}

}  // namespace torque_moments_test
}  // namespace armtune::internal
