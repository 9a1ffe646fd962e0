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

TEST(TorqueMoments, AreZeroWithoutRows) {
  const TorqueMoments none(2, 3);
  EXPECT_EQ(none.torque_rms(), Eigen::VectorXd::Zero(2));
  EXPECT_EQ(none.predicted_rms(Eigen::VectorXd::Ones(3)), Eigen::VectorXd::Zero(2));
}

}  // namespace torque_moments_test
}  // namespace armtune::internal
