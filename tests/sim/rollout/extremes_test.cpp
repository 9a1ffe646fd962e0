// What a search, or a file from a stranger, may ask of a rollout: it ends, with a status that says when,
// where and why, and with no figure that is infinite.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <memory>

#include "core/robot/kinematics.hpp"
#include "sim/rollout/rollout.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace extremes_test {

using test::quick_gains;
using test::scenario_of;

struct Extreme {
  const char* name;
  const char* scenario;
  double duration;  ///< [s]
  std::function<void(Scenario&, Gains&)> change;
};

std::ostream& operator<<(std::ostream& out, const Extreme& extreme) {
  return out << extreme.name;
}

JointVector six(double a, double b, double c, double d, double e, double f) {
  return (Vec6() << a, b, c, d, e, f).finished();
}

/// Where a frame's origin is at the start.
Vec3 origin_of_joint(const Scenario& scenario, std::size_t joint) {
  Poses poses;
  forward_kinematics(scenario.robot->chain, scenario.start_position, poses);
  return poses.p_0B[joint];
}

Path standing_at(const Vec3& point) {
  Path path;
  path.center = point;
  return path;
}

void limit_torques(Scenario& scenario, double effort) {
  auto weak = std::make_shared<RobotModel>(*scenario.robot);
  for (JointInfo& joint : weak->joints) joint.limits.effort = effort;
  scenario.robot = weak;
}

/// [s] for every case in the slowest of builds, under sanitizers; the release build needs less than one.
constexpr double kDeadline = 120.0;

