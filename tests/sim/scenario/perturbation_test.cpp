#include "sim/scenario/perturbation.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/robot/rotor_estimate.hpp"
#include "core/robot/theta.hpp"
#include "core/trajectory/polyline.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace perturbation_test {

/// Rounding of sums of a few dozen products.
constexpr double kRounding = 1e-12;

/// theta of the plant, and everything else a sample changes.
std::vector<double> everything(const Scenario& s) {
  const ParameterVector theta = theta_of(plant_model(s).chain);
  std::vector<double> all(theta.begin(), theta.end());
  for (const NamedPath& p : s.targets) all.push_back(p.path.phase);
  for (const MovingObstacle& p : s.obstacles) all.push_back(p.path.phase);
  all.push_back(static_cast<double>(s.seed));
  return all;
}

/// Masses, inertias, friction, payload and phases alone.
Perturbation of_the_arm() {
  Perturbation p;
  p.center = p.delay = p.noise = p.theta = p.target_speed = 0.0;
  p.payload = 3.0;
  return p;
}

TEST(Perturbed, ASampleIsTheSameOneWhateverElseIsDrawn) {
  const Scenario scenario = load_scenario("realistic_obstacle_pass");
  const auto alone = everything(perturbed(scenario, {}, 1, 41));
  for (std::uint64_t sample = 0; sample < 41; ++sample) {
    EXPECT_NE(everything(perturbed(scenario, {}, 1, sample)), alone);
  }
  EXPECT_EQ(everything(perturbed(scenario, {}, 1, 41)), alone);
  EXPECT_NE(everything(perturbed(scenario, {}, 2, 41)), alone) << "another seed";
}

TEST(Perturbed, ASampleIsOneArmInEveryScenario) {
  const RobotModel a = plant_model(perturbed(load_scenario("realistic_fixed_target"), {}, 1, 5));
  const RobotModel b = plant_model(perturbed(load_scenario("realistic_obstacle_pass"), {}, 1, 5));
  EXPECT_EQ(theta_of(a.chain), theta_of(b.chain));
}

TEST(Perturbed, StaysWithinItsRangesFillsThemAndIsAnArmThatCanBeBuilt) {
  const Scenario scenario = load_scenario("realistic_obstacle_pass");
  const Perturbation range = of_the_arm();
  constexpr int kSamples = 400;
  double payload_sum = 0.0;
  double least_mass = 2.0;
  double most_friction = 0.0;
  double most_phase = 0.0;
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const Scenario drawn = perturbed(scenario, range, 7, k);
    const PlantConditions& plant = drawn.plant;
    for (const JointVector& factors : {plant.mass_factors, plant.inertia_factors, plant.rotor_factors}) {
      ASSERT_EQ(factors.size(), 6);
      EXPECT_GE(factors.minCoeff(), 0.8);
      EXPECT_LE(factors.maxCoeff(), 1.2);
    }
    const JointVector viscous = plant.viscous_friction.cwiseQuotient(scenario.plant.viscous_friction);
    const JointVector coulomb = plant.coulomb_friction.cwiseQuotient(scenario.plant.coulomb_friction);
    EXPECT_LT((viscous - coulomb).norm(), kRounding) << "one factor per joint";
    EXPECT_GE(viscous.minCoeff(), 0.5);
    EXPECT_LE(viscous.maxCoeff(), 1.5);
    EXPECT_GE(plant.payload.mass, 0.0);
    EXPECT_LE(plant.payload.mass, 3.0);
    EXPECT_EQ(plant.position_noise, scenario.plant.position_noise);
    EXPECT_EQ(plant.torque_delay_periods, scenario.plant.torque_delay_periods);
    std::vector<double> phases;
    for (const NamedPath& target : drawn.targets) phases.push_back(target.path.phase);
    for (const MovingObstacle& obstacle : drawn.obstacles) phases.push_back(obstacle.path.phase);
    for (const double phase : phases) {
      EXPECT_GE(phase, 0.0);
      EXPECT_LT(phase, 2.0 * M_PI);
      most_phase = std::max(most_phase, phase);
    }
    EXPECT_NE(drawn.obstacles[0].path.phase, drawn.obstacles[1].path.phase);
    validate(plant_model(drawn));
    EXPECT_EQ(start_theta(drawn), start_theta(scenario)) << "the controller knows nothing of it";
    payload_sum += plant.payload.mass;
    least_mass = std::min(least_mass, plant.mass_factors.minCoeff());
    most_friction = std::max(most_friction, viscous.maxCoeff());
  }
  // The mean of 400 uniform draws of width 3 has a deviation of 3 / sqrt(12 * 400) = 0.043; five of them.
  EXPECT_NEAR(payload_sum / kSamples, 1.5, 0.22);
  // 2400 draws miss the outer 1 % of a range with probability 0.99^2400 = 3e-11.
  EXPECT_LT(least_mass, 0.804);
  EXPECT_GT(most_friction, 1.49);
  EXPECT_GT(most_phase, 0.99 * 2.0 * M_PI);
}

