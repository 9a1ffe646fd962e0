#include "sim/rollout/rollout.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <thread>

#include "core/robot/kinematics.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace rollout_test {

using test::bits;
using test::joint_path;
using test::largest_difference;
using test::published_gains;
using test::quick_gains;
using test::scenario_of;
using testing::HasSubstr;

RolloutResult run(const Scenario& scenario, const Gains& gains, const Observer& observer = {}) {
  return Rollout(scenario, Stepper::kMidpoint).run(gains, observer);
}

double largest(const Metrics& m, Metric x, Metric y, Metric z) {
  return std::max({m[x], m[y], m[z]});
}

TEST(Rollout, ErrorsOnTheMovingTargetAreOfTheSizeOfThePublishedOnes) {
  const Scenario scenario = scenario_of("moving_target");
  const RolloutResult result = run(scenario, published_gains(scenario));
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  const double orientation =
      largest(result.metrics, Metric::kOrientationXMax, Metric::kOrientationYMax, Metric::kOrientationZMax);
  const double position =
      largest(result.metrics, Metric::kPositionXMax, Metric::kPositionYMax, Metric::kPositionZMax);
  RecordProperty("orientation", std::to_string(orientation));
  RecordProperty("position", std::to_string(position));
  EXPECT_GE(orientation, 0.020);
  EXPECT_LE(orientation, 0.045);
  EXPECT_GE(position, 0.001);
  EXPECT_LE(position, 0.004);
}

TEST(Rollout, ObstaclePassGoesThroughAllFourStatesByTheirTransitions) {
  const Scenario scenario = scenario_of("obstacle_pass");
  std::vector<ControlState> states;
  const RolloutResult result = run(scenario, published_gains(scenario), [&](const Observation& o) {
    if (states.empty() || states.back() != o.control->state) states.push_back(o.control->state);
    return true;
  });
  ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  using enum ControlState;
  ASSERT_GE(states.size(), 4U);
  EXPECT_EQ(states.front(), kLeaveSingularity);
  for (const ControlState state : {kReturnToTrajectory, kFollowTrajectory, kAvoidObstacles}) {
    EXPECT_THAT(states, testing::Contains(state));
  }
  for (std::size_t i = 1; i < states.size(); ++i) {
    const std::pair step{states[i - 1], states[i]};
    EXPECT_THAT((std::vector{std::pair{kLeaveSingularity, kReturnToTrajectory},
                             std::pair{kReturnToTrajectory, kFollowTrajectory},
                             std::pair{kReturnToTrajectory, kAvoidObstacles},
                             std::pair{kFollowTrajectory, kAvoidObstacles},
                             std::pair{kAvoidObstacles, kReturnToTrajectory}}),
                testing::Contains(step))
        << name(step.first) << " -> " << name(step.second);
  }
  // Obstacles pass, they do not stay: it comes back to its path after having avoided.
  const auto first_avoidance = std::find(states.begin(), states.end(), kAvoidObstacles);
  EXPECT_NE(std::find(first_avoidance, states.end(), kFollowTrajectory), states.end());
  EXPECT_LT(result.metrics[Metric::kObstacleMinClearance], published_gains(scenario).obstacleInfluenceRadius);
}

TEST(Rollout, SteppersAgreeWithTheReferenceAsTheirOrdersLetExpect) {
  const Scenario scenario = scenario_of("moving_target", 15.0);
  const Gains gains = published_gains(scenario);
  const auto reference = joint_path(scenario, gains, Stepper::kReference);
  ASSERT_EQ(reference.size(), static_cast<std::size_t>(scenario.periods()));
  const auto check = [&](Stepper stepper, double tolerance) {
    const auto path = joint_path(scenario, gains, stepper);
    ASSERT_EQ(path.size(), reference.size());
    const double difference = largest_difference(path, reference);
    RecordProperty(name(stepper), std::to_string(std::log10(difference)));
    EXPECT_LE(difference, tolerance) << name(stepper);
    EXPECT_GT(difference, 0.0) << name(stepper) << " is another way of stepping";
  };
  check(Stepper::kMidpoint, 1e-4);
  check(Stepper::kRungeKutta4, 1e-7);
  check(Stepper::kSemiImplicitEuler, 5e-3);
}

