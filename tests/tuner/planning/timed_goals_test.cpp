#include "tuner/planning/session/timed_goals.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/trajectory/linear_acceleration.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace timed_goals_test {

using testing::AllOf;
using testing::HasSubstr;

JointVector ur5e_at(double pan, double lift, double elbow) {
  JointVector q(6);
  q << pan, lift, elbow, -1.2, -1.57, 0.0;
  return q;
}

JointGoals goals_of(std::shared_ptr<const RobotModel> robot, std::vector<JointVector> positions) {
  auto clearance = std::make_shared<const ClearanceModel>(robot, Cell{});
  return {"goals.csv", std::move(robot), std::move(clearance), std::move(positions)};
}

TimedGoals timed(const JointGoals& goals) {
  const std::atomic<bool> never{false};
  return time_goals(goals, never).value();
}

/// The largest share of each limit that a motion uses at its knots, and of jerk between them.
struct Use {
  double velocity = 0.0, acceleration = 0.0, jerk = 0.0, effort = 0.0;
};

Use use_of(const JointSpline& motion, const RobotModel& robot, const JointVector& acceleration) {
  Use use;
  for (std::size_t k = 0; k < motion.knots().size(); ++k) {
    const MotionPoint<JointVector>& knot = motion.knots()[k];
    const auto ratio = [](const JointVector& a, const JointVector& b) {
      return a.cwiseAbs().cwiseQuotient(b).maxCoeff();
    };
    use.velocity = std::max(use.velocity, ratio(knot.velocity, robot.velocity_limits()));
    use.acceleration = std::max(use.acceleration, ratio(knot.acceleration, acceleration));
    use.effort = std::max(use.effort, ratio(test::inverse_dynamics_at(robot.chain, knot.position,
                                                                      knot.velocity, knot.acceleration),
                                            robot.effort_limits()));
    if (k == 0) continue;
    const MotionPoint<JointVector>& before = motion.knots()[k - 1];
    const double h = motion.time()[k] - motion.time()[k - 1];
    use.jerk = std::max(use.jerk, ratio((knot.acceleration - before.acceleration) / h, acceleration / 0.1));
    const MotionPoint<JointVector> reached = linear_acceleration(before, knot.acceleration, h, h);
    EXPECT_LT((reached.position - knot.position).lpNorm<Eigen::Infinity>(), 1e-7) << "at knot " << k;
    EXPECT_LT((reached.velocity - knot.velocity).lpNorm<Eigen::Infinity>(), 1e-6) << "at knot " << k;
  }
  return use;
}

TEST(TimedGoals, AreReachedInTurnAtRestAndInsideTheLimits) {
  const auto robot = load_robot("ur5e");
  const std::vector<JointVector> positions = {ur5e_at(0.0, -1.5, 1.2), ur5e_at(1.5, -1.0, 1.5),
                                              ur5e_at(-0.5, -1.2, 0.9)};
  const TimedGoals both = timed(goals_of(robot, positions));
  const JointSpline& motion = both.motion;
  EXPECT_EQ(motion.begin(), 0.0);
  std::size_t reached = 0;
  double rest = 0.0;
  for (std::size_t k = 0; k + 1 < motion.knots().size(); ++k) {
    if (!motion.knots()[k].velocity.isZero(0.0) || !motion.knots()[k + 1].velocity.isZero(0.0)) continue;
    EXPECT_EQ(motion.knots()[k].position, positions.at(++reached));
    EXPECT_TRUE(motion.knots()[k].acceleration.isZero(0.0));
    rest += motion.time()[k + 1] - motion.time()[k];
  }
  EXPECT_EQ(reached, 2U);
  EXPECT_NEAR(rest, 1.0, 1e-12);
  const JointVector acceleration = 0.8 / 0.5 * robot->velocity_limits();
  const Use use = use_of(motion, *robot, acceleration);
  for (const double share : {use.velocity / 0.8, use.effort / 0.8, use.acceleration, use.jerk})
    EXPECT_LT(share, 1.0 + 1e-6);
  // In the least time: a limit is used up.
  EXPECT_GT(std::max(use.velocity / 0.8, use.acceleration), 1.0 - 1e-3);
  EXPECT_GT(use.jerk, 1.0 - 1e-3);

  // The message is the same motion, but for its times in nanoseconds.
  const test::TemporaryFolder folder;
  const JointSpline sent = load_planned_motion({{folder.write("sent.yaml", both.message)}}, *robot);
  ASSERT_EQ(sent.time().size(), motion.time().size());
  for (std::size_t k = 0; k < sent.time().size(); ++k) {
    EXPECT_NEAR(sent.time()[k], motion.time()[k], 1e-9);
    EXPECT_EQ(sent.knots()[k].position, motion.knots()[k].position);
    EXPECT_EQ(sent.knots()[k].velocity, motion.knots()[k].velocity);
    EXPECT_EQ(sent.knots()[k].acceleration, motion.knots()[k].acceleration);
  }
}

