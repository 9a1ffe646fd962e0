#include "sim/rollout/true_state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/control/obstacle_distance.hpp"
#include "core/robot/link_radius.hpp"
#include "core/robot/slotine_li.hpp"
#include "core/trajectory/gaze.hpp"
#include "core/trajectory/rotation.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace true_state_test {

Eigen::AngleAxisd turn_by(const Vec3& vector) {
  const double angle = vector.norm();
  return {angle, angle > 0.0 ? Vec3(vector / angle) : Vec3(Vec3::UnitX())};
}

TEST(TrueState, OrientationErrorsAreAgainstTheGazeAndInASlerpAgainstTheSlerp) {
  const Scenario scenario = test::scenario_of("target_switch", 12.0);
  int slerping = 0;
  int direct = 0;
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    if (o.control->state == ControlState::kLeaveSingularity) {
      EXPECT_TRUE(o.error.isZero(0.0));
      return true;
    }
    EXPECT_NEAR(o.gaze_angle, gaze_angle(o.poses->R_0T, o.poses->p_0T, o.target_motion.position), 1e-15);
    // The error is the turn from the desired orientation to the true one.
    const Mat3 desired = turn_by(o.error.tail<3>()).inverse() * o.poses->R_0T;
    if (o.control->slerping) {
      ++slerping;
      EXPECT_LT((desired - o.control->desired_gaze.orientation.toRotationMatrix()).norm(), 1e-9);
    } else {
      ++direct;
      const Vec3 line = (o.target_motion.position - o.poses->p_0T).normalized();
      EXPECT_LT((desired.col(2) - line).norm(), 1e-9) << "what is desired looks at the target";
      EXPECT_NEAR(o.error.tail<3>().norm(), o.gaze_angle, 1e-12) << "by the shortest turn";
    }
    return true;
  });
  EXPECT_GT(slerping, 100);
  EXPECT_GT(direct, 100);
}

TEST(TrueState, LinearErrorsAreAgainstThePathWhereItIsFollowed) {
  const Scenario scenario = test::scenario_of("moving_target", 12.0);
  int followed = 0;
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    if (o.control->state != ControlState::kFollowTrajectory) return true;
    ++followed;
    const MotionPoint<Vec3> path = scenario.path.at(o.time);
    EXPECT_LT((o.error.head<3>() - (o.poses->p_0T - path.position)).norm(), 1e-14);
    EXPECT_LT((o.error_rate.head<3>() - (o.twist.head<3>() - path.velocity)).norm(), 1e-14);
    return true;
  });
  EXPECT_GT(followed, 100);
}

TEST(TrueState, TheAngularVelocityErrorIsAgainstTheTurnOfWhatIsDesired) {
  const Scenario scenario = test::scenario_of("target_switch", 12.0);
  const double h = scenario.control_period;
  struct Period {
    bool slerping = false;
    Eigen::Quaterniond desired;
    Vec3 wanted;  ///< desired angular velocity, from the error
  };
  std::vector<Period> periods;
  Gains gains = test::quick_gains(scenario);
  gains.gaze_feedforward = true;  // without, the rates leave out that the line to the target turns
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&](const Observation& o) {
    periods.push_back({o.control->slerping, o.control->desired_gaze.orientation,
                       o.twist.tail<3>() - o.error_rate.tail<3>()});
    return true;
  });
  // Between two periods what is desired turns by the mean of its angular velocities in them, but for what the
  // tool, where the line begins, moves beside its path.
  double way = 0.0;
  double beside = 0.0;
  for (std::size_t k = 1; k < periods.size(); ++k) {
    if (!periods[k].slerping || !periods[k - 1].slerping) continue;
    const Vec3 turn = rotation_log(periods[k].desired * periods[k - 1].desired.conjugate());
    way += turn.norm();
    beside += (turn - 0.5 * h * (periods[k].wanted + periods[k - 1].wanted)).norm();
  }
  EXPECT_GT(way, 0.3) << "rad";
  EXPECT_LT(beside, 0.2 * way);
}

TEST(TrueState, PosesAndCompensationAreThoseOfTheArmAndNotOfWhatIsMeasured) {
  Scenario scenario = test::scenario_of("realistic_moving_target", 4.0);
  scenario.plant.position_noise = 1e-3;
  const Chain& chain = scenario.robot->chain;
  const std::vector<Scenario> both{scenario, test::scenario_of("moving_target", 4.0)};
  for (const Scenario& each : both) {
    const ParameterVector truth = theta_of(plant_model(each).chain);
    Rollout(each, Stepper::kMidpoint).run(test::quick_gains(each), [&](const Observation& o) {
      Poses poses;
      forward_kinematics(chain, *o.q, poses);
      EXPECT_LT((o.poses->p_0T - poses.p_0T).norm(), 1e-14);
      SlotineLi motion;
      slotine_li_forward(chain, poses, *o.qd, o.control->reference.velocity,
                         o.control->reference.acceleration, motion);
      Regressor Y;
      slotine_li_regressor(chain, poses, motion, Y);
      const double expected = (Y * (*o.theta - truth)).norm();
      EXPECT_NEAR(o.compensation_error, expected, 1e-9 * (1.0 + expected));
      return true;
    });
  }
}