TEST(Rollout, IsAPureFunctionOfScenarioGainsAndSeed) {
  const Scenario scenario = scenario_of("realistic_moving_target", 9.0);
  const Gains gains = quick_gains(scenario);
  Rollout rollout(scenario, Stepper::kMidpoint);
  const auto first = bits(rollout.run(gains).metrics);
  Gains others = gains;
  others.task_space_gains_p *= 1.5;
  EXPECT_NE(bits(rollout.run(others).metrics), first);
  EXPECT_EQ(bits(rollout.run(gains).metrics), first) << "nothing carries over from an earlier run";
  std::vector<std::uint64_t> elsewhere;
  std::thread([&] { elsewhere = bits(Rollout(scenario, Stepper::kMidpoint).run(gains).metrics); }).join();
  EXPECT_EQ(elsewhere, first);
}

TEST(Rollout, DifferentSeedsGiveDifferentNoise) {
  Scenario scenario = scenario_of("realistic_moving_target", 6.0);
  const Gains gains = quick_gains(scenario);
  const auto first = bits(run(scenario, gains).metrics);
  ++scenario.seed;
  EXPECT_NE(bits(run(scenario, gains).metrics), first);
}

TEST(Rollout, ExplodingGainsEndAsDivergedWithTimeStateAndJoint) {
  const Scenario scenario = scenario_of("moving_target", 15.0);
  Gains gains = published_gains(scenario);
  // Torque is bounded by the effort limits: it takes a Kp that turns small errors into fast references.
  gains.joint_space_gains_p *= 100.0;
  const RolloutResult result = run(scenario, gains);
  ASSERT_EQ(result.status, RolloutStatus::kDiverged);
  EXPECT_LT(result.end_time, scenario.duration);
  EXPECT_GT(result.end_time, 0.0);
  EXPECT_THAT(result.reason, testing::MatchesRegex("diverged at [0-9.]+ s in the state [a-zA-Z]+: .*"));
  EXPECT_THAT(result.reason, HasSubstr("leaveSingularity"));
  EXPECT_THAT(result.reason, HasSubstr(fmt::format("diverged at {:.3f} s ", result.end_time)));
  const auto joints = joint_names(*scenario.robot);
  EXPECT_TRUE(std::any_of(joints.begin(), joints.end(), [&](const std::string& joint) {
    return result.reason.find(joint) != std::string::npos;
  })) << result.reason;
  std::smatch said;
  ASSERT_TRUE(std::regex_search(
      result.reason, said, std::regex("moves at ([-0-9.e+]+), over 20 times its velocity limit ([0-9.]+)")))
      << result.reason;
  EXPECT_GT(std::abs(std::stod(said[1])), 0.99 * 20.0 * std::stod(said[2])) << "of three digits";
}

TEST(Rollout, BeginsAtRestInItsStartPose) {
  const Scenario scenario = scenario_of("moving_target", 0.1);
  run(scenario, published_gains(scenario), [&](const Observation& o) {
    EXPECT_EQ(o.time, 0.0);
    EXPECT_EQ(*o.q, scenario.start_position);
    EXPECT_TRUE(o.qd->isZero(0.0));
    return false;
  });
}

TEST(Rollout, GainsThatExplodeOnlyAfterLeavingTheSingularityDivergeInTheCartesianLaw) {
  const Scenario scenario = scenario_of("moving_target", 15.0);
  Gains gains = quick_gains(scenario);
  gains.task_space_gains_p *= 100.0;
  const RolloutResult result = run(scenario, gains);
  ASSERT_EQ(result.status, RolloutStatus::kDiverged);
  EXPECT_GE(result.end_time, gains.joint_trajectory_duration);
  EXPECT_THAT(result.reason, testing::Not(HasSubstr("leaveSingularity")));
}

TEST(Rollout, ATorqueThatIsNotANumberIsSeenAsDiverged) {
  const Scenario scenario = scenario_of("moving_target", 2.0);
  Gains gains = published_gains(scenario);
  gains.joint_space_gains_d[2] = std::nan("");
  const RolloutResult result = run(scenario, gains);
  ASSERT_EQ(result.status, RolloutStatus::kDiverged);
  EXPECT_THAT(result.reason, HasSubstr("not finite"));
  EXPECT_LT(result.end_time, 0.01);
}

