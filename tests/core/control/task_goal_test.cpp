#include "core/control/task_goal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "core/trajectory/path.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace task_goal_test {

using test::derivative;
using test::WorstError;

/// Of the moving inverse kinematics: a period, and how long leaveSingularity lasts.
constexpr double kPeriod = 0.002;
constexpr double kDuration = 6.0;

/// A circle beside the goal and a target that wanders.
struct Task {
  test::Rig rig;
  Path path, target;

  Task() {
    path = {rig.path.center + Vec3(0.02, 0.08, -0.05), 0.6, 0.0, {{1, Vec3(0, -0.1, 0), Vec3(-0.1, 0, 0)}}};
    target = {rig.p_0G + Vec3(0.1, -0.05, 0), 0.7, 0.3, {{1, Vec3(0.05, 0, 0), Vec3(0, -0.06, 0)}}};
  }
  MotionPoint<JointVector> step(TaskGoal& goal, double time) const {
    return goal.step(rig.model->chain, path.at(time), {target.at(time)}, inverse_damping(rig.gains),
                     TaskMask::kPose, {}, kPeriod);
  }
};

TEST(TaskGoal, BeginsWhereItIsTold) {
  const Task task;
  TaskGoal goal;
  goal.start(task.rig.goal().q);
  EXPECT_EQ(task.step(goal, 0.0).position, task.rig.goal().q);
  EXPECT_NE(task.step(goal, kPeriod).position, task.rig.goal().q);
  goal.start(task.rig.goal().q);
  EXPECT_EQ(task.step(goal, 1.0).position, task.rig.goal().q);
}

TEST(TaskGoal, IsOnThePathAndInTheGazeInTheirMotionWhenLeaveSingularityEnds) {
  const Task task;
  const Chain& chain = task.rig.model->chain;
  TaskGoal goal;
  goal.start(task.rig.goal().q);
  // What is left of 0.1 m and 0.2 rad after 6 s is e^-18 of them. A step of h leaves its error of third
  // order, h^3 / 6 of q''' of some 0.1 rad/s^3, which the feedback of 3/s holds at h^2 / 18 of it: 2e-8.
  WorstError position("path [m]", 3e-8);
  WorstError angle("gaze [rad]", 3e-8);
  WorstError velocity("velocity of the path [m/s]", 1e-7);
  WorstError turning("turning of the line [rad/s]", 1e-7);
  // Of q'' the gaze's feedback has w - wd where the error's own rate belongs: equal once the error is gone.
  WorstError acceleration("acceleration of the path [m/s^2]", 3e-7);
  WorstError roll("roll [rad/s]", 1e-7);
  double first_distance = 0.0;
  double first_angle = 0.0;
  for (int k = 0; k * kPeriod < kDuration + 4.0; ++k) {
    const double time = k * kPeriod;
    const MotionPoint<JointVector> m = task.step(goal, time);
    const MotionPoint<Vec3> path = task.path.at(time);
    const MotionPoint<Vec3> target = task.target.at(time);
    const Poses poses = test::poses_at(chain, m.position);
    if (k == 0) {
      first_distance = (poses.p_0T - path.position).norm();
      first_angle = gaze_angle(poses.R_0T, poses.p_0T, target.position);
    }
    if (time < kDuration) continue;
    const Jacobian J = test::tool_jacobian_at(chain, m.position);
    Jacobian J_dot;
    tool_jacobian_derivative(chain, poses, J, m.velocity, J_dot);
    const Vec6 twist = J * m.velocity;
    const Vec6 accel = J * m.acceleration + J_dot * m.velocity;
    const Vec3 z = poses.R_0T.col(2);
    position.add((poses.p_0T - path.position).norm(), "after 6 s");
    angle.add(gaze_angle(poses.R_0T, poses.p_0T, target.position), "after 6 s");
    velocity.add((twist.head<3>() - path.velocity).norm(), "after 6 s");
    const auto line = [&](double h) {
      return Vec3((task.target.at(time + h).position - task.path.at(time + h).position).normalized());
    };
    turning.add((twist.tail<3>().cross(z) - derivative(line)).norm(), "after 6 s");
    roll.add(std::abs(twist.tail<3>().dot(z)), "after 6 s");
    acceleration.add((accel.head<3>() - path.acceleration).norm(), "after 6 s");
  }
  EXPECT_GT(first_distance, 0.05) << "there was a way to go";
  EXPECT_GT(first_angle, 0.1);
}

TEST(TaskGoal, VelocityAndAccelerationAreTheDerivativesOfThePosition) {
  const Task task;
  TaskGoal goal;
  goal.start(task.rig.goal().q);
  // Once on the path: before that the gaze's error rate is an approximation. Five points of the period's
  // width: h^4 / 30 of derivatives of some 0.1 rad/s^5, and 1e-16 / h of rounding; the steps' error of third
  // order is a part of the motion here.
  WorstError velocity("q'", 1e-7);
  WorstError acceleration("q''", 1e-6);
  std::array<MotionPoint<JointVector>, 5> last;
  for (int k = 0; k < 4000; ++k) {
    for (std::size_t i = 0; i < 4; ++i) last[i] = last[i + 1];
    last[4] = task.step(goal, k * kPeriod);
    if (k * kPeriod < kDuration) continue;
    const auto slope = [&](JointVector MotionPoint<JointVector>::*part) {
      const auto at = [&](double t) {
        return last[static_cast<std::size_t>(2 + std::lround(t / kPeriod))].*part;
      };
      return derivative(at, kPeriod);
    };
    velocity.add((last[2].velocity - slope(&MotionPoint<JointVector>::position)).norm(), "after 6 s");
    acceleration.add((last[2].acceleration - slope(&MotionPoint<JointVector>::velocity)).norm(), "after 6 s");
  }
}

