#pragma once
// The main job on an arm made at random, with the task that it has joints for.

#include <Eigen/LU>
#include <cmath>
#include <random>

#include "core/control/measured_arm.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal::test {

struct Job {
  Scenario scenario;
  Gains gains;
};

/// Of many poses the one in which the arm moves best.
inline JointVector dexterous_pose(const RobotModel& arm, TaskMask mask, std::mt19937& generator) {
  JointVector best;
  double most = -1.0;
  MeasuredArm measured;
  for (int sample = 0; sample < 300; ++sample) {
    const JointVector q = random_configuration(generator, arm);
    measured.measure(arm.chain, q, JointVector(JointVector::Zero(arm.n())), {0.0, 0.05}, mask);
    if (measured.inverse.manipulability() > most) {
      most = measured.inverse.manipulability();
      best = q;
    }
  }
  return best;
}

/// A small circle about where the tool is, a target ahead of it. Limits that it cannot come to: the law is
/// that it follows, not that any circle is within reach.
inline Job random_job(int n, unsigned seed, bool with_prismatic) {
  RobotModel arm = random_arm(n, seed, with_prismatic);
  for (JointInfo& joint : arm.joints) {
    joint.limits.velocity = 20.0;
    joint.limits.effort = 1e5;
  }
  std::mt19937 generator(seed);
  Job job;
  Scenario& scenario = job.scenario;
  scenario.mask = largest_mask(n);
  const JointVector q = dexterous_pose(arm, scenario.mask, generator);
  JointMatrix M = mass_matrix_at(arm.chain, q);
  M.diagonal() += arm.chain.rotor_inertia;
  const Poses poses = poses_at(arm.chain, q);

  Gains& gains = job.gains;
  gains.joint_space_goal = q;
  for (int i = 0; i < n; ++i) {
    if (arm.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute) {
      gains.joint_space_goal[i] *= 180.0 / M_PI;
    }
  }
  gains.joint_space_gains_p = JointVector::Constant(n, 10.0);
  // Of the inertia that a joint feels with the others free: M^-1 Kd has no eigenvalue above 40 n, so that the
  // torque can be held for a period.
  gains.joint_space_gains_d = 40.0 * JointMatrix(M.inverse()).diagonal().cwiseInverse();
  gains.task_space_gains_p.setConstant(20.0);
  gains.task_space_gains_d = gains.joint_space_gains_d;
  gains.force_control_gains = JointVector::Zero(n);
  gains.joint_trajectory_duration = 0.5;
  gains.manipulability_threshold = 1e-5;
  gains.gaze_feedforward = true;
  gains.joint_centering_gain = 0.2;

  scenario.name = arm.name;
  scenario.robot = std::make_shared<const RobotModel>(std::move(arm));
  scenario.duration = 5.0;
  scenario.control_period = 0.002;
  scenario.start_position = q;
  scenario.path = {poses.p_0T, 1.5, 0.0, {{1, Vec3(0.0, 0.0, 0.02), Vec3(0.0, 0.02, 0.0)}}};
  scenario.targets = {{"ahead", {poses.p_0T + 0.8 * poses.R_0T.col(2), 0.0, 0.0, {}}}};
  scenario.theta.model_scale = 1.0;
  return job;
}

/// The same with all that a main job has: velocity limits that matter, under the extended law; theta a tenth
/// off, and learnt; two targets that take turns; an obstacle that comes as close to the last link's joint as
/// half its influence, and goes again.
inline Job whole_job(int n, unsigned seed, bool with_prismatic) {
  Job job = random_job(n, seed, with_prismatic);
  Scenario& scenario = job.scenario;
  RobotModel arm = *scenario.robot;
  for (JointInfo& joint : arm.joints) joint.limits.velocity = 2.0;
  const Poses poses = poses_at(arm.chain, scenario.start_position);
  scenario.robot = std::make_shared<const RobotModel>(std::move(arm));
  scenario.duration = 16.0;
  scenario.theta.model_scale = 0.9;
  scenario.switch_every = 4.0;
  const Vec3 aside = 0.1 * poses.R_0T.col(0);
  const Vec3 ahead = poses.p_0T + 0.8 * poses.R_0T.col(2);
  scenario.targets = {{"one", {ahead - aside, 0.0, 0.0, {}}}, {"other", {ahead + aside, 0.0, 0.0, {}}}};

  Gains& gains = job.gains;
  gains.velocity_margin = 0.8;
  gains.velocity_barrier_gain = 1.0;
  gains.variable_damping = true;
  gains.adaptation_projection = true;
  gains.adaptation_gain = 1.0;
  gains.joint_goal_follows_task = true;
  gains.slerp_start_angle = 0.03;
  gains.obstacleInfluenceRadius = 0.1;
  gains.force_control_gains.setConstant(20.0);
  // Every second one has a gain for each force point and joint.
  if (seed % 2 == 1) gains.force_control_gains = ForceGains::LinSpaced(n * n, 10.0, 30.0);
  // On the far side of that joint from the base, so that nothing else is as close.
  const Vec3 joint = poses.p_0B[static_cast<std::size_t>(n - 1)];
  const Vec3 out = joint.normalized();
  const double near = 0.05;
  const double sway = 0.5;  // there at 10 s: cos(w t) = 1
  scenario.obstacles = {
      {"passer",
       {joint + (near + sway) * out, 2.0 * M_PI / 10.0, 0.0, {{1, -sway * out, Vec3::Zero()}}},
       0.0}};
  return job;
}

}  // namespace armtune::internal::test
