#include "sim/scenario/arm_distribution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/perturbation.hpp"
#include "tests/sim/support/arm_distributions.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/law_jobs.hpp"

namespace armtune::internal {
namespace arm_distribution_test {

using test::scenario_of;

std::shared_ptr<const ArmDistribution> distribution_of(const std::string& text, const Scenario& scenario) {
  const test::TemporaryFolder folder;
  return load_arm_distribution(folder.write("uncertainty.yaml", text), {&scenario, 1});
}

/// Values of a distribution's parameters by name; those that are not named are those of the mean.
Eigen::VectorXd values_with(const ArmDistribution& distribution,
                            const std::vector<std::pair<std::string, double>>& given) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(distribution.parameters.size()));
  for (std::size_t i = 0; i < distribution.parameters.size(); ++i) {
    const ArmParameter& p = distribution.parameters[i];
    double& value = values[static_cast<Eigen::Index>(i)];
    value = p.logarithmic ? std::exp(p.mean) : p.mean;
    for (const auto& [name, number] : given) {
      if (name == p.name) value = number;
    }
  }
  return values;
}

TEST(DrawnParameters, HaveTheMeansAndTheCovarianceOfTheFile) {
  const auto distribution = distribution_of(test::kSmallDistribution, scenario_of("realistic_fixed_target"));
  constexpr int kDraws = 20000;
  Eigen::Vector4d mean, sum = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i) mean[i] = distribution->parameters[static_cast<std::size_t>(i)].mean;
  Eigen::Matrix4d products = Eigen::Matrix4d::Zero();
  for (std::uint64_t k = 0; k < kDraws; ++k) {
    Eigen::Vector4d x = drawn_parameters(*distribution, 3, k);
    for (const int i : {0, 1}) x[i] = std::log(x[i]);
    sum += x - mean;
    products += (x - mean) * (x - mean).transpose();
  }
  // Five standard errors: all 14 statistics of right draws lie within them with a probability of 0.99999. The
  // variance of a product of two normal numbers is C_ii C_jj + C_ij^2 (Isserlis 1918).
  const Eigen::MatrixXd& C = distribution->covariance;
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(sum[i] / kDraws, 0.0, 5.0 * std::sqrt(C(i, i) / kDraws)) << i;
    for (int k = 0; k <= i; ++k) {
      const double error = std::sqrt((C(i, i) * C(k, k) + C(i, k) * C(i, k)) / kDraws);
      EXPECT_NEAR(products(i, k) / kDraws, C(i, k), 5.0 * error) << i << ", " << k;
    }
  }
}

TEST(DrawnParameters, LieWithinTwoDeviationsAsOftenAsNormalNumbersDo) {
  const auto distribution = distribution_of(test::kSmallDistribution, scenario_of("realistic_fixed_target"));
  constexpr int kDraws = 20000;
  int within = 0;
  for (std::uint64_t k = 0; k < kDraws; ++k) {
    const double z = (drawn_parameters(*distribution, 4, k)[2] - 0.5) / 0.02;
    if (std::abs(z) < 2.0) ++within;
  }
  // 95.45 % of normal numbers; five standard errors of the share are 0.0074.
  EXPECT_NEAR(within / double{kDraws}, std::erf(std::sqrt(2.0)), 0.0074);
}

TEST(DrawnParameters, DependOnSeedAndSampleAlone) {
  const auto distribution = distribution_of(test::kSmallDistribution, scenario_of("realistic_fixed_target"));
  const Eigen::VectorXd first = drawn_parameters(*distribution, 1, 41);
  EXPECT_NE(drawn_parameters(*distribution, 1, 40), first);
  EXPECT_NE(drawn_parameters(*distribution, 2, 41), first);
  EXPECT_EQ(drawn_parameters(*distribution, 1, 41), first);
}

TEST(DrawnParameters, OfASingularCovarianceKeepTheirRelation) {
  const auto distribution = distribution_of(
      "parameters:\n  - {name: base/tilt_x, mean: 0}\n  - {name: base/tilt_y, mean: 1}\n"
      "  - {name: delay, mean: 0.002}\n"
      "covariance: [[0.04], [-0.08, 0.16], [0, 0, 0]]\n",
      scenario_of("realistic_fixed_target"));
  for (std::uint64_t k = 0; k < 20; ++k) {
    const Eigen::VectorXd x = drawn_parameters(*distribution, 5, k);
    EXPECT_NE(x[0], 0.0);
    EXPECT_NEAR(x[1] - 1.0, -2.0 * x[0], 1e-12) << "rounding of sums of numbers below 10";
    EXPECT_EQ(x[2], 0.002);
  }
}

