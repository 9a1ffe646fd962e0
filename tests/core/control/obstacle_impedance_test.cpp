#include "core/control/obstacle_impedance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "core/control/obstacle_distance.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/obstacles.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace obstacle_impedance_test {

using test::derivative;
using test::random_obstacles;
using test::random_vec3;
using test::with_links;
using test::WorstError;

constexpr double kRadius = 0.325;

JointVector torque(const Chain& chain, const Poses& poses, const std::vector<Obstacle>& obstacles,
                   const ForceGains& force_gains) {
  JointVector tau;
  obstacle_torque(chain, poses, obstacles, kRadius, force_gains, tau);
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

TEST(Repulsion, CountsFromTheSurfaceAndIsWholeInside) {
  const double inside = 0.1;
  const auto push = [&](double from_centre) {
    return repulsion(from_centre * Vec3::UnitX(), kRadius, inside).x();
  };
  EXPECT_EQ(push(inside + kRadius), 0.0);
  EXPECT_NEAR(push(inside + 0.5 * kRadius), 0.25, 1e-14);
  for (const double depth : {1.0, 0.5, 1e-9}) EXPECT_NEAR(push(depth * inside), 1.0, 1e-8) << depth;
}

TEST(ObstacleTorque, IsTheVirtualPowerOfTheForcesOnTheJointOriginsForTheFirstThreeJoints) {
  std::mt19937 generator(513);
  WorstError worst("torque", 1e-9);  // Jacobians by finite differences of the origins
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < 10; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses poses = test::poses_at(arm.chain, q);
      const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
      const JointVector gains = test::random_vector(generator, arm.n(), 100.0).cwiseAbs();
      JointVector expected = JointVector::Zero(arm.n());
      for (std::size_t k = 0; k < static_cast<std::size_t>(arm.n()); ++k) {
        Vec3 force = Vec3::Zero();
        for (const Obstacle& o : obstacles) {
          const Vec3 d = poses.p_0B[k] - o.center;
          const double distance = std::max(0.0, d.norm() - o.radius);
          if (distance < kRadius) force += std::pow(1.0 - distance / kRadius, 2) * d.normalized();
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
      const JointVector tau = torque(arm.chain, poses, obstacles, gains);
      worst.compare(tau, expected, arm.name, 1.0);
      EXPECT_GT(tau.head(std::min(3, arm.n())).norm(), 0.0) << arm.name;
      EXPECT_TRUE(tau.tail(std::max(0, arm.n() - 3)).isZero(0.0)) << arm.name;
    }
  }
}

// The force is the slope of k r_o / 3 (1 - s / r_o)^3 over the surface's distance s; the point of a link that
// is nearest is so to first order however it moves.
TEST(ObstacleTorque, LowersAPotentialOfTheLinksDistanceByTheFirstThreeJoints) {
  std::mt19937 generator(516);
  WorstError worst("torque", 1e-7);  // central differences
  for (const RobotModel& arm : test::all_arms()) {
    const Chain thick = with_links(arm.chain, generator);
    const JointVector q = test::random_configuration(generator, arm);
    const Poses poses = test::poses_at(arm.chain, q);
    // Away from where a link's end becomes its nearest point, or its surface is met.
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    const JointVector gains = test::random_vector(generator, arm.n(), 100.0).cwiseAbs();
    const auto potential = [&](const JointVector& at) {
      const Poses moved = test::poses_at(arm.chain, at);
      double sum = 0.0;
      for (int i = 0; i < arm.n(); ++i) {
        for (const Obstacle& o : obstacles) {
          const double s =
              (nearest_on_link(moved, i, o.center) - o.center).norm() - o.radius - thick.link_radius[i];
          EXPECT_GT(s, 0.0);
          if (s < kRadius) sum += gains[i] * kRadius / 3.0 * std::pow(1.0 - s / kRadius, 3);
        }
      }
      return sum;
    };
    JointVector expected = JointVector::Zero(arm.n());
    for (int j = 0; j < std::min(3, arm.n()); ++j) {
      expected[j] = -derivative([&](double t) {
        JointVector moved = q;
        moved[j] += t;
        return potential(moved);
      });
    }
    const JointVector tau = torque(thick, poses, obstacles, gains);
    worst.compare(tau, expected, arm.name, 1.0);
    EXPECT_GT(tau.norm(), 0.0) << arm.name;
  }
}

TEST(ObstacleTorque, OfSeveralObstaclesIsTheSum) {
  std::mt19937 generator(514);
  WorstError worst("sum", 1e-13);  // rounding
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    const JointVector gains = JointVector::Constant(arm.n(), 100.0);
    for (const Chain& chain : {arm.chain, with_links(arm.chain, generator)}) {
      JointVector sum = JointVector::Zero(arm.n());
      for (const Obstacle& o : obstacles) sum += torque(chain, poses, {o}, gains);
      worst.compare(torque(chain, poses, obstacles, gains), sum, arm.name, 1.0);
    }
  }
}

// Equation 9: k_f,i multiplies the torques of force point i joint by joint.
TEST(ObstacleTorque, ListsOfEqualGainsHaveTheBitsOfOneNumberPerForcePoint) {
  std::mt19937 generator(517);
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    const JointVector gains = test::random_vector(generator, arm.n(), 100.0).cwiseAbs();
    ForceGains lists(arm.n() * arm.n());
    for (int i = 0; i < arm.n(); ++i) lists.segment(i * arm.n(), arm.n()).setConstant(gains[i]);
    for (const Chain& chain : {arm.chain, with_links(arm.chain, generator)}) {
      const JointVector tau = torque(chain, poses, obstacles, gains);
      EXPECT_GT(tau.norm(), 0.0) << arm.name;
      EXPECT_EQ(torque(chain, poses, obstacles, lists), tau) << arm.name;
    }
  }
}

TEST(ObstacleTorque, AGainOfOneForcePointAndJointActsOnThatJointAloneWithThatPointsTorque) {
  std::mt19937 generator(518);
  for (const RobotModel& arm : test::all_arms()) {
    const int n = arm.n();
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    int acting = 0;
    for (const Chain& chain : {arm.chain, with_links(arm.chain, generator)}) {
      for (int point = 0; point < n; ++point) {
        JointVector one = JointVector::Zero(n);
        one[point] = 37.0;
        const JointVector of_point = torque(chain, poses, obstacles, one);
        for (int joint = 0; joint < n; ++joint) {
          ForceGains single = ForceGains::Zero(n * n);
          single[point * n + joint] = 37.0;
          JointVector expected = JointVector::Zero(n);
          expected[joint] = of_point[joint];
          EXPECT_EQ(torque(chain, poses, obstacles, single), expected) << arm.name << point << joint;
          acting += expected[joint] != 0.0 ? 1 : 0;
        }
      }
    }
    EXPECT_GT(acting, 0) << arm.name;
  }
}

TEST(ObstacleTorque, IsZeroWithoutAnObstacleInReach) {
  const RobotModel arm = test::ur10();
  const Poses poses = test::poses_at(arm.chain, JointVector::Constant(6, 0.5));
  const JointVector gains = JointVector::Constant(6, 100.0);
  EXPECT_TRUE(torque(arm.chain, poses, {}, gains).isZero(0.0));
  EXPECT_TRUE(torque(arm.chain, poses, {{Vec3(9.0, 9.0, 9.0)}}, gains).isZero(0.0));
}

}  // namespace obstacle_impedance_test
}  // namespace armtune::internal
