// Where a first task is, measured by a chain of transforms that shares nothing with the search for its place.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <vector>

#include "sim/scenario/data_files.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/scenario/robot_file.hpp"

namespace armtune::internal {
namespace first_task_place_test {

constexpr double kGravity = 9.81;

/// Frames of all bodies in the base frame, the tool's last. The joints turn about z or slide along it.
std::vector<Eigen::Isometry3d> frames_at(const RobotModel& arm, const JointVector& q) {
  std::vector<Eigen::Isometry3d> frames;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (int i = 0; i < arm.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    Eigen::Isometry3d joint = Eigen::Isometry3d::Identity();
    joint.translate(arm.chain.p_PB0[k]).rotate(arm.chain.R_PB0[k]);
    if (arm.chain.motion[k] == JointMotion::kPrismatic) {
      joint.translate(Vec3(0.0, 0.0, q[i]));
    } else {
      joint.rotate(Eigen::AngleAxisd(q[i], Vec3::UnitZ()));
    }
    frame = frame * joint;
    frames.push_back(frame);
  }
  Eigen::Isometry3d tool = Eigen::Isometry3d::Identity();
  tool.translate(arm.chain.p_BT).rotate(arm.chain.R_BT);
  frames.push_back(frame * tool);
  return frames;
}

/// Potential energy of the links of an upright arm, and of a payload at its tool [J].
double energy(const RobotModel& arm, const Payload& payload, const JointVector& q) {
  const std::vector<Eigen::Isometry3d> frames = frames_at(arm, q);
  double sum = payload.mass * (frames.back() * payload.center).z();
  for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
    const LinkInertia& link = arm.chain.link[k];
    sum += link.mass * (frames[k] * Vec3(link.first_moment / link.mass)).z();
  }
  return kGravity * sum;
}

/// The largest slope of the potential energy along a joint, as a share of the joint's effort limit.
double load_at(const RobotModel& arm, const Payload& payload, const JointVector& q) {
  constexpr double kStep = 1e-5;
  double most = 0.0;
  for (int i = 0; i < arm.n(); ++i) {
    const JointVector step = kStep * JointVector::Unit(arm.n(), i);
    const double slope = (energy(arm, payload, q + step) - energy(arm, payload, q - step)) / (2.0 * kStep);
    most = std::max(most, std::abs(slope) / arm.joints[static_cast<std::size_t>(i)].limits.effort);
  }
  return most;
}

/// Distance of the tool from the lines between neighbouring joints, up to the third-last joint, sampled
/// closely [m].
double fold_at(const std::vector<Eigen::Isometry3d>& frames) {
  const Vec3 tool = frames.back().translation();
  double least = std::numeric_limits<double>::infinity();
  Vec3 from = Vec3::Zero();
  for (std::size_t k = 0; k + 3 < frames.size(); ++k) {
    const Vec3 to = frames[k].translation();
    for (int i = 0; i <= 100; ++i) least = std::min(least, (from + 0.01 * i * (to - from) - tool).norm());
    from = to;
  }
  return least;
}

TEST(FirstTaskPlace, IsAboveTheFloorClearOfTheArmAndLightOnEveryBundledRobot) {
  for (const std::string& name : bundled_names("robots")) {
    const auto arm = load_robot(name);
    const DefaultTask task = default_task(arm);
    const Payload& payload = task.scenario.plant.payload;
    const JointWalk walk = joints_along_path(task.scenario, task.goal, 0.2);  // centred as its gains do
    ASSERT_GT(walk.positions.size(), 1000U) << name;
    double low = std::numeric_limits<double>::infinity(), fold = low, load = 0.0;
    for (std::size_t step = 0; step < walk.positions.size(); ++step) {
      const JointVector& q = walk.positions[step].position;
      const std::vector<Eigen::Isometry3d> frames = frames_at(*arm, q);
      for (std::size_t k = 2; k < frames.size(); ++k) low = std::min(low, frames[k].translation().z());
      fold = std::min(fold, fold_at(frames));
      load = std::max(load, load_at(*arm, payload, q));
      const Vec3 wanted = task.scenario.path.at(walk.time[step]).position;
      EXPECT_LT((frames.back().translation() - wanted).norm(), 1e-3) << name << " at " << walk.time[step];
    }
    EXPECT_GE(low, 0.1 - 1e-9) << name;
    EXPECT_GE(fold, 0.08 * reach(*arm) - 1e-9) << name;
    EXPECT_LE(load, 0.75) << name;
    // A central difference of an energy of some 100 J over 2e-5 rad rounds to about 1e-8 N m.
    EXPECT_NEAR(task.load, load, 1e-6) << name;
    for (const NamedPath& target : task.scenario.targets) EXPECT_GE(target.path.center.z(), -1e-3) << name;
  }
}

}  // namespace first_task_place_test
}  // namespace armtune::internal