/// A scenario whose arm has estimated rotor inertia in every joint but the first.
Scenario with_estimated_rotors() {
  Scenario scenario = load_scenario("realistic_fixed_target");
  RobotModel robot = *scenario.robot;
  for (Eigen::Index i = 1; i < robot.n(); ++i) robot.chain.rotor_inertia[i] = 0.0;
  estimate_rotors(robot);
  scenario.robot = std::make_shared<const RobotModel>(std::move(robot));
  return scenario;
}

TEST(Perturbed, AnEstimatedRotorInertiaIsAnythingFromAThirdToThreeTimes) {
  const Scenario scenario = with_estimated_rotors();
  constexpr int kSamples = 400;
  double sum = 0.0;
  double least = 1.0;
  double most = 1.0;
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const JointVector& factors = perturbed(scenario, of_the_arm(), 7, k).plant.rotor_factors;
    EXPECT_LE(std::abs(factors[0] - 1.0), 0.2) << "the file gives it";
    for (Eigen::Index i = 1; i < factors.size(); ++i) sum += std::log(factors[i]);
    least = std::min(least, factors.tail(5).minCoeff());
    most = std::max(most, factors.tail(5).maxCoeff());
  }
  EXPECT_GE(least, (1.0 - kRounding) / 3.0);
  EXPECT_LE(most, 3.0 * (1.0 + kRounding));
  // 2000 draws miss the outer 1 % of the logarithm's range with probability 0.99^2000 = 2e-9.
  EXPECT_LT(least, std::pow(3.0, -0.98));
  EXPECT_GT(most, std::pow(3.0, 0.98));
  // The mean of 2000 uniform draws of width 2 ln 3 has a deviation of 2 ln 3 / sqrt(12 * 2000) = 0.014.
  EXPECT_NEAR(sum / (5.0 * kSamples), 0.0, 0.07);
  Perturbation none = of_the_arm();
  none.rotor = 0.0;
  EXPECT_EQ(perturbed(scenario, none, 7, 0).plant.rotor_factors, JointVector::Ones(6));
}

TEST(WithRotorsScaled, MultipliesWhatIsEstimatedAndNothingElse) {
  Scenario scenario = with_estimated_rotors();
  JointVector estimated = JointVector::Constant(6, 3.0);
  estimated[0] = 1.0;
  EXPECT_EQ(with_rotors_scaled(scenario, 3.0).plant.rotor_factors, estimated);
  scenario.plant.rotor_factors = JointVector::Constant(6, 0.5);
  const Scenario scaled = with_rotors_scaled(scenario, 3.0);
  EXPECT_EQ(scaled.plant.rotor_factors, 0.5 * estimated) << "on top of the scenario's own";
  EXPECT_EQ(scaled.robot, scenario.robot);
  EXPECT_EQ(start_theta(scaled), start_theta(scenario)) << "the controller knows nothing of it";
}

TEST(Perturbed, WhatHasNoWidthStaysAndWhatIsAddedMovesNothingElse) {
  const Scenario scenario = load_scenario("realistic_obstacle_pass");
  Perturbation more = of_the_arm();
  more.center = 0.01;
  more.delay = 2;
  more.noise = 0.5;
  more.theta = 0.1;
  more.target_speed = 0.2;
  const Scenario plain = perturbed(scenario, of_the_arm(), 3, 8);
  const Scenario drawn = perturbed(scenario, more, 3, 8);
  EXPECT_EQ(plain.plant.center_offsets, Eigen::Matrix3Xd::Zero(3, 6));
  EXPECT_EQ(plain.plant.position_noise, scenario.plant.position_noise);
  EXPECT_EQ(plain.plant.torque_delay_periods, scenario.plant.torque_delay_periods);
  EXPECT_EQ(start_theta(plain), start_theta(scenario));
  EXPECT_EQ(plain.targets[0].path.frequency, scenario.targets[0].path.frequency);
  EXPECT_EQ(drawn.plant.mass_factors, plain.plant.mass_factors);
  EXPECT_EQ(drawn.plant.payload.mass, plain.plant.payload.mass);
  EXPECT_EQ(drawn.seed, plain.seed);
  EXPECT_EQ(drawn.obstacles[1].path.phase, plain.obstacles[1].path.phase);
}