TEST(TaskGoal, FollowsAPathOrATargetThatGoesElsewhere) {
  const Task task;
  const Chain& chain = task.rig.model->chain;
  for (const bool path_moves : {true, false}) {
    Task moved = task;
    (path_moves ? moved.path : moved.target).center += Vec3(0.05, 0.04, 0.03);
    TaskGoal here;
    TaskGoal there;
    here.start(task.rig.goal().q);
    there.start(task.rig.goal().q);
    JointVector a;
    JointVector b;
    double time = 0.0;
    for (int k = 0; k * kPeriod < kDuration; ++k) {
      time = k * kPeriod;
      a = task.step(here, time).position;
      b = moved.step(there, time).position;
    }
    const Poses at_a = test::poses_at(chain, a);
    const Poses at_b = test::poses_at(chain, b);
    const Vec3 shift = path_moves ? Vec3(0.05, 0.04, 0.03) : Vec3(0.0, 0.0, 0.0);
    EXPECT_LT((at_b.p_0T - at_a.p_0T - shift).norm(), 1e-7) << path_moves;
    EXPECT_GT(gaze_angle(at_b.R_0T, at_b.p_0T, task.target.at(time).position), path_moves ? -1.0 : 0.02);
    EXPECT_LT(gaze_angle(at_b.R_0T, at_b.p_0T, moved.target.at(time).position), 1e-7) << path_moves;
  }
}

TEST(Towards, VelocityAndAccelerationAreTheDerivativesOfThePosition) {
  std::mt19937 generator(741);
  WorstError velocity("velocity", 1e-11);  // a polynomial of degree 7 over 2 s: h^4 / 30 and rounding
  WorstError acceleration("acceleration", 1e-10);
  for (int sample = 0; sample < 30; ++sample) {
    const JointVector start = test::random_vector(generator, 6, 2.0);
    const JointVector q = test::random_vector(generator, 6, 2.0);
    const JointVector qd = test::random_vector(generator, 6, 1.0);
    const JointVector qdd = test::random_vector(generator, 6, 1.0);
    const Quintic<double> s = rest_to_rest(0.0, 1.0, 2.0);
    const double t = test::random_number(generator, 0.1, 1.9);
    const auto at = [&](double h) {
      const MotionPoint<JointVector> goal{q + h * (qd + h * qdd / 2.0), qd + h * qdd, qdd};
      return towards(start, goal, s.at(t + h));
    };
    const auto position = [&](double h) { return JointVector(at(h).position); };
    const auto rate = [&](double h) { return JointVector(at(h).velocity); };
    velocity.compare(at(0.0).velocity, derivative(position), "random", 1.0);
    acceleration.compare(at(0.0).acceleration, derivative(rate), "random", 1.0);
  }
}

TEST(Towards, StartsAtTheStartAtRestAndEndsInTheGoalsMotion) {
  std::mt19937 generator(742);
  const JointVector start = test::random_vector(generator, 6, 2.0);
  const MotionPoint<JointVector> goal{test::random_vector(generator, 6, 2.0),
                                      test::random_vector(generator, 6, 1.0),
                                      test::random_vector(generator, 6, 1.0)};
  const MotionPoint<JointVector> a = towards(start, goal, {0.0, 0.0, 0.0});
  EXPECT_EQ(a.position, start);
  EXPECT_TRUE(a.velocity.isZero(0.0));
  EXPECT_TRUE(a.acceleration.isZero(0.0));
  const MotionPoint<JointVector> b = towards(start, goal, {1.0, 0.0, 0.0});
  EXPECT_LT((b.position - goal.position).norm(), 1e-15);  // rounding of start + (goal - start)
  EXPECT_EQ(b.velocity, goal.velocity);
  EXPECT_EQ(b.acceleration, goal.acceleration);
}

TEST(Towards, OfAStandingGoalIsTheJointTrajectory) {
  std::mt19937 generator(743);
  const JointVector start = test::random_vector(generator, 6, 2.0);
  const JointVector end = test::random_vector(generator, 6, 2.0);
  const MotionPoint<JointVector> goal{end, JointVector::Zero(6), JointVector::Zero(6)};
  for (const double t : {0.0, 0.4, 1.3, 2.0}) {
    const MotionPoint<JointVector> expected = joint_trajectory(start, end, 2.0, t);
    const MotionPoint<JointVector> m = towards(start, goal, rest_to_rest(0.0, 1.0, 2.0).at(t));
    EXPECT_EQ(m.position, expected.position);
    EXPECT_EQ(m.velocity, expected.velocity);
    EXPECT_EQ(m.acceleration, expected.acceleration);
  }
}

}  // namespace task_goal_test
}  // namespace armtune::internal