TEST(Rollout, AScenarioTooShortToTrackHasNoSamples) {
  const Scenario scenario = scenario_of("moving_target", 7.0);
  const RolloutResult result = run(scenario, published_gains(scenario));
  EXPECT_EQ(result.status, RolloutStatus::kNoSamples);
  EXPECT_THAT(result.reason, HasSubstr("followTrajectory"));
  EXPECT_EQ(result.end_time, 7.0);
  EXPECT_EQ(result.metrics[Metric::kSamples], 0.0);
  EXPECT_TRUE(std::isnan(result.metrics[Metric::kPositionMax]));
  EXPECT_FALSE(std::isnan(result.metrics[Metric::kJointVelocityMaxRatio])) << "limits count always";
}

TEST(Rollout, StopsWhereTheObserverSaysSo) {
  const Scenario scenario = scenario_of("moving_target", 5.0);
  const RolloutResult result =
      run(scenario, published_gains(scenario), [](const Observation& o) { return o.time < 1.0; });
  EXPECT_EQ(result.status, RolloutStatus::kInterrupted);
  EXPECT_DOUBLE_EQ(result.end_time, 1.0);
}

TEST(Rollout, EveryDifferenceBetweenModelAndArmChangesTheResult) {
  const Scenario ideal = scenario_of("moving_target", 7.0);
  const Gains gains = quick_gains(ideal);
  const auto undisturbed = bits(run(ideal, gains).metrics);
  const auto changed = [&](const char* what, auto&& change) {
    Scenario scenario = ideal;
    change(scenario.plant);
    EXPECT_NE(bits(run(scenario, gains).metrics), undisturbed) << what;
  };
  changed("position noise", [](PlantConditions& p) { p.position_noise = 1e-4; });
  changed("velocity noise", [](PlantConditions& p) { p.velocity_noise = 0.01; });
  changed("delay", [](PlantConditions& p) { p.torque_delay_periods = 1; });
  changed("payload", [](PlantConditions& p) { p.payload.mass = 1.0; });
  changed("viscous friction", [](PlantConditions& p) { p.viscous_friction = JointVector::Constant(6, 1.0); });
  changed("Coulomb friction", [](PlantConditions& p) { p.coulomb_friction = JointVector::Constant(6, 1.0); });
  Scenario reseeded = ideal;
  reseeded.seed = 99;
  EXPECT_EQ(bits(run(reseeded, gains).metrics), undisturbed) << "without noise the seed means nothing";
}

TEST(Rollout, ErrorsComeFromTheTrueStateAndNotFromNoisyMeasurements) {
  Scenario scenario = scenario_of("moving_target", 7.0);
  constexpr double kNoise = 1e-4;
  scenario.plant.position_noise = kNoise;
  const double h = scenario.control_period;
  JointVector q, qd;
  double jump = 0.0;
  double difference = 0.0;
  run(scenario, quick_gains(scenario), [&](const Observation& o) {
    // Of a true state q and q' belong together: what a period's motion leaves over is of order h^3, while
    // two samples of noise would differ by some 1.4e-4 rad.
    if (q.size() > 0) {
      jump = std::max(jump, (*o.q - q - 0.5 * h * (*o.qd + qd)).lpNorm<Eigen::Infinity>());
    }
    q = *o.q;
    qd = *o.qd;
    Poses poses;
    forward_kinematics(scenario.robot->chain, *o.q, poses);
    if (o.control->state == ControlState::kFollowTrajectory) {
      difference =
          std::max(difference, (o.error.head<3>() - (poses.p_0T - o.control->desired.position)).norm());
    }
    return true;
  });
  EXPECT_LT(jump, 0.1 * kNoise);
  EXPECT_LT(difference, 1e-15);
}

TEST(Rollout, CommandsReachTheArmLateByTheDelay) {
  Scenario scenario = scenario_of("moving_target", 0.2);
  scenario.plant.torque_delay_periods = 3;
  std::vector<JointVector> commanded, applied;
  run(scenario, published_gains(scenario), [&](const Observation& o) {
    commanded.push_back(o.control->torque);
    applied.push_back(*o.applied);
    return true;
  });
  ASSERT_EQ(applied.size(), 100U);
  for (std::size_t k = 0; k < applied.size(); ++k) {
    const JointVector expected = k < 3 ? JointVector(JointVector::Zero(6)) : commanded[k - 3];
    EXPECT_EQ(applied[k], expected) << "period " << k;
  }
}

}  // namespace rollout_test
}  // namespace armtune::internal