TEST(Perturbed, MovesCentersDelayNoiseThetaAndTargetsWithinTheirRangesAndFillsThem) {
  const Scenario scenario = load_scenario("realistic_obstacle_pass");
  Perturbation range;
  range.center = 0.02;
  range.delay = 2;
  range.noise = 0.5;
  range.theta = 0.1;
  range.target_speed = 0.2;
  constexpr int kSamples = 300;
  std::array<int, 3> delays{};
  double far = 0.0;
  double near = 0.0;
  double fast = 0.0;
  double loud = 0.0;
  double sure = 0.0;
  for (std::uint64_t k = 0; k < kSamples; ++k) {
    const Scenario drawn = perturbed(scenario, range, 7, k);
    const RobotModel arm = plant_model(drawn);
    validate(arm);
    EXPECT_LE(drawn.plant.center_offsets.cwiseAbs().maxCoeff(), 0.02);
    far = std::max(far, drawn.plant.center_offsets.maxCoeff());
    near = std::min(near, drawn.plant.center_offsets.minCoeff());
    const int delay = drawn.plant.torque_delay_periods - scenario.plant.torque_delay_periods;
    ASSERT_GE(delay, 0);
    ASSERT_LE(delay, 2);
    ++delays[static_cast<std::size_t>(delay)];
    const double noise = drawn.plant.velocity_noise / scenario.plant.velocity_noise;
    EXPECT_NEAR(noise, drawn.plant.position_noise / scenario.plant.position_noise, kRounding);
    EXPECT_LE(std::abs(noise - 1.0), 0.5);
    loud = std::max(loud, noise);
    const double speed = drawn.targets[0].path.frequency / scenario.targets[0].path.frequency;
    EXPECT_LE(std::abs(speed - 1.0), 0.2 + kRounding);
    fast = std::max(fast, speed);
    EXPECT_LE(std::abs(drawn.theta.factors.maxCoeff() - 1.0), 0.1);
    sure = std::max(sure, drawn.theta.factors.maxCoeff());
  }
  for (const int count : delays) EXPECT_NEAR(count, kSamples / 3, 45);  // five deviations
  EXPECT_GT(far, 0.0199);
  EXPECT_LT(near, -0.0199);
  EXPECT_GT(loud, 1.47);  // 300 draws miss the outer 3 % with probability 1e-4
  EXPECT_GT(fast, 1.19);
  EXPECT_GT(sure, 1.099);
}

TEST(Perturbed, PathsThroughKnotsVaryTheirSpeedAndThoseThatComeRoundTheirBeginning) {
  Scenario scenario = load_scenario("obstacle_pass");
  const std::vector<Vec3> corners = {{0, 0, 0}, {0.4, 0, 0.1}, {0.4, 0.5, 0}};
  scenario.targets.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    scenario.targets[i].path = {};
    scenario.targets[i].path.spline =
        std::make_shared<const PositionSpline>(polyline(corners, 0.2, 0.03, i == 0));
  }
  Perturbation perturbation;
  perturbation.target_speed = 0.2;
  const double turn = scenario.targets[0].path.period();
  double slowest = 1.0, fastest = 1.0, earliest = turn, latest = 0.0;
  for (std::uint64_t sample = 1; sample <= 200; ++sample) {
    const Scenario other = perturbed(scenario, perturbation, 7, sample);
    const Path& round = other.targets[0].path;
    slowest = std::min(slowest, round.spline_rate);
    fastest = std::max(fastest, round.spline_rate);
    earliest = std::min(earliest, round.spline_lead);
    latest = std::max(latest, round.spline_lead);
    EXPECT_NE(other.targets[1].path.spline_rate, 1.0);
    EXPECT_EQ(other.targets[1].path.spline_lead, 0.0) << "what does not come round begins where it does";
  }
  EXPECT_GE(slowest, 0.8);
  EXPECT_LE(fastest, 1.2);
  EXPECT_LT(slowest, 0.82);
  EXPECT_GT(fastest, 1.18);
  EXPECT_GE(earliest, 0.0);
  EXPECT_LE(latest, turn);
  EXPECT_LT(earliest, 0.05 * turn);
  EXPECT_GT(latest, 0.95 * turn);
}

