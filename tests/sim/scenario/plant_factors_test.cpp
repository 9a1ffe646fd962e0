// What a scenario changes of the arm's model, in the plant and in theta's start.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/robot/theta.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace plant_factors_test {

/// Rounding of sums of a few dozen products.
constexpr double kRounding = 1e-12;

Scenario scenario_on(RobotModel arm) {
  Scenario scenario;
  scenario.robot = std::make_shared<RobotModel>(std::move(arm));
  return scenario;
}

LinkInertia about_center(const LinkInertia& body) {
  return in_frame(body, Mat3::Identity(), -body.first_moment / body.mass);
}

TEST(PlantFactors, ScaleMassAndInertiaAboutTheCenterWithoutMovingTheCenter) {
  test::WorstError law("mass, centre and inertia scale as named", kRounding);
  std::mt19937 generator(3);
  for (const RobotModel& arm : test::all_arms()) {
    Scenario scenario = scenario_on(arm);
    PlantConditions& plant = scenario.plant;
    plant.mass_factors = JointVector::Ones(arm.n()) + test::random_vector(generator, arm.n(), 0.2);
    plant.inertia_factors = JointVector::Ones(arm.n()) + test::random_vector(generator, arm.n(), 0.2);
    plant.rotor_factors = JointVector::Ones(arm.n()) + test::random_vector(generator, arm.n(), 0.2);
    const RobotModel real = plant_model(scenario);
    validate(real);
    for (int i = 0; i < arm.n(); ++i) {
      const auto k = static_cast<std::size_t>(i);
      const LinkInertia& before = arm.chain.link[k];
      const LinkInertia& after = real.chain.link[k];
      const double a = plant.mass_factors[i];
      law.compare(after.mass, a * before.mass, arm.name);
      law.compare(after.first_moment, Vec3(a * before.first_moment), arm.name);
      // The shift to the centre cancels two numbers of the size of the inertia about the joint.
      law.compare(about_center(after).inertia,
                  Mat3(a * plant.inertia_factors[i] * about_center(before).inertia), arm.name,
                  before.inertia.norm());
      law.compare(real.chain.rotor_inertia[i], plant.rotor_factors[i] * arm.chain.rotor_inertia[i], arm.name);
    }
  }
}

TEST(PlantFactors, FrictionOfTheScenarioIsOnTopOfTheArms) {
  RobotModel arm = test::ur10();
  arm.chain.viscous_friction.setConstant(2.0);
  arm.chain.coulomb_friction.setConstant(3.0);
  Scenario scenario = scenario_on(arm);
  EXPECT_EQ(plant_model(scenario).chain.viscous_friction, arm.chain.viscous_friction);
  scenario.plant.viscous_friction = JointVector::LinSpaced(6, 0.5, 3.0);
  scenario.plant.coulomb_friction = JointVector::LinSpaced(6, 4.0, 6.5);
  const Chain plant = plant_model(scenario).chain;
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(plant.viscous_friction[i], 2.5 + 0.5 * i);
    EXPECT_EQ(plant.coulomb_friction[i], 7.0 + 0.5 * i);
  }
}

TEST(PlantFactors, OfOneOrNoneLeaveTheArmBitForBit) {
  const RobotModel arm = test::seven_joint_arm();
  const Scenario none = scenario_on(arm);
  Scenario one = scenario_on(arm);
  one.plant.mass_factors = one.plant.inertia_factors = one.plant.rotor_factors = JointVector::Ones(arm.n());
  EXPECT_EQ(theta_of(plant_model(none).chain), theta_of(arm.chain));
  EXPECT_EQ(theta_of(plant_model(one).chain), theta_of(arm.chain));
}

TEST(PlantFactors, ComeFromTheScenarioFileAndMustBePositive) {
  const test::TemporaryFolder folder;
  const std::string path =
      folder.write("own.yaml",
                   "base: moving_target\nplant:\n  mass_factors: [1, 1.1, 1, 1, 1, 0.9]\n"
                   "  inertia_factors: [1, 1, 1, 1, 1, 1.2]\n  rotor_factors: [0.8, 1, 1, 1, 1, 1]\n");
  const Scenario scenario = load_scenario(path);
  const RobotModel real = plant_model(scenario);
  EXPECT_DOUBLE_EQ(real.chain.link[1].mass, 1.1 * scenario.robot->chain.link[1].mass);
  EXPECT_DOUBLE_EQ(real.chain.rotor_inertia[0], 0.8 * scenario.robot->chain.rotor_inertia[0]);
  EXPECT_EQ(scenario.plant.inertia_factors[5], 1.2);

  for (const char* key : {"mass_factors", "inertia_factors", "rotor_factors"}) {
    folder.write("own.yaml", std::string("base: moving_target\nplant:\n  ") + key + ": [1, 1, 0, 1, 1, 1]\n");
    EXPECT_THAT([&] { load_scenario(path); },
                test::refused_at({.file = path,
                                  .line = 3,
                                  .key = fmt::format("plant/{}", key),
                                  .value = "0",
                                  .limit = "factors above 0 (1: as in the robot file)"}));
  }
}

TEST(PlantFactors, AnOffsetMovesTheCenterAndKeepsTheInertiaAboutIt) {
  Scenario scenario = load_scenario("moving_target");
  const Chain before = plant_model(scenario).chain;
  scenario.plant.center_offsets.setZero(3, 6);
  const Vec3 offset(0.01, -0.02, 0.03);
  scenario.plant.center_offsets.col(2) = offset;
  const Chain after = plant_model(scenario).chain;
  const auto about_center = [](const LinkInertia& link) {
    const Vec3 c = link.first_moment / link.mass;
    return Mat3(link.inertia - link.mass * (c.squaredNorm() * Mat3::Identity() - c * c.transpose()));
  };
  EXPECT_EQ(after.link[2].mass, before.link[2].mass);
  EXPECT_LT((after.link[2].first_moment - before.link[2].first_moment - before.link[2].mass * offset).norm(),
            kRounding * before.link[2].mass);
  EXPECT_LT((about_center(after.link[2]) - about_center(before.link[2])).norm(), kRounding);
  EXPECT_EQ(after.link[1].inertia, before.link[1].inertia);
}

TEST(ThetaStart, FactorsMultiplyEachLinksAndItsJointsParameters) {
  Scenario scenario = load_scenario("realistic_moving_target");
  scenario.theta.model_scale = 1.0;
  const ParameterVector plain = start_theta(scenario);
  scenario.theta.factors = JointVector::LinSpaced(6, 0.5, 1.0);
  const ParameterVector varied = start_theta(scenario);
  EXPECT_EQ(varied.segment<kLinkParameters>(0), 0.5 * plain.segment<kLinkParameters>(0));
  const int joint = joint_parameter_index(6, 2);
  EXPECT_EQ(varied.segment<kJointParameters>(joint), 0.7 * plain.segment<kJointParameters>(joint));
  EXPECT_EQ(varied.tail<kJointParameters>(), plain.tail<kJointParameters>());
}

}  // namespace plant_factors_test
}  // namespace armtune::internal