const std::vector<Extreme> kExtremes = {
    {"KpHuge", "moving_target", 4.0, [](Scenario&, Gains& g) { g.joint_space_gains_p *= 1e6; }},
    {"CartesianKpHuge", "moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_p *= 1e6; }},
    {"KiHuge", "moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_i = Vec6::Constant(1e9); }},
    {"KdChatters", "realistic_moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_d *= 1e4; }},
    {"KdNone", "moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_d.setZero(); }},
    {"KdNegative", "moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_d *= -1.0; }},
    {"KdNaN", "moving_target", 4.0, [](Scenario&, Gains& g) { g.joint_space_gains_d[3] = NAN; }},
    {"KpInfinite", "moving_target", 6.0, [](Scenario&, Gains& g) { g.task_space_gains_p[0] = INFINITY; }},
    {"AdaptationHuge", "moving_target", 6.0, [](Scenario&, Gains& g) { g.adaptation_gain = 1e9; }},
    {"TargetInTheBase", "moving_target", 8.0,
     [](Scenario& s, Gains&) { s.targets[0].path = standing_at(Vec3::Zero()); }},
    {"TargetOnTheTool", "moving_target", 8.0, [](Scenario& s, Gains&) { s.targets[0].path = s.path; }},
    {"PathInTheBase", "moving_target", 8.0, [](Scenario& s, Gains&) { s.path = standing_at(Vec3::Zero()); }},
    {"PathOutOfReach", "moving_target", 8.0,
     [](Scenario& s, Gains&) { s.path = standing_at(Vec3(50.0, 0.0, 0.0)); }},
    {"ObstacleOnAJoint", "obstacle_pass", 6.0,
     [](Scenario& s, Gains&) {
       for (MovingObstacle& o : s.obstacles) o.path = standing_at(origin_of_joint(s, 3));
     }},
    {"ObstacleOnTheTool", "obstacle_pass", 8.0,
     [](Scenario& s, Gains&) {
       for (MovingObstacle& o : s.obstacles) o.path = s.path;
     }},
    {"StretchedOut", "moving_target", 8.0, [](Scenario& s, Gains&) { s.start_position.setZero(); }},
    {"GoalStretchedOut", "moving_target", 8.0, [](Scenario&, Gains& g) { g.joint_space_goal.setZero(); }},
    {"GoalWithWristsAligned", "moving_target", 8.0,
     [](Scenario&, Gains& g) { g.joint_space_goal = six(0.0, -90.0, 90.0, 0.0, 0.0, 0.0); }},
    {"StartBeyondEveryLimit", "moving_target", 4.0,
     [](Scenario& s, Gains&) { s.start_position = JointVector::Constant(6, 1e3); }},
    {"TenthOfAMillisecond", "moving_target", 3.0, [](Scenario& s, Gains&) { s.control_period = 1e-4; }},
    {"TwentyMilliseconds", "moving_target", 8.0, [](Scenario& s, Gains&) { s.control_period = 0.02; }},
    {"FiftyMilliseconds", "moving_target", 8.0, [](Scenario& s, Gains&) { s.control_period = 0.05; }},
    {"FiftyMillisecondsWithNoise", "realistic_moving_target", 8.0,
     [](Scenario& s, Gains&) { s.control_period = 0.05; }},
    {"LateByASecond", "moving_target", 6.0, [](Scenario& s, Gains&) { s.plant.torque_delay_periods = 500; }},
    {"NoiseOfARadian", "moving_target", 6.0, [](Scenario& s, Gains&) { s.plant.position_noise = 1.0; }},
    {"PayloadOfATon", "moving_target", 6.0, [](Scenario& s, Gains&) { s.plant.payload.mass = 1000.0; }},
    {"NoTorque", "moving_target", 6.0, [](Scenario& s, Gains&) { limit_torques(s, 0.0); }},
    {"HardlyAnyTorque", "moving_target", 6.0, [](Scenario& s, Gains&) { limit_torques(s, 1e-9); }},
    {"FrictionThatNothingMoves", "moving_target", 6.0,
     [](Scenario& s, Gains&) { s.plant.coulomb_friction = JointVector::Constant(6, 1e6); }},
};

class Extremes : public testing::TestWithParam<std::tuple<Extreme, Engine>> {};

TEST_P(Extremes, EndWithAStatusAndWithoutInfiniteFigures) {
  const auto& [extreme, engine] = GetParam();
  Scenario scenario = scenario_of(extreme.scenario, extreme.duration);
  Gains gains = quick_gains(scenario);
  extreme.change(scenario, gains);
  long periods = 0;
  const auto began = std::chrono::steady_clock::now();
  const RolloutResult result =
      Rollout(scenario, Stepper::kMidpoint, engine).run(gains, [&](const Observation&) {
        return ++periods <= scenario.periods();
      });
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  EXPECT_LT(took.count(), kDeadline);
  EXPECT_LE(periods, scenario.periods()) << "ends by itself";
  EXPECT_LE(result.end_time, scenario.duration + 1e-9);
  for (const Metric metric : all_metrics()) EXPECT_FALSE(std::isinf(result.metrics[metric])) << name(metric);
  switch (result.status) {
    case RolloutStatus::kCompleted:
      EXPECT_EQ(result.reason, "");
      EXPECT_GT(result.metrics[Metric::kSamples], 0.0);
      EXPECT_TRUE(std::isfinite(result.metrics[Metric::kPositionMax]));
      break;
    case RolloutStatus::kDiverged:
      EXPECT_THAT(result.reason, testing::MatchesRegex("diverged at [0-9.]+ s in the state [a-zA-Z]+: .*"));
      EXPECT_LT(result.end_time, scenario.duration);
      break;
    default:
      EXPECT_EQ(result.status, RolloutStatus::kNoSamples) << result.reason;
      EXPECT_THAT(result.reason,
                  testing::MatchesRegex("no control period in [0-9.]+ s .*; the last state was [a-zA-Z]+"));
      EXPECT_TRUE(std::isnan(result.metrics[Metric::kPositionMax]))
          << "nothing was tracked, so there is no error";
  }
  RecordProperty("ended_as", name(result.status));
}

INSTANTIATE_TEST_SUITE_P(Each, Extremes,
                         testing::Combine(testing::ValuesIn(kExtremes),
                                          testing::Values(Engine::kSimbody, Engine::kNative)),
                         [](const auto& test) {
                           return std::string(std::get<0>(test.param).name) + "_" +
                                  name(std::get<1>(test.param));
                         });

}  // namespace extremes_test
}  // namespace armtune::internal
