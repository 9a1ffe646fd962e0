#include "core/control/obstacle_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/core/support/arms.hpp"
#include "tests/core/support/obstacles.hpp"
#include "tests/core/support/worst_error.hpp"

namespace armtune::internal {
namespace obstacle_distance_test {

using test::distance_by_sampling;
using test::random_obstacles;
using test::with_links;
using test::WorstError;

TEST(ObstacleDistance, IsTheSmallestOfAllPairs) {
  std::mt19937 generator(512);
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < arm.n(); ++i) {
      for (const Obstacle& o : obstacles) {
        smallest = std::min(smallest, (poses.p_0B[static_cast<std::size_t>(i)] - o.center).norm() - o.radius);
      }
    }
    EXPECT_DOUBLE_EQ(obstacle_distance(arm.chain, poses, obstacles), smallest) << arm.name;
    EXPECT_EQ(obstacle_distance(arm.chain, poses, {}), std::numeric_limits<double>::infinity());
  }
}

TEST(ObstacleDistance, OfLinksIsThatOfTheirNearestPoints) {
  std::mt19937 generator(515);
  WorstError worst("distance", 1e-6);  // steps of up to 1e-4 m along a link, to second order at 1 cm and more
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const Chain thick = with_links(arm.chain, generator);
    const std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
    double smallest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < arm.n(); ++i) {
      for (const Obstacle& o : obstacles) {
        smallest =
            std::min(smallest, distance_by_sampling(poses, i, o.center) - o.radius - thick.link_radius[i]);
      }
    }
    worst.compare(obstacle_distance(thick, poses, obstacles), smallest, arm.name, 1.0);
    EXPECT_LE(obstacle_distance(thick, poses, obstacles), obstacle_distance(arm.chain, poses, obstacles))
        << "origins are points of links";
    EXPECT_EQ(obstacle_distance(thick, poses, {}), std::numeric_limits<double>::infinity());
  }
}

TEST(ObstacleDistance, OfALinkWithoutLengthIsThatOfItsOrigin) {
  RobotModel arm = test::ur10();
  const Poses poses = test::poses_at(arm.chain, JointVector::Constant(6, 0.5));
  Poses folded = poses;
  folded.p_0B[3] = folded.p_0B[2];
  const Vec3 p = folded.p_0B[2] + Vec3(0.1, 0.0, 0.0);
  EXPECT_EQ(nearest_on_link(folded, 2, p), folded.p_0B[2]);
}

TEST(Clearance, IsTheSmallestOverJointOriginsAndToolInTheBaseFrame) {
  std::mt19937 generator(517);
  int tool_is_nearest = 0;
  int joint_is_nearest = 0;
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < 20; ++sample) {
      const JointVector q = test::random_configuration(generator, arm);
      const Poses poses = test::poses_at(arm.chain, q);
      // The tool by a product of transforms of its own.
      Eigen::Isometry3d to_tool = Eigen::Isometry3d::Identity();
      std::vector<Vec3> points;
      for (int i = 0; i < arm.n(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        to_tool.translate(arm.chain.p_PB0[k]);
        to_tool.rotate(arm.chain.R_PB0[k]);
        if (arm.chain.motion[k] == JointMotion::kRevolute) {
          to_tool.rotate(Eigen::AngleAxisd(q[i], Vec3::UnitZ()));
        } else {
          to_tool.translate(q[i] * Vec3::UnitZ());
        }
        points.emplace_back(to_tool.translation());
      }
      points.emplace_back(to_tool * arm.chain.p_BT);
      std::vector<Obstacle> obstacles = random_obstacles(generator, poses);
      if (sample % 2 == 0) obstacles = {{points.back() + test::random_vec3(generator, 0.05), 0.02}};
      std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
      for (std::size_t p = 0; p < points.size(); ++p) {
        for (const Obstacle& o : obstacles) {
          nearest[p] = std::min(nearest[p], (points[p] - o.center).norm() - o.radius);
        }
      }
      const double of_joints = *std::min_element(nearest.begin(), nearest.end() - 1);
      // Rounding of some meters.
      EXPECT_NEAR(clearance(arm.chain, poses, obstacles), std::min(of_joints, nearest.back()), 1e-14)
          << arm.name;
      EXPECT_NEAR(obstacle_distance(arm.chain, poses, obstacles), of_joints, 1e-14) << arm.name;
      ++(nearest.back() < of_joints ? tool_is_nearest : joint_is_nearest);
    }
  }
  EXPECT_GT(tool_is_nearest, 20);
  EXPECT_GT(joint_is_nearest, 20);
}

TEST(Clearance, OfLinksIsWhatTheControllerActsOnAsTheLastLinkEndsAtTheTool) {
  std::mt19937 generator(518);
  for (const RobotModel& arm : test::all_arms()) {
    const Poses poses = test::poses_at(arm.chain, test::random_configuration(generator, arm));
    const Chain thick = with_links(arm.chain, generator);
    const std::vector<Obstacle> at_tool = {{poses.p_0T + test::random_vec3(generator, 0.01), 0.0}};
    EXPECT_EQ(clearance(thick, poses, at_tool), obstacle_distance(thick, poses, at_tool)) << arm.name;
    EXPECT_LE(clearance(thick, poses, at_tool),
              (poses.p_0T - at_tool[0].center).norm() - thick.link_radius[arm.n() - 1] + 1e-15)
        << arm.name;
  }
}

TEST(Clearance, IsInfiniteWithoutObstacles) {
  const RobotModel arm = test::ur10();
  const Poses poses = test::poses_at(arm.chain, JointVector::Constant(6, 0.5));
  EXPECT_EQ(clearance(arm.chain, poses, {}), std::numeric_limits<double>::infinity());
}

}  // namespace obstacle_distance_test
}  // namespace armtune::internal
