#pragma once
// Rollouts of all kinds of controllers, on bundled scenarios and with a planned motion.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tests/sim/support/lanes.hpp"

namespace armtune::internal::test {

/// The bundled gains of the scenario's arm, which move it to its task in 2 s.
inline Gains bundled_gains(const Scenario& scenario) {
  const std::string arm = scenario.robot->n() == 6   ? "published"
                          : scenario.robot->n() == 7 ? "panda"
                                                     : "youbot";
  Gains quick = load_gains(arm, joint_names(*scenario.robot));
  quick.joint_trajectory_duration = 2.0;
  return quick;
}

/// The joint positions with which the tool is on its task.
inline JointVector joint_goal(const Scenario& scenario) {
  return in_si(*scenario.robot, with_goal(bundled_gains(scenario), scenario).joint_space_goal);
}

/// Gains of a kind of controller, with which a search would begin.
inline Gains gains_of(const Scenario& scenario, const char* kind) {
  return convert_gains(controller_kind(kind), bundled_gains(scenario), *scenario.robot, joint_goal(scenario));
}

/// The scenario with a planned motion in front of its task, which the controller's model of the arm fits. The
/// joints move between positions at constant velocities, so that each velocity jumps at the turn.
inline Scenario with_plan(Scenario scenario) {
  const JointVector goal = joint_goal(scenario);
  const JointVector rest = JointVector::Zero(goal.size());
  std::vector<MotionPoint<JointVector>> points;
  for (const double away : {0.2, -0.1, 0.0, 0.0}) {
    points.push_back({goal + JointVector::Constant(goal.size(), away), rest, rest});
  }
  scenario.planned = std::make_shared<const JointSpline>(std::vector<double>{0.0, 0.5, 1.0, 1.5}, points,
                                                         PointsGive::kPositions);
  scenario.start_position = points.front().position;
  scenario.theta = {};
  scenario.theta.model_scale = 1.0;
  return scenario;
}

/// The scenario with a robot that `change` has changed.
template <typename Change>
Scenario with_robot(Scenario scenario, const Change& change) {
  RobotModel robot = *scenario.robot;
  change(robot);
  scenario.robot = std::make_shared<const RobotModel>(robot);
  return scenario;
}

/// Adds the first job once for each of these gains of its controller, with this value in all joints.
inline void add_jobs_with(const std::vector<std::pair<const char*, double>>& gains,
                          std::vector<LaneJob>& jobs) {
  for (const auto& [name, value] : gains) {
    LaneJob other = jobs.front();
    own(other.gains, name).setConstant(value);
    jobs.push_back(other);
  }
}

/// Adds the first job with a limit on which its rollout ends early.
inline void add_hopeless_job(std::vector<LaneJob>& jobs) {
  jobs.push_back(jobs.front());
  jobs.back().limits = {{Metric::kJointVelocityMaxRatio, 0.05}};
  ASSERT_EQ(alone(jobs.back()).status, RolloutStatus::kHopeless);
}

/// Adds jobs of three random arms, with the gains of the first three.
inline void add_perturbed_jobs(const Scenario& scenario, std::vector<LaneJob>& jobs) {
  for (std::size_t sample = 0; sample < 3; ++sample)
    jobs.push_back(job_of(perturbed(scenario, Perturbation{}, 11, sample), jobs[sample].gains));
}

/// Every rollout must differ from every other one, so that each of their settings has an effect.
inline void expect_different_and_the_same(const std::vector<LaneJob>& jobs) {
  std::vector<std::vector<std::uint64_t>> results;
  for (const LaneJob& job : jobs) results.push_back(bits(alone(job).metrics));
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(results[i], results[j]) << i << ", " << j;
  }
  expect_the_same(jobs);
}

}  // namespace armtune::internal::test
