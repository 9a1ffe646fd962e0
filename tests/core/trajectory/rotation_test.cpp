#include "core/trajectory/rotation.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace rotation_test {

using test::WorstError;

/// Angles from far below the series' limits to the turn's own, pi.
constexpr double kAngles[] = {1e-300, 1e-12, 1e-9, 9e-7, 1e-6, 2.1e-6, 9.9e-5,      1e-4,       1.01e-4,
                              1e-3,   0.1,   1.0,  2.0,  3.0,  3.1,    M_PI - 1e-4, M_PI - 1e-9};

Vec3 random_axis(std::mt19937& generator) {
  return (test::random_vec3(generator, 1.0) + Vec3(0.0, 0.0, 1e-3)).normalized();
}

TEST(RotationExp, IsTheTurnAboutTheAxisByTheAngle) {
  std::mt19937 generator(421);
  WorstError worst("exp", 1e-15);  // rounding
  for (const double angle : kAngles) {
    const Vec3 axis = random_axis(generator);
    const Eigen::Quaterniond expected(Eigen::AngleAxisd(angle, axis));
    worst.compare(rotation_exp(angle * axis).coeffs(), expected.coeffs(), std::to_string(angle));
  }
}

TEST(RotationLog, UndoesTheExponentialFromTinyTurnsToHalfTurns) {
  std::mt19937 generator(422);
  // Relative to the angle, however small: the logarithm's series below sin(angle/2) = 1e-6 has one term,
  // which is good to (1e-6)^2 / 3 = 3e-13.
  WorstError worst("log exp", 1e-12);
  for (const double angle : kAngles) {
    for (int sample = 0; sample < 10; ++sample) {
      const Vec3 phi = angle * random_axis(generator);
      worst.compare(rotation_log(rotation_exp(phi)), phi, std::to_string(angle));
    }
  }
}

TEST(RotationLog, IsUndoneByTheExponential) {
  std::mt19937 generator(423);
  WorstError worst("exp log", 1e-14);  // rounding
  for (int sample = 0; sample < 100; ++sample) {
    const Eigen::Quaterniond Q = test::random_orientation(generator);
    worst.compare(rotation_exp(rotation_log(Q)).toRotationMatrix(), Q.toRotationMatrix(), "random");
    EXPECT_LE(rotation_log(Q).norm(), M_PI * (1.0 + 1e-15));
  }
}

TEST(RotationLog, DoesNotDependOnTheSignOfTheQuaternion) {
  std::mt19937 generator(424);
  for (int sample = 0; sample < 100; ++sample) {
    const Eigen::Quaterniond Q = test::random_orientation(generator);
    const Eigen::Quaterniond minus_Q(-Q.w(), -Q.x(), -Q.y(), -Q.z());
    EXPECT_EQ(rotation_log(Q), rotation_log(minus_Q));
  }
}

TEST(RotationLog, OfNoTurnIsZeroAndOfAHalfTurnIsPiLong) {
  EXPECT_EQ(rotation_log(Eigen::Quaterniond::Identity()), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(rotation_exp(Vec3::Zero()).coeffs(), Eigen::Quaterniond::Identity().coeffs());
  EXPECT_NEAR(rotation_log(Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0)).y(), M_PI, 1e-15);
}

TEST(RotationVector, TheNearestTurnsAsTheShortestDoes) {
  std::mt19937 generator(715);
  for (int sample = 0; sample < 50; ++sample) {
    const Vec3 axis = test::random_vec3(generator, 1.0).normalized();
    const double angle = test::random_number(generator, -9.0, 9.0);
    const Vec3 near = (angle + test::random_number(generator, -1.0, 1.0)) * axis;
    const Vec3 shortest = rotation_log(rotation_exp(angle * axis));
    EXPECT_LT((nearest_rotation_vector(shortest, near) - angle * axis).norm(), 1e-9) << angle;
  }
  EXPECT_LT((nearest_rotation_vector(Vec3::Zero(), Vec3(0.0, 0.0, 6.0)) - Vec3(0.0, 0.0, 2.0 * M_PI)).norm(),
            1e-12);
  EXPECT_TRUE(nearest_rotation_vector(Vec3::Zero(), Vec3::Zero()).isZero(0.0));
}

}  // namespace rotation_test
}  // namespace armtune::internal
