#include "core/trajectory/slerp.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/trajectory/quintic.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace slerp_test {

using test::derivative;
using test::WorstError;

struct Turn {
  Eigen::Quaterniond start;
  Vec3 phi;
  Quintic<double> s;
  OrientationPoint at(double t) const { return slerp(start, phi, s.at(t)); }
};

Turn random_turn(std::mt19937& generator) {
  const Eigen::Quaterniond start = test::random_orientation(generator);
  const Vec3 phi = test::random_vec3(generator, 1.5);
  return {start, phi, rest_to_rest(0.0, 1.0, test::random_number(generator, 0.5, 5.0))};
}

TEST(Slerp, BeginsAtTheStartAndEndsAtTheGoalBothAtRest) {
  std::mt19937 generator(441);
  WorstError worst("ends", 1e-12);  // rounding; the accelerations are sums of terms of 60 / T^2
  for (int sample = 0; sample < 30; ++sample) {
    const Turn turn = random_turn(generator);
    const OrientationPoint a = turn.at(0.0);
    const OrientationPoint b = turn.at(turn.s.duration());
    worst.compare(a.orientation.toRotationMatrix(), turn.start.toRotationMatrix(), "start");
    worst.compare(b.orientation.toRotationMatrix(),
                  Mat3((Eigen::AngleAxisd(turn.phi.norm(), turn.phi.normalized()) * turn.start).matrix()),
                  "goal");
    for (const OrientationPoint& end : {a, b}) {
      worst.add(end.angular_velocity.norm(), "angular velocity");
      worst.add(end.angular_acceleration.norm(), "angular acceleration");
    }
  }
}

TEST(Slerp, AngularVelocityAndAccelerationAreThoseOfTheOrientation) {
  std::mt19937 generator(442);
  WorstError velocity("angular velocity", 3e-9);           // at most 10 rad/s: 10^5 h^4 / 30 at h = 1e-3
  WorstError acceleration("angular acceleration", 1e-10);  // s' is of degree 4: rounding, 1e-15 / h
  for (int sample = 0; sample < 30; ++sample) {
    const Turn turn = random_turn(generator);
    const double t = turn.s.duration() * test::random_number(generator, 0.1, 0.9);
    const OrientationPoint at_t = turn.at(t);
    const auto R = [&](double h) { return Mat3(turn.at(t + h).orientation.toRotationMatrix()); };
    const Mat3 W = derivative(R) * R(0.0).transpose();
    const Vec3 w = 0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
    velocity.compare(at_t.angular_velocity, w, "random", 1.0);
    const auto rate = [&](double h) { return Vec3(turn.at(t + h).angular_velocity); };
    acceleration.compare(at_t.angular_acceleration, derivative(rate), "random", 1.0);
  }
}

TEST(Slerp, AgreesWithEigensOnTheShortWay) {
  std::mt19937 generator(443);
  WorstError worst("orientation", 1e-14);  // rounding
  for (int sample = 0; sample < 30; ++sample) {
    const Eigen::Quaterniond start = test::random_orientation(generator);
    const Eigen::Quaterniond goal = test::random_orientation(generator);
    const double s = test::random_number(generator, 0.0, 1.0);
    const OrientationPoint point = slerp(start, rotation_log(goal * start.conjugate()), {s, 0.0, 0.0});
    worst.compare(point.orientation.toRotationMatrix(), start.slerp(s, goal).toRotationMatrix(), "random");
  }
}

/// A goal that moves: phi(t) = phi + v t + a t^2 / 2, |phi| up to 2.6 rad.
struct MovingTurn {
  Turn turn;
  Vec3 v, a;
  MotionPoint<Vec3> phi(double t) const { return {turn.phi + t * (v + t * a / 2.0), v + t * a, a}; }
  OrientationPoint at(double t) const { return slerp(turn.start, phi(t), turn.s.at(t)); }
};

MovingTurn random_moving_turn(std::mt19937& generator) {
  const Turn turn = random_turn(generator);
  const Vec3 v = test::random_vec3(generator, 0.3);
  return {turn, v, test::random_vec3(generator, 0.3)};
}

TEST(SlerpToAMovingGoal, AngularVelocityAndAccelerationAreThoseOfTheOrientation) {
  std::mt19937 generator(444);
  // As above: at most 12 rad/s and a goal that moves beside it.
  WorstError velocity("angular velocity", 1e-8);
  WorstError acceleration("angular acceleration", 1e-8);
  for (int sample = 0; sample < 50; ++sample) {
    const MovingTurn turn = random_moving_turn(generator);
    const double t = turn.turn.s.duration() * test::random_number(generator, 0.1, 0.9);
    const OrientationPoint at_t = turn.at(t);
    const auto R = [&](double h) { return Mat3(turn.at(t + h).orientation.toRotationMatrix()); };
    const Mat3 W = derivative(R) * R(0.0).transpose();
    const Vec3 w = 0.5 * Vec3(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
    velocity.compare(at_t.angular_velocity, w, "random", 1.0);
    const auto rate = [&](double h) { return Vec3(turn.at(t + h).angular_velocity); };
    acceleration.compare(at_t.angular_acceleration, derivative(rate), "random", 1.0);
  }
}

TEST(SlerpToAMovingGoal, BeginsAtRestAndEndsInTheGoalsOwnTurning) {
  std::mt19937 generator(445);
  WorstError worst("ends", 1e-12);  // rounding
  for (int sample = 0; sample < 30; ++sample) {
    const MovingTurn turn = random_moving_turn(generator);
    const OrientationPoint a = turn.at(0.0);
    worst.compare(a.orientation.toRotationMatrix(), turn.turn.start.toRotationMatrix(), "start");
    worst.add(a.angular_velocity.norm(), "angular velocity");
    worst.add(a.angular_acceleration.norm(), "angular acceleration");
    const double T = turn.turn.s.duration();
    const OrientationPoint b = turn.at(T);
    const TurnRate goal = rotation_rate(turn.phi(T));
    worst.compare(b.orientation.toRotationMatrix(),
                  (rotation_exp(turn.phi(T).position) * turn.turn.start).toRotationMatrix(), "goal");
    worst.compare(b.angular_velocity, goal.velocity, "goal's angular velocity", 1.0);
    worst.compare(b.angular_acceleration, goal.acceleration, "goal's angular acceleration", 1.0);
  }
}

TEST(SlerpToAMovingGoal, IsThePlainOneWhileTheGoalStands) {
  std::mt19937 generator(446);
  WorstError worst("standing goal", 1e-13);  // rounding
  for (int sample = 0; sample < 30; ++sample) {
    const Turn turn = random_turn(generator);
    const MotionPoint<double> s = turn.s.at(turn.s.duration() * test::random_number(generator, 0.0, 1.0));
    const OrientationPoint plain = slerp(turn.start, turn.phi, s);
    const OrientationPoint moving = slerp(turn.start, {turn.phi, Vec3::Zero(), Vec3::Zero()}, s);
    EXPECT_EQ(moving.orientation.coeffs(), plain.orientation.coeffs());
    worst.compare(moving.angular_velocity, plain.angular_velocity, "velocity", 1.0);
    worst.compare(moving.angular_acceleration, plain.angular_acceleration, "acceleration", 1.0);
  }
}

}  // namespace slerp_test
}  // namespace armtune::internal
