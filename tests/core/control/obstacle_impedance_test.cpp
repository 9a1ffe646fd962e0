#include "core/control/obstacle_impedance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune {
namespace {

using test::derivative;
using test::random_vec3;
using test::WorstError;

constexpr double kRadius = 0.325;

/// Centres around some joint origins of the arm at q, so that several joints feel several obstacles.
std::vector<Vec3> random_centers(std::mt19937& generator, const Poses& poses) {
  std::vector<Vec3> centers;
  for (int i = 0; i < poses.n; i += 2) {
    centers.push_back(poses.p_0B[static_cast<std::size_t>(i)] + random_vec3(generator, 0.15));
  }
  return centers;
}

JointVector torque(const Chain& chain, const Poses& poses, const std::vector<Vec3>& centers,
                   const JointVector& force_gains) {
  JointVector tau;
  obstacle_torque(chain, poses, centers, kRadius, force_gains, tau);
  return tau;
}

TEST(Repulsion, PushesAwayFromTheObstacleWithTheSquareOfTheDepth) {
  std::mt19937 generator(511);
  WorstError worst("force", 1e-14);  // rounding
  for (int sample = 0; sample < 50; ++sample) {
    const Vec3 direction = random_vec3(generator, 1.0).normalized();
    const double distance = test::random_number(generator, 0.001, 0.999) * kRadius;
    const Vec3 force = repulsion(distance * direction, kRadius);
    EXPECT_GT(force.dot(direction), 0.0);
    worst.compare(force, Vec3(std::pow(1.0 - distance / kRadius, 2) * direction), "random", 1e-3);
  }
}

TEST(Repulsion, IsZeroAtTheRadiusAndBeyond) {
  EXPECT_EQ(repulsion(kRadius * Vec3::UnitY(), kRadius), Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(repulsion(3.0 * kRadius * Vec3::UnitY(), kRadius), Vec3(0.0, 0.0, 0.0));
  EXPECT_GT(repulsion(0.999 * kRadius * Vec3::UnitY(), kRadius).y(), 0.0);
}

TEST(Repulsion, IsOneLongAndFiniteAtTheCentre) {
  EXPECT_EQ(repulsion(Vec3::Zero(), kRadius).norm(), 1.0);
  EXPECT_NEAR(repulsion(Vec3(1e-12, 0.0, 0.0), kRadius).x(), 1.0, 1e-11);
}

TEST(ObstacleDistance, IsTheSmallestOfAllPairs) {
  std::mt19937 generator(512);
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Vec3> centers = random_centers(generator, poses);
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < arm.n(); ++i) {
      for (const Vec3& c : centers) {
        smallest = std::min(smallest, (poses.p_0B[static_cast<std::size_t>(i)] - c).norm());
      }
    }
    EXPECT_DOUBLE_EQ(obstacle_distance(poses, centers), smallest) << arm.name;
    EXPECT_EQ(obstacle_distance(poses, {}), std::numeric_limits<double>::infinity());
  }
}

TEST(ObstacleTorque, IsTheVirtualPowerOfTheForcesOnTheJointOriginsForTheFirstThreeJoints) {
  std::mt19937 generator(513);
  WorstError worst("torque", 1e-9);  // Jacobians by finite differences of the origins
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses poses = test::poses_at(arm.chain, q);
      const std::vector<Vec3> centers = random_centers(generator, poses);
      const JointVector gains = test::random_vector(generator, arm.n(), 100.0).cwiseAbs();
      JointVector expected = JointVector::Zero(arm.n());
      for (std::size_t k = 0; k < static_cast<std::size_t>(arm.n()); ++k) {
        Vec3 force = Vec3::Zero();
        for (const Vec3& c : centers) {
          const Vec3 d = poses.p_0B[k] - c;
          if (d.norm() < kRadius) force += std::pow(1.0 - d.norm() / kRadius, 2) * d.normalized();
        }
        for (int j = 0; j < std::min(3, arm.n()); ++j) {
          const Vec3 column = derivative([&](double t) {
            JointVector moved = q;
            moved[j] += t;
            return Vec3(test::poses_at(arm.chain, moved).p_0B[k]);
          });
          expected[j] += gains[static_cast<Eigen::Index>(k)] * column.dot(force);
        }
      }
      const JointVector tau = torque(arm.chain, poses, centers, gains);
      worst.compare(tau, expected, arm.name, 1.0);
      EXPECT_GT(tau.head(std::min(3, arm.n())).norm(), 0.0) << arm.name;
      EXPECT_TRUE(tau.tail(std::max(0, arm.n() - 3)).isZero(0.0)) << arm.name;
    }
  }
}

TEST(ObstacleTorque, OfSeveralObstaclesIsTheSum) {
  std::mt19937 generator(514);
  WorstError worst("sum", 1e-13);  // rounding
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Vec3> centers = random_centers(generator, poses);
    const JointVector gains = JointVector::Constant(arm.n(), 100.0);
    JointVector sum = JointVector::Zero(arm.n());
    for (const Vec3& c : centers) sum += torque(arm.chain, poses, {c}, gains);
    worst.compare(torque(arm.chain, poses, centers, gains), sum, arm.name, 1.0);
  }
}

TEST(ObstacleTorque, IsZeroWithoutAnObstacleInReach) {
  const RobotModel arm = test::ur10();
  const Poses poses = test::poses_at(arm.chain, JointVector::Constant(6, 0.5));
  const JointVector gains = JointVector::Constant(6, 100.0);
  EXPECT_TRUE(torque(arm.chain, poses, {}, gains).isZero(0.0));
  EXPECT_TRUE(torque(arm.chain, poses, {Vec3(9.0, 9.0, 9.0)}, gains).isZero(0.0));
}

}  // namespace
}  // namespace armtune