TEST(GiveParameters, FrictionReplacesThatOfModelAndScenario) {
  Scenario scenario = scenario_of("realistic_fixed_target");
  ASSERT_GT(scenario.plant.viscous_friction[2], 0.0);
  const RobotModel before = plant_model(scenario);
  const auto distribution = distribution_of(test::kSmallDistribution, scenario);
  give_parameters(*distribution, values_with(*distribution, {{"elbow_joint/viscous_friction", 3.25}}),
                  scenario);
  const RobotModel after = plant_model(scenario);
  EXPECT_EQ(after.chain.viscous_friction[2], 3.25);
  EXPECT_EQ(after.chain.coulomb_friction[5], std::exp(-1.0));
  EXPECT_EQ(after.chain.viscous_friction[1], before.chain.viscous_friction[1]) << "not in the distribution";
  EXPECT_EQ(after.chain.coulomb_friction[2], before.chain.coulomb_friction[2]);
  EXPECT_EQ(start_theta(scenario), start_theta(scenario_of("realistic_fixed_target")))
      << "the controller does not know the arm";
}

TEST(GiveParameters, PayloadIsAddedToThatOfTheScenario) {
  const Scenario own = scenario_of("realistic_fixed_target");
  const auto distribution = distribution_of(test::kSmallDistribution, own);
  const auto last_link = [&](double mass) {
    Scenario scenario = own;
    give_parameters(*distribution, values_with(*distribution, {{"payload/mass", mass}}), scenario);
    return plant_model(scenario).chain.link[5];
  };
  const LinkInertia bare = plant_model(own).chain.link[5];
  const RobotModel loaded = with_payload(plant_model(own), {0.75, Vec3::Zero()});
  // Sums of a few numbers near 1.
  EXPECT_NEAR(last_link(0.75).mass, loaded.chain.link[5].mass, 1e-12);
  EXPECT_LT((last_link(0.75).inertia - loaded.chain.link[5].inertia).norm(), 1e-12);
  EXPECT_LT((last_link(0.75).first_moment - loaded.chain.link[5].first_moment).norm(), 1e-12);
  EXPECT_EQ(last_link(-0.1).mass, bare.mass) << "a negative mass acts as zero";
}

TEST(GiveParameters, PayloadTakesThePlaceOfTheOneInTheRobotFile) {
  Scenario scenario = scenario_of("realistic_fixed_target");
  const RobotModel bare = *scenario.robot;
  const Vec3 center(0.01, -0.02, 0.05);
  scenario.robot = std::make_shared<const RobotModel>(with_payload(bare, {2.0, center}));
  scenario.plant.payload = {};
  const auto distribution = distribution_of(
      "parameters:\n  - {name: payload/mass, mean: 1.5, robot_file: 2}\n"
      "  - {name: payload/center_x, mean: 0.03, robot_file: 0.01}\n"
      "  - {name: payload/center_y, mean: 0, robot_file: -0.02}\n"
      "  - {name: payload/center_z, mean: 0.04, robot_file: 0.05}\n"
      "covariance: [[0.01], [0, 0.0001], [0, 0, 0.0001], [0, 0, 0, 0.0001]]\n",
      scenario);
  give_parameters(*distribution, values_with(*distribution, {}), scenario);
  const LinkInertia expected = with_payload(bare, {1.5, Vec3(0.03, 0.0, 0.04)}).chain.link[5];
  const LinkInertia found = plant_model(scenario).chain.link[5];
  // Sums of a few numbers near 1.
  EXPECT_NEAR(found.mass, expected.mass, 1e-12);
  EXPECT_LT((found.first_moment - expected.first_moment).norm(), 1e-12);
  EXPECT_LT((found.inertia - expected.inertia).norm(), 1e-12);
}

TEST(GiveParameters, TheDelayIsRoundedToControlPeriods) {
  const Scenario own = scenario_of("realistic_fixed_target");
  const auto distribution = distribution_of(test::kSmallDistribution, own);
  const auto periods = [&](double delay) {
    Scenario scenario = own;
    give_parameters(*distribution, values_with(*distribution, {{"delay", delay * own.control_period}}),
                    scenario);
    return scenario.plant.torque_delay_periods;
  };
  EXPECT_EQ(periods(2.4), 2);
  EXPECT_EQ(periods(2.6), 3);
  EXPECT_EQ(periods(-2.6), 0) << "a negative delay acts as zero";
  EXPECT_EQ(periods(1e9), 1000);
}

TEST(GiveParameters, ATiltTurnsGravityAndKeepsItsSize) {
  Scenario scenario = scenario_of("realistic_fixed_target");
  const Vec3 before = scenario.robot->chain.gravity;
  const auto distribution = distribution_of(test::kDriveDistribution, scenario);
  give_parameters(*distribution, values_with(*distribution, {{"base/tilt_x", 0.02}}), scenario);
  const Vec3 gravity = plant_model(scenario).chain.gravity;
  EXPECT_NEAR(gravity.norm(), before.norm(), 1e-12);
  // The base turns by +0.02 about x, so in its axes gravity turns by -0.02: from -z towards -y.
  EXPECT_NEAR(gravity.y(), -before.norm() * std::sin(0.02), 1e-12);
  EXPECT_EQ(scenario.robot->chain.gravity, before) << "the controller's model";
}