TEST(TimedGoals, KeepTheRobotsAccelerationLimits) {
  RobotModel slow = *load_robot("ur5e");
  for (JointInfo& joint : slow.joints) joint.limits.acceleration = 0.5;
  const auto robot = std::make_shared<const RobotModel>(slow);
  const JointSpline motion =
      timed(goals_of(robot, {ur5e_at(0.0, -1.5, 1.2), ur5e_at(1.5, -1.0, 1.5)})).motion;
  const Use use = use_of(motion, *robot, JointVector::Constant(6, 0.4));  // 80 % of the limit
  EXPECT_LT(use.acceleration, 1.0 + 1e-6);
  EXPECT_GT(use.acceleration, 1.0 - 1e-3);
  EXPECT_LT(use.jerk, 1.0 + 1e-6);
  // 1.5 rad at 0.4 rad/s^2 without jerk limits would take 2 sqrt(1.5 / 0.4) s; a ramp of 0.1 s adds 0.1 s.
  EXPECT_NEAR(motion.end() - 0.5, 2.0 * std::sqrt(1.5 / 0.4) + 0.1, 0.02);
}

TEST(TimedGoals, AGoalTwiceInTurnIsARest) {
  const JointVector there = ur5e_at(0.0, -1.5, 1.2);
  const JointSpline motion = timed(goals_of(load_robot("ur5e"), {there, there, there})).motion;
  EXPECT_EQ(motion.time(), (std::vector{0.0, 0.5, 1.0}));
  EXPECT_EQ(motion.at(0.7).position, there);
}

TEST(TimedGoals, ThatTouchTheArmOrNeedTooMuchTorqueAreRefused) {
  const auto robot = load_robot("ur5e");
  const JointVector fine = ur5e_at(0.0, -1.5, 1.2);
  const auto refused = [&](const JointGoals& goals) { return test::refusal([&] { timed(goals); }); };
  // Folded until the wrist is in the upper arm.
  for (const bool first : {true, false}) {
    const JointVector folded = ur5e_at(0.0, -1.5, 3.1);
    EXPECT_THAT(refused(first ? goals_of(robot, {folded, fine}) : goals_of(robot, {fine, folded})),
                AllOf(HasSubstr("goals.csv"), HasSubstr(first ? "goal 1: " : "goal 2: "),
                      HasSubstr("distance between links"), HasSubstr("farther away")));
  }
  RobotModel weak = *robot;
  weak.joints[1].limits.effort = 20.0;
  EXPECT_THAT(refused(goals_of(std::make_shared<const RobotModel>(weak),
                               {ur5e_at(0.0, -std::numbers::pi / 2.0, 0.0), ur5e_at(0.0, 0.0, 0.0)})),
              AllOf(HasSubstr("goal 2: torque of shoulder_lift_joint"), HasSubstr("is -16;")));
}

TEST(TimedGoals, BesideAMovingPartAreRefused) {
  JointGoals goals = goals_of(load_robot("ur5e"), {ur5e_at(0.0, -1.5, 1.2), ur5e_at(1.5, -1.0, 1.5)});
  Cell cell;
  cell.parts.push_back({"carrier", sphere(0.1), Mat3::Identity(), Path{}});
  cell.parts[0].path.center = Vec3(2.0, 0.0, 0.0);
  goals.clearance = std::make_shared<const ClearanceModel>(goals.robot, cell);
  EXPECT_NO_THROW(timed(goals));
  cell.parts[0].path.terms = {{1, Vec3(0.1, 0.0, 0.0), Vec3::Zero()}};
  cell.parts[0].path.frequency = 1.0;
  goals.clearance = std::make_shared<const ClearanceModel>(goals.robot, cell);
  EXPECT_THAT(test::refusal([&] { timed(goals); }), AllOf(HasSubstr("carrier"), HasSubstr("times")));
}

TEST(TimedGoals, TellHowFarTheyAreAndEndWhereTheyAreStopped) {
  const JointGoals goals = goals_of(
      load_robot("ur5e"), {ur5e_at(0.0, -1.5, 1.2), ur5e_at(0.3, -1.5, 1.2), ur5e_at(0.6, -1.5, 1.2)});
  std::vector<std::size_t> seen;
  std::atomic<bool> stop{false};
  EXPECT_TRUE(time_goals(goals, stop, [&](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 2U);
    seen.push_back(done);
  }));
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(time_goals(goals, stop, [&](std::size_t done, std::size_t) { stop = done == 1; }));
}

}  // namespace timed_goals_test
}  // namespace armtune::internal
