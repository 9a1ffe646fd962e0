#include "tuner/identification/base_parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace base_parameters_test {

using test::WorstError;

TEST(BaseParameters, AreAsManyAsADenseSvdFinds) {
  for (const RobotModel& arm : test::all_arms()) {
    Eigen::MatrixXd Y = random_regressor(arm, 3 * parameter_count(arm.chain), 77);
    const Eigen::VectorXd length = Y.colwise().norm();
    for (Eigen::Index c = 0; c < Y.cols(); ++c) {
      // A column of rounding must not be scaled up to look like one that says something.
      Y.col(c) *= length[c] > 1e-12 * length.maxCoeff() ? 1.0 / length[c] : 0.0;
    }
    const Eigen::VectorXd singular = Y.bdcSvd().singularValues();
    // A gap of many decades, or the comparison would say nothing.
    const Eigen::Index rank = (singular.array() > 1e-9 * singular[0]).count();
    ASSERT_GT(singular[rank - 1], 1e-5 * singular[0]) << arm.name;
    ASSERT_LT(rank == singular.size() ? 0.0 : singular[rank], 1e-12 * singular[0]) << arm.name;
    EXPECT_EQ(base_parameters(arm).rank(), rank) << arm.name;
  }
}

TEST(BaseParameters, GiveTheSameTorqueAsTheWholeTheta) {
  WorstError worst("Y theta", 1e-10);  // rounding times the condition of the groups' leading columns
  for (const RobotModel& arm : test::all_arms()) {
    const BaseParameters base = base_parameters(arm);
    const Eigen::MatrixXd Y = random_regressor(arm, 50, 78);
    Eigen::MatrixXd Y_base(Y.rows(), base.rank());
    for (int b = 0; b < base.rank(); ++b)
      Y_base.col(b) = Y.col(base.independent[static_cast<std::size_t>(b)]);
    const Eigen::VectorXd theta = Eigen::VectorXd::Random(Y.cols());
    worst.compare(Eigen::VectorXd(Y_base * (base.map * theta)), Eigen::VectorXd(Y * theta), arm.name);
  }
}

TEST(BaseParameters, OfTheUr10AreTheTextbooks) {
  const BaseParameters base = base_parameters(test::ur10());
  // 36 inertial ones for six revolute joints of which the second turns across the first (Gautier and Khalil,
  // 1990), four rotor inertias that no link's izz takes in, two kinds of friction on each joint.
  EXPECT_EQ(base.rank(), 36 + 4 + 12);
  EXPECT_THAT(base.names,
              testing::Contains("forearm_link/my - 0.5723 wrist_1_link/mass - 0.5723 wrist_2_link/mass - "
                                "0.5723 wrist_3_link/mass"));
  EXPECT_THAT(base.names, testing::Contains("elbow_joint/rotor_inertia"));
  EXPECT_THAT(base.names, testing::Not(testing::Contains("shoulder_pan_joint/rotor_inertia")));
}

}  // namespace base_parameters_test
}  // namespace armtune::internal
