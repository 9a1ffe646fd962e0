// Files of joint distributions: what is read, and what is refused where.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/arm_distribution.hpp"
#include "tests/sim/support/arm_distributions.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace arm_distribution_file_test {

using test::refused_at;
using testing::HasSubstr;

class DistributionFile : public ::testing::Test {
 protected:
  std::shared_ptr<const ArmDistribution> read(const std::string& text) {
    return load_arm_distribution(folder_.write("u.yaml", text), {&scenario_, 1});
  }
  /// The refusal of the small distribution with one part of its text replaced, which is there.
  InputError refusal_with(const std::string& part, const std::string& by) {
    std::string text = test::kSmallDistribution;
    const std::size_t at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    return test::input_error([&] { return read(text.replace(at, part.size(), by)); });
  }

  test::TemporaryFolder folder_;
  Scenario scenario_ = test::scenario_of("realistic_fixed_target");
};

TEST_F(DistributionFile, IsReadWithItsNamesMeansAndCovariance) {
  const auto found = read("note: made by hand\n" + test::kSmallDistribution);
  ASSERT_EQ(found->parameters.size(), 4U);
  EXPECT_EQ(found->note, "made by hand");
  EXPECT_EQ(found->parameters[0].kind, ArmParameterKind::kViscousFriction);
  EXPECT_EQ(found->parameters[0].joint, 2);
  EXPECT_TRUE(found->parameters[0].logarithmic);
  EXPECT_FALSE(found->parameters[0].told);
  EXPECT_TRUE(found->parameters[1].told);
  EXPECT_EQ(found->parameters[2].kind, ArmParameterKind::kPayloadMass);
  EXPECT_EQ(found->parameters[2].joint, -1);
  EXPECT_EQ(found->parameters[3].mean, 0.004);
  EXPECT_EQ(found->covariance(2, 0), -0.002);
  EXPECT_EQ(found->covariance(0, 2), -0.002);
  // Rounding of sums of four products of numbers below 1.
  EXPECT_LT((found->factor * found->factor.transpose() - found->covariance).norm(), 1e-15);
  EXPECT_TRUE(found->factor.isLowerTriangular());
}

TEST_F(DistributionFile, MayHoldTheWholeMatrix) {
  const std::string head = "parameters:\n  - {name: delay, mean: 0}\n  - {name: base/tilt_x, mean: 0}\n";
  EXPECT_EQ(read(head + "covariance: [[0.04, 0.01], [0.01, 0.09]]\n")->covariance,
            read(head + "covariance: [[0.04], [0.01, 0.09]]\n")->covariance);
}

TEST_F(DistributionFile, WithAFlippedSignIsRefusedAtItsRow) {
  const std::string head = "parameters:\n  - {name: delay, mean: 0}\n  - {name: base/tilt_x, mean: 0}\n";
  EXPECT_THAT([&] { read(head + "covariance: [[0.04, 0.01], [-0.01, 0.09]]\n"); },
              refused_at({.file = folder_ / "u.yaml",
                          .line = 4,
                          .key = "covariance/1/0",
                          .value = "-0.01",
                          .limit = HasSubstr("0.01")}));
  EXPECT_THAT([&] { read(head + "covariance: [[-0.04], [-0.01, -0.09]]\n"); },
              refused_at({.line = 4, .key = "covariance/0"}));
  EXPECT_THAT([&] { read(head + "covariance: [[0.04], [0.01, -0.09]]\n"); },
              refused_at({.line = 4, .key = "covariance/1"}));
}

TEST_F(DistributionFile, WithAnIndefiniteCovarianceIsRefusedAtTheRowThatMakesItSo) {
  EXPECT_THAT(refusal_with("[0.01, 0.09]", "[0.07, 0.09]"), refused_at({.line = 8, .key = "covariance/1"}))
      << "a correlation above 1";
  EXPECT_THAT(refusal_with("[0.04]", "[0]"), refused_at({.key = "covariance/1"}))
      << "without a variance, but with a covariance";
}

TEST_F(DistributionFile, WithTooFewRowsOrNumbersIsRefused) {
  EXPECT_THAT(refusal_with("  - [0.01, 0.09]\n", ""), refused_at({.key = "covariance", .value = "3"}));
  EXPECT_THAT(refusal_with("[0.01, 0.09]", "[0.01]"), refused_at({.key = "covariance/1"}));
  EXPECT_THAT(refusal_with("[0.01, 0.09]", "[0.01, .nan]"), refused_at({.key = "covariance/1/1"}));
}

TEST_F(DistributionFile, WithAnUnknownParameterOrJointIsRefusedAtItsName) {
  for (const std::string name : {"elbow/viscous_friction", "elbow_joint/friction", "elbow_joint", "pay/mass",
                                 "elbow_joint/delay", "viscous_friction"}) {
    EXPECT_THAT(
        refusal_with("elbow_joint/viscous_friction", name),
        refused_at({.line = 2,
                    .key = "parameters/0/name",
                    .value = name,
                    .limit = testing::AllOf(HasSubstr("viscous_friction"), HasSubstr("elbow_joint"))}));
  }
  EXPECT_THAT(refusal_with("wrist_3_joint/coulomb_friction", "elbow_joint/viscous_friction"),
              refused_at({.line = 3, .key = "parameters/1/name", .value = "elbow_joint/viscous_friction"}));
  const InputError misspelt = refusal_with("mean: -1", "mena: -1");
  EXPECT_THAT(misspelt, refused_at({.key = "parameters/1"}));
}

TEST_F(DistributionFile, FrictionThatCouldBeNegativeIsRefused) {
  EXPECT_THAT(refusal_with("logarithm: true, mean: -1", "logarithm: false, mean: 1"),
              refused_at({.key = "parameters/1/logarithm", .value = "false", .limit = "true"}));
}

TEST_F(DistributionFile, ValuesThatCouldBeInfiniteAreRefused) {
  // The logarithm of the largest number is 709.8, less than nine deviations of 0.3 above this mean.
  EXPECT_THAT(refusal_with("mean: -1", "mean: 708"),
              refused_at({.key = "parameters/1/mean", .value = "708"}));
}

TEST_F(DistributionFile, OfAnotherRobotFileIsRefusedAtTheValueThatDiffers) {
  const double here = scenario_.robot->chain.viscous_friction[2];
  const auto text = [](double robot_file) {
    return fmt::format(
        "parameters:\n  - {{name: elbow_joint/viscous_friction, mean: 1, robot_file: {}}}\n"
        "covariance: [[1]]\n",
        robot_file);
  };
  EXPECT_EQ(read(text(here))->parameters[0].robot_file, here);
  EXPECT_THAT([&] { read(text(here + 0.5)); }, refused_at({.line = 2,
                                                           .key = "parameters/0/robot_file",
                                                           .value = fmt::to_string(here + 0.5),
                                                           .limit = HasSubstr(fmt::to_string(here))}));
}

TEST_F(DistributionFile, ForScenariosOfDifferentArmsIsRefused) {
  const std::vector<Scenario> two = {scenario_, test::scenario_of("youbot_realistic_moving_target")};
  const std::string path = folder_.write("u.yaml", test::kSmallDistribution);
  EXPECT_THAT([&] { load_arm_distribution(path, two); },
              refused_at({.file = path, .value = "youbot_realistic_moving_target"}));
}

}  // namespace arm_distribution_file_test
}  // namespace armtune::internal
