#include "tuner/planning/session/tool_waypoints.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "core/robot/kinematics.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace tool_waypoints_test {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// A UR5e's tool that passes four waypoints, the first at 1 s.
class ToolMotionAlong : public testing::Test {
 protected:
  ToolMotionAlong() {
    const JointVector q = (JointVector(6) << 0.3, -1.2, 1.5, -1.9, -1.4, 0.2).finished();
    forward_kinematics(robot_->chain, q, first_);
    offsets_ = {Vec3::Zero(), Vec3(0.1, 0.0, 0.0), Vec3(0.1, 0.08, -0.05), Vec3(0.0, 0.05, 0.0)};
  }

  /// Writes the waypoints, `apart` seconds from one to the next, and returns the file's path.
  std::string write(double apart, bool turned, double scale = 1.0) {
    std::string text = turned ? "time,x,y,z,qw,qx,qy,qz\n" : "Time;X;Y;Z\n";
    const Eigen::Quaterniond turn(first_.R_0T);
    for (std::size_t k = 0; k < offsets_.size(); ++k) {
      const Vec3 p = scale * (first_.p_0T + offsets_[k]);
      const char* between = turned ? "," : ";";
      text += fmt::format("{1}{0}{2}{0}{3}{0}{4}", between, 1.0 + apart * static_cast<double>(k), p.x(),
                          p.y(), p.z());
      if (turned) text += fmt::format(",{},{},{},{}", turn.w(), turn.x(), turn.y(), turn.z());
      text += "\n";
    }
    return folder_.write("waypoints.csv", text);
  }
  ToolWaypoints waypoints(const std::string& path, double speed = 1.0) const {
    return {{path}, robot_, nullptr, true, speed};
  }
  std::string refusal(const ToolWaypoints& given) const {
    return test::refusal([&] { motion_along(given); });
  }
  Poses pose_at(const JointSpline& motion, double time) const {
    Poses poses;
    forward_kinematics(robot_->chain, motion.at(time).position, poses);
    return poses;
  }

  std::shared_ptr<const RobotModel> robot_ = load_robot("ur5e");
  Poses first_;
  std::vector<Vec3> offsets_;
  test::TemporaryFolder folder_;
};

TEST_F(ToolMotionAlong, TheToolPassesEveryWaypointInTime) {
  for (const bool turned : {false, true}) {
    for (const double speed : {1.0, 0.5}) {
      const TimedGoals found = motion_along(waypoints(write(1.5, turned), speed));
      EXPECT_EQ(found.motion.begin(), 0.0);
      EXPECT_NEAR(found.motion.end(), 4.5 / speed, 0.05);
      EXPECT_EQ(found.motion.at(0.0).velocity.norm(), 0.0);
      for (std::size_t k = 0; k < offsets_.size(); ++k) {
        const Poses poses = pose_at(found.motion, 1.5 * static_cast<double>(k) / speed);
        EXPECT_LT((poses.p_0T - first_.p_0T - offsets_[k]).norm(), 1e-3) << turned << " " << k;
        if (turned) {
          EXPECT_LT((poses.R_0T - first_.R_0T).norm(), 2e-3) << k;
        }
      }
      // Half way between two waypoints, too: at rest at both ends, the spline is not a straight line.
      EXPECT_GT((pose_at(found.motion, 0.75 / speed).p_0T - first_.p_0T).norm(), 0.02);
    }
  }
}

TEST_F(ToolMotionAlong, TheMessageHasTheSameMotion) {
  const TimedGoals found = motion_along(waypoints(write(1.5, true)));
  const JointSpline read =
      load_planned_motion({{folder_.write("message.yaml", found.message)}, Segments::kAsRos}, *robot_);
  ASSERT_EQ(read.end(), found.motion.end());
  for (double time = 0.0; time < read.end(); time += 0.013)
    EXPECT_LT((read.at(time).position - found.motion.at(time).position).cwiseAbs().maxCoeff(), 1e-6) << time;
}

TEST_F(ToolMotionAlong, WhatTheArmCannotFollowIsRefusedWithTheFile) {
  EXPECT_THAT(
      refusal(waypoints(write(0.3, true), 10.0)),
      AllOf(HasSubstr("waypoints.csv"), HasSubstr("times its velocity limit"), HasSubstr("--speed ")));
  EXPECT_THAT(refusal(waypoints(write(1.5, true, 3.0))), HasSubstr("waypoints.csv"));
  offsets_[2] = Vec3(0.0, 0.0, 2.0);
  EXPECT_THAT(
      refusal(waypoints(write(1.5, false))),
      AllOf(HasSubstr("waypoints.csv"), HasSubstr("leaves the workspace"), HasSubstr("move the waypoints"),
            testing::Not(HasSubstr("the path, or"))));  // advice for scenarios
}

TEST_F(ToolMotionAlong, BecomesAScenarioOfAControllersStudy) {
  ControllerStudyInputs inputs;
  inputs.robot = "ur5e";
  inputs.controllers = test::source_dir() + "/examples/joint_trajectory/ros2_controllers.yaml";
  inputs.trajectories = {write(1.5, true)};
  EXPECT_THAT(test::refusal([&] { write_controller_study(inputs, folder_ / "none"); }),
              HasSubstr("waypoints.csv"))
      << "without a function that finds the motion";
  inputs.tool_motion = motion_along;
  const ControllerStudyFiles files = write_controller_study(inputs, folder_ / "made").value();
  EXPECT_THAT(files.written, UnorderedElementsAre("study.yaml", "waypoints.yaml", "waypoints_motion.yaml"));
  EXPECT_THAT(files.notes,
              Contains(AllOf(HasSubstr("waypoints of the tool"), HasSubstr("waypoints_motion.yaml"))));
  const Study study = load_study(files.study);
  const Scenario& scenario = study.scenarios.front();
  ASSERT_TRUE(scenario.planned);
  EXPECT_LT((pose_at(*scenario.planned, 1.5).p_0T - first_.p_0T - offsets_[1]).norm(), 1e-3);

  // The tool's errors count in motions that are given for the tool, and nowhere else.
  const auto tool_terms = [](const Study& of) {
    std::vector<ObjectiveTerm> terms = of.terms;
    std::erase_if(terms, [](const ObjectiveTerm& term) {
      return term.metric != Metric::kToolErrorRms && term.metric != Metric::kToolErrorMax;
    });
    return terms;
  };
  EXPECT_EQ(tool_terms(study).size(), 2U);
  inputs.trajectories.insert(inputs.trajectories.begin(),
                             test::source_dir() + "/examples/joint_trajectory/moves.csv");
  for (const ObjectiveTerm& term :
       tool_terms(load_study(write_controller_study(inputs, folder_ / "both").value().study)))
    EXPECT_THAT(term.scenarios, testing::ElementsAre(1U)) << name(term.metric);
  inputs.trajectories.pop_back();
  EXPECT_THAT(tool_terms(load_study(write_controller_study(inputs, folder_ / "joints").value().study)),
              testing::IsEmpty());
}

}  // namespace tool_waypoints_test
}  // namespace armtune::internal