TEST(TrueState, TwistIsTheDerivativeOfThePose) {
  const Scenario scenario = test::scenario_of("moving_target", 5.0);
  const double h = scenario.control_period;
  Vec3 p = Vec3::Zero(), v = Vec3::Zero();
  double worst = 0.0;
  Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
    if (o.time > 0.0) {
      worst = std::max(worst, (o.poses->p_0T - p - 0.5 * h * (o.twist.head<3>() + v)).norm());
    }
    p = o.poses->p_0T;
    v = o.twist.head<3>();
    return true;
  });
  EXPECT_LT(worst, 1e-5) << "the trapezoidal rule leaves h^3";
}

TEST(TrueState, CompensationIsExactWhereThetaIsTheArm) {
  Scenario scenario = test::scenario_of("moving_target", 5.0);
  scenario.theta.model_scale = 1.0;
  Gains gains = test::quick_gains(scenario);
  gains.adaptation_gain = 0.0;
  EXPECT_LT(Rollout(scenario, Stepper::kMidpoint).run(gains).metrics[Metric::kCompensationErrorRms], 1e-9);
  scenario.plant.payload.mass = 1.0;  // the truth is that of the plant
  EXPECT_GT(Rollout(scenario, Stepper::kMidpoint).run(gains).metrics[Metric::kCompensationErrorRms], 1.0);
}

/// Smallest distance from the obstacles' surfaces of the joint origins and, if asked for, the tool, from
/// poses of the true joint positions.
double nearest_point(const Scenario& scenario, const Observation& o, bool tool) {
  Poses poses;
  forward_kinematics(scenario.robot->chain, *o.q, poses);
  std::vector<Vec3> points;
  for (int i = 0; i < poses.n; ++i) points.push_back(poses.p_0B[static_cast<std::size_t>(i)]);
  if (tool) points.push_back(poses.p_0T);
  double closest = HUGE_VAL;
  for (const MovingObstacle& obstacle : scenario.obstacles) {
    for (const Vec3& p : points)
      closest = std::min(closest, (p - obstacle.path.at(o.time).position).norm() - obstacle.radius);
  }
  return closest;
}

TEST(TrueState, ClearanceIsThatOfTheClosestJointOrTheTool) {
  // With noise the controller's distance and the true one are two.
  for (const char* name : {"obstacle_pass", "realistic_obstacle_pass"}) {
    Scenario scenario = test::scenario_of(name, 9.0);
    scenario.obstacles[1].radius = 0.3;
    int tool_is_nearest = 0;
    double smallest = HUGE_VAL;
    const RolloutResult result =
        Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
          const double expected = nearest_point(scenario, o, true);
          EXPECT_NEAR(o.clearance, expected, 1e-12);
          if (expected < nearest_point(scenario, o, false) - 1e-3) ++tool_is_nearest;
          smallest = std::min(smallest, o.clearance);
          return true;
        });
    EXPECT_GT(tool_is_nearest, 100) << name;
    EXPECT_EQ(result.metrics[Metric::kObstacleMinClearance], smallest) << name;
  }
}

TEST(TrueState, AnObstacleAtTheToolAloneIsSeenAndMovesNothing) {
  // The tool passes through a point of its circle. The published law counts joint origins only.
  for (const Engine engine : {Engine::kSimbody, Engine::kNative}) {
    const Scenario without = test::scenario_of("moving_target", 9.0);
    Scenario with = without;
    Path at_rest;
    at_rest.center = without.path.at(7.0).position;
    with.obstacles = {{"on the circle", at_rest}};
    Gains gains = test::quick_gains(without);
    gains.obstacleInfluenceRadius = 0.08;  // m, within the 0.23 m from the last joint's origin to the tool
    std::vector<JointVector> alone;
    Rollout(without, Stepper::kMidpoint, engine).run(gains, [&](const Observation& o) {
      alone.push_back(*o.q);
      return true;
    });
    double of_joints = HUGE_VAL;
    std::size_t period = 0;
    const RolloutResult result =
        Rollout(with, Stepper::kMidpoint, engine).run(gains, [&](const Observation& o) {
          EXPECT_NE(o.control->state, ControlState::kAvoidObstacles);
          EXPECT_EQ(*o.q, alone.at(period++));
          of_joints = std::min(of_joints, o.control->obstacle_distance);
          return true;
        });
    EXPECT_EQ(period, alone.size());
    EXPECT_GT(of_joints, gains.obstacleInfluenceRadius);
    EXPECT_LT(result.metrics[Metric::kObstacleMinClearance], 0.02) << "m, of the tool on its circle";
  }
}

TEST(TrueState, ClearanceOfLinksIsTheirs) {
  // With noise the controller's distance and the true one are two.
  for (const char* name : {"obstacle_pass", "realistic_obstacle_pass"}) {
    Scenario scenario = test::scenario_of(name, 1.0);
    scenario.robot = std::make_shared<const RobotModel>(with_link_surfaces(*scenario.robot));
    const RobotModel& robot = *scenario.robot;
    const RolloutResult result =
        Rollout(scenario, Stepper::kMidpoint).run(test::quick_gains(scenario), [&](const Observation& o) {
          std::vector<Obstacle> obstacles;
          for (const MovingObstacle& obstacle : scenario.obstacles) obstacles.push_back(obstacle.at(o.time));
          EXPECT_NEAR(o.clearance, obstacle_distance(robot.chain, *o.poses, obstacles), 1e-12);
          return true;
        });
    EXPECT_LT(result.metrics[Metric::kObstacleMinClearance],
              Rollout(test::scenario_of(name, 1.0), Stepper::kMidpoint)
                  .run(test::quick_gains(scenario))
                  .metrics[Metric::kObstacleMinClearance])
        << "links are nearer than joints";
  }
}

}  // namespace true_state_test
}  // namespace armtune::internal