TEST(Perturbed, ByDefaultCarriesUpToThreeTimesTheHeaviestPayload) {
  const std::vector<Scenario> bare = {load_scenario("moving_target")};
  EXPECT_EQ(default_perturbation(bare).payload, 0.0) << "no payload: none is drawn";
  const std::vector<Scenario> loaded = {load_scenario("youbot_realistic_moving_target")};
  EXPECT_DOUBLE_EQ(default_perturbation(loaded).payload, 3.0 * loaded[0].plant.payload.mass);
  const std::vector<Scenario> both = {bare[0], load_scenario("realistic_moving_target")};
  EXPECT_DOUBLE_EQ(default_perturbation(both).payload, 3.0)
      << "the UR10 of the realistic scenarios carries 1 kg";
  EXPECT_EQ(default_perturbation(both).mass, Perturbation().mass);
}

TEST(Perturbed, RefusesRangesThatLeaveNoArm) {
  const Scenario scenario = load_scenario("moving_target");
  Perturbation wide;
  wide.mass = 1.0;
  EXPECT_THAT([&] { perturbed(scenario, wide, 1, 0); },
              test::refused_at({.key = "perturbation/mass", .value = "1", .limit = "in [0, 1)"}));
  Perturbation heavy;
  heavy.payload = -1.0;
  EXPECT_THAT([&] { perturbed(scenario, heavy, 1, 0); },
              test::refused_at({.key = "perturbation/payload", .value = "-1"}));
}

TEST(Perturbed, RefusesEveryWidthThatIsOutOfRangeByName) {
  for (const PerturbationField& field : perturbation_fields()) {
    for (const double wrong : {-0.1, field.most + 1.0, double{NAN}}) {
      Perturbation p;
      p.*field.width = wrong;
      EXPECT_THAT([&] { validate(p); }, test::refused_at({.key = std::string("perturbation/") + field.name,
                                                          .value = fmt::to_string(wrong)}));
    }
    Perturbation edge;
    edge.*field.width = field.most;
    if (field.most_included) {
      EXPECT_NO_THROW(validate(edge)) << field.name;
    } else {
      EXPECT_THAT([&] { validate(edge); }, test::refused_at({.key = std::string("perturbation/") + field.name,
                                                             .value = "1",
                                                             .limit = "in [0, 1)"}));
    }
  }
  Perturbation half;
  half.delay = 0.5;
  EXPECT_THAT([&] { validate(half); }, test::refused_at({.key = "perturbation/delay",
                                                         .value = "0.5",
                                                         .limit = "a whole number of control periods"}));
}

TEST(Perturbed, ByNothingIsTheScenarioButForItsSeed) {
  const Scenario scenario = load_scenario("realistic_obstacle_pass");
  const Scenario same = perturbed(scenario, no_perturbation(), 1, 3);
  EXPECT_EQ(same.plant.payload.mass, scenario.plant.payload.mass);
  EXPECT_EQ(same.plant.torque_delay_periods, scenario.plant.torque_delay_periods);
  EXPECT_EQ(same.plant.velocity_noise, scenario.plant.velocity_noise);
  EXPECT_EQ(theta_of(plant_model(same).chain), theta_of(plant_model(scenario).chain));
  EXPECT_EQ(start_theta(same), start_theta(scenario));
  EXPECT_EQ(same.obstacles[0].path.phase, scenario.obstacles[0].path.phase);
}

// The controller keeps away from a ball where it is; contact is looked for in the same place.
TEST(Perturbation, ObstaclesAreInTheCellWhereTheyAreInTheScenario) {
  const test::TemporaryFolder folder;
  const Scenario scenario = load_scenario(
      folder.write("balls.yaml",
                   "base: realistic_fixed_target\n"
                   "obstacles:\n"
                   "  - {name: point, circle: {center: [1, 1, 1], radius: 0.2, period: 4}}\n"
                   "  - {name: ball, circle: {center: [-1, 1, 1], radius: 0.3, period: 5}, radius: 0.1}\n"
                   "cell: {parts: [{name: wall, box: [0.1, 2, 2], center: [-2, 0, 0]}]}\n"));
  const Scenario drawn = perturbed(scenario, {}, 1, 5);
  ASSERT_EQ(drawn.clearance->cell().parts.size(), 2U);
  const CellPart& ball = drawn.clearance->cell().parts[1];
  ASSERT_TRUE(ball.is_obstacle);
  EXPECT_NE(drawn.obstacles[1].path.phase, scenario.obstacles[1].path.phase);
  for (const double t : {0.0, 1.3})
    EXPECT_EQ(ball.path.at(t).position, drawn.obstacles[1].path.at(t).position);
  EXPECT_EQ(drawn.clearance->cell().parts[0].path.at(0.0).position, Vec3(-2.0, 0.0, 0.0));
  EXPECT_EQ(drawn.clearance->pairs().size(), scenario.clearance->pairs().size());
}

}  // namespace perturbation_test
}  // namespace armtune::internal