TEST(GiveParameters, DrivesGetTheirGainsAndEncodersBeginAtTheStart) {
  Scenario scenario = scenario_of("realistic_fixed_target");
  const JointVector start = scenario.start_position;
  const RobotModel filled = with_drive_gains(*scenario.robot);
  const auto distribution = distribution_of(test::kDriveDistribution, scenario);
  give_parameters(*distribution, values_with(*distribution, {{"elbow_joint/encoder_offset", 0.003}}),
                  scenario);
  EXPECT_EQ(scenario.robot->drive_velocity_gain[0], std::exp(6.0));
  EXPECT_EQ(scenario.robot->drive_velocity_gain[1], filled.drive_velocity_gain[1]) << "the default";
  EXPECT_EQ(scenario.robot->drive_velocity_integral[2], std::exp(7.0));
  EXPECT_EQ(scenario.robot->drive_position_gain[2], std::exp(3.0));
  EXPECT_EQ(plant_model(scenario).chain.rotor_inertia[2], std::exp(-1.0));
  EXPECT_LT((scenario.start_position - scenario.plant.encoder_offset - start).norm(), 1e-15);
  EXPECT_EQ(scenario.plant.encoder_offset[2], 0.003);
  EXPECT_EQ(scenario.plant.encoder_offset[0], 0.0);
}

/// A rollout that does not see a parameter of the arm would be the same without it.
TEST(DrawnArms, DifferAndAreTheSameInLanesAsAlone) {
  for (const char* kind : {"adaptive", "position_streaming"}) {
    const Scenario scenario = test::with_plan(scenario_of("moving_target", 2.5));
    const Gains gains = test::gains_of(scenario, kind);
    std::vector<LaneJob> jobs = {test::job_of(scenario, gains)};
    Perturbation perturbation = no_perturbation();
    draw_from(distribution_of(test::kDriveDistribution, scenario), perturbation);
    for (std::uint64_t sample = 0; sample < 3; ++sample)
      jobs.push_back(test::job_of(perturbed(scenario, perturbation, 11, sample), gains));
    test::expect_different_and_the_same(jobs);
  }
}

TEST(DrawFrom, SetsTheWidthsOfTheArmToZeroAndKeepsTheOthers) {
  const Scenario scenario = scenario_of("realistic_fixed_target");
  const Perturbation before = default_perturbation({&scenario, 1});
  Perturbation after = before;
  draw_from(distribution_of(test::kSmallDistribution, scenario), after);
  for (double Perturbation::*width :
       {&Perturbation::mass, &Perturbation::center, &Perturbation::inertia, &Perturbation::rotor,
        &Perturbation::friction, &Perturbation::payload, &Perturbation::delay})
    EXPECT_EQ(after.*width, 0.0);
  EXPECT_EQ(after.noise, before.noise);
  EXPECT_EQ(after.theta, before.theta);
  EXPECT_EQ(after.target_speed, before.target_speed);
  EXPECT_EQ(after.phases, before.phases);
}

TEST(DrawFrom, ASampleOfPerturbedHasTheDrawnParameters) {
  const Scenario scenario = scenario_of("realistic_fixed_target");
  Perturbation perturbation = default_perturbation({&scenario, 1});
  draw_from(distribution_of(test::kSmallDistribution, scenario), perturbation);
  const Eigen::VectorXd values = drawn_parameters(*perturbation.distribution, 7, 3);
  const Scenario drawn = perturbed(scenario, perturbation, 7, 3);
  EXPECT_EQ(plant_model(drawn).chain.viscous_friction[2], values[0]);
  EXPECT_EQ(plant_model(drawn).chain.coulomb_friction[5], values[1]);
  EXPECT_EQ(drawn.plant.torque_delay_periods, std::lround(values[3] / scenario.control_period));
  EXPECT_NE(drawn.plant.velocity_noise, scenario.plant.velocity_noise) << "noise is drawn as ever";
  validate(plant_model(drawn));
}

TEST(DrawFrom, AWidthThatTheDistributionReplacesIsRefused) {
  const Scenario scenario = scenario_of("realistic_fixed_target");
  Perturbation perturbation;
  draw_from(distribution_of(test::kSmallDistribution, scenario), perturbation);
  perturbation.mass = 0.1;
  EXPECT_NO_THROW(validate(perturbation));
  perturbation.friction = 0.25;
  EXPECT_THAT([&] { validate(perturbation); },
              test::refused_at({.key = "perturbation/friction", .value = "0.25"}));
}

}  // namespace arm_distribution_test
}  // namespace armtune::internal
