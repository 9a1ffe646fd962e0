#include "sim/scenario/planned_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/planned.hpp"
#include "tests/sim/support/planned_motion.hpp"

namespace armtune::internal {
namespace planned_motion_test {

using test::PlannedMotion;
using test::refused_at;
using testing::HasSubstr;

TEST_F(PlannedMotion, ReadsEveryKnotToTheBitWhereverItsColumnsStand) {
  const JointSpline plan = load(write(csv()));
  EXPECT_EQ(plan.time().size(), 401U);
  EXPECT_EQ(plan.begin(), 8.0);
  EXPECT_EQ(plan.end(), 10.0);
  EXPECT_EQ(plan.knots().front().position, plan_.start);
  EXPECT_LT((plan.at(9.0).position - plan_.at(9.0).position).norm(),
            1e-4);  // accelerations linear over 5 ms: 2e-6 s^2 of jerk

  // Joints in reverse, something else in front.
  RobotModel reversed = *robot_;
  std::reverse(reversed.joints.begin(), reversed.joints.end());
  test::QuinticPlan other = plan_;
  other.start = plan_.start.reverse();
  other.goal = plan_.goal.reverse();
  const JointSpline same = load(write(test::plan_csv(reversed, other)));
  for (std::size_t k = 0; k < plan.knots().size(); ++k) {
    EXPECT_EQ(plan.knots()[k].position, same.knots()[k].position);
    EXPECT_EQ(plan.knots()[k].velocity, same.knots()[k].velocity);
    EXPECT_EQ(plan.knots()[k].acceleration, same.knots()[k].acceleration);
  }
}

TEST_F(PlannedMotion, OfWaypointsGoesThroughThemAtRestAtBothEnds) {
  std::string text = "time";
  for (const JointInfo& joint : robot_->joints) text += ",joint/" + joint.name + "/position";
  text += "\n8,0,0,0,0,0,0\n9,0.1,0.2,0.3,-0.1,-0.2,-0.3\n11,0.5,0,0,0,0,0\n";
  const JointSpline plan = load(write(text));
  EXPECT_EQ(plan.begin(), 8.0);
  EXPECT_EQ(plan.end(), 11.0);
  EXPECT_NEAR(plan.at(9.0).position[2], 0.3, 1e-12);
  EXPECT_NEAR(plan.at(11.0).position[0], 0.5, 1e-12);
  EXPECT_EQ(plan.at(8.0).velocity, JointVector(JointVector::Zero(6)));
  EXPECT_LT(plan.at(11.0).velocity.norm(), 1e-12);
  // From piece to piece without a jump.
  EXPECT_LT((plan.at(9.0 - 1e-9).velocity - plan.at(9.0 + 1e-9).velocity).norm(), 1e-6);
  EXPECT_LT((plan.at(9.0 - 1e-9).acceleration - plan.at(9.0 + 1e-9).acceleration).norm(), 1e-6);
  // Between waypoints within its limits the elbow would swing beyond them.
  std::string far = text;
  far.replace(far.find("0.1,0.2,0.3"), 11, "0.1,0.2,3.1");
  far.replace(far.find("11,0.5,0,0"), 10, "9.4,0.5,0,3.1");
  const InputError between = test::input_error([&] { load(write(far)); });
  EXPECT_THAT(between, refused_at({.file = folder_ / "plan.csv",
                                   .line = 3,
                                   .key = "joint/elbow_joint/position",
                                   .limit = "-3.14159 to 3.14159"}));
  EXPECT_THAT(between.what(), HasSubstr("between this point and the next"));
  // A velocity for one joint alone is a plan with columns missing.
  const std::string one_velocity =
      text.substr(0, text.find('\n')) + ",joint/elbow_joint/velocity\n8,0,0,0,0,0,0,0\n9,0,0,0,0,0,0,0\n";
  EXPECT_THAT([&] { load(write(one_velocity)); },
              refused_at({.line = 1, .key = "joint/shoulder_pan_joint/velocity"}));
}

TEST_F(PlannedMotion, PointsThatAreJoinedAsRosDoesAreWhereItsSegmentsAre) {
  // A joint between two points: of positions a straight line, of velocities too a cubic, of accelerations
  // too a quintic.
  const auto text = [this](int columns) {
    std::string header = "time", from = "\n2", to = "\n4";
    const std::vector<const char*> names = {"position", "velocity", "acceleration"};
    const std::vector<const char*> starts = {",0", ",0", ",0"}, ends = {",0.8", ",0.4", ",-0.6"};
    for (const JointInfo& joint : robot_->joints) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(columns); ++c) {
        header += ",joint/" + joint.name + "/" + names[c];
        from += starts[c];
        to += ends[c];
      }
    }
    return header + from + to + "\n";
  };
  const auto middle = [&](int columns) {
    folder_.write("moves.csv", text(columns));
    return scenario("planned: {file: moves.csv, segments: as_ros}\nduration: planned\n").planned->at(3.0);
  };
  const JointVector one = JointVector::Ones(6);
  EXPECT_LT((middle(1).position - 0.4 * one).norm(), 1e-14);
  EXPECT_LT((middle(1).velocity - 0.4 * one).norm(), 1e-14);
  // By hand from (q, q') = (0, 0) to (0.8, 0.4) in T = 2 s: c2 = 0.4, c3 = -0.1.
  EXPECT_LT((middle(2).position - 0.3 * one).norm(), 1e-14);
  EXPECT_LT((middle(2).velocity - 0.5 * one).norm(), 1e-14);
  // With q'' = -0.6 there: c3 = 0.45, c4 = -0.25, c5 = 0.0375.
  EXPECT_LT((middle(3).position - 0.2375 * one).norm(), 1e-14);
  // Rows with velocities and without accelerations can be joined in no other way.
  EXPECT_LT((load(folder_.write("moves.csv", text(2))).at(3.0).position - 0.3 * one).norm(), 1e-14);
  // Without interpolation, the next point is the state, but only points with velocities have one.
  folder_.write("moves.csv", text(2));
  const std::string jumps =
      "planned: {file: moves.csv, segments: next_point, speed: 0.5}\nduration: planned\n";
  const MotionPoint<JointVector> next = scenario(jumps).planned->at(3.0);
  EXPECT_EQ(next.position, JointVector(0.8 * one));
  EXPECT_EQ(next.velocity, JointVector(0.5 * 0.4 * one));
  folder_.write("moves.csv", text(1));
  EXPECT_THAT(
      [&] { scenario(jumps); },
      refused_at({.file = folder_ / "moves.csv", .key = "velocities", .limit = "velocities of each point"}));
  // Of accelerations that are not linear between rows, a motion that is to be smooth is refused.
  const InputError coarse = test::input_error([&] { load(folder_.write("moves.csv", text(3))); });
  EXPECT_THAT(coarse, refused_at({.file = folder_ / "moves.csv",
                                  .line = 3,
                                  .key = "joint/" + robot_->joints[0].name + "/position",
                                  .value = "0.8"}));
  EXPECT_THAT(coarse.what(), HasSubstr("more rows"));
}

TEST_F(PlannedMotion, WhatIsNoMotionOfTheRobotIsRefusedWithLineAndColumn) {
  const std::string a_number = "a finite number";
  const std::string pan = "joint/shoulder_pan_joint/", lift = "joint/shoulder_lift_joint/";
  EXPECT_THAT(refused(1, 0, "8"), refused_at({.line = 3, .key = "time", .value = "8", .limit = "above 8"}));
  EXPECT_THAT(refused(0, 0, "-1"),
              refused_at({.line = 2, .key = "time", .value = "-1", .limit = "at least 0"}));
  EXPECT_THAT(refused(2, 3, "nan"),
              refused_at({.line = 4, .key = pan + "acceleration", .value = "nan", .limit = a_number}));
  EXPECT_THAT(refused(2, 1, ""),
              refused_at({.line = 4, .key = pan + "position", .value = "", .limit = a_number}));
  EXPECT_THAT(refused(1, 2, "fast"), refused_at({.line = 3, .key = pan + "velocity", .value = "fast"}));
  EXPECT_THAT(
      refused(0, 7, "4"),
      refused_at(
          {.line = 2, .key = "joint/elbow_joint/position", .value = "4", .limit = "-3.14159 to 3.14159"}));
  const InputError jump = refused(1, 4, "2e-5");
  EXPECT_THAT(jump,
              refused_at({.line = 3, .key = lift + "position", .value = "2e-05", .limit = "0 within 1e-05"}));
  EXPECT_THAT(jump.what(), HasSubstr("more rows"));
  EXPECT_THAT(
      refused(1, 5, "2e-4"),
      refused_at({.line = 3, .key = lift + "velocity", .value = "0.0002", .limit = "0 within 0.0001"}));
  EXPECT_STREQ(refused(1, 4, "5e-6").what(), "nothing was refused") << "rounding to six digits is no jump";
}

TEST_F(PlannedMotion, MayPassAPositionLimitByAPlannersToleranceOnly) {
  const JointLimits& elbow = robot_->joints[2].limits;
  const auto at_rest_at = [&](double q) {
    JointVector position = JointVector::Zero(6);
    position[2] = q;
    std::string text = test::plan_header(*robot_);
    for (const double t : {8.0, 8.01}) {
      text += test::plan_row(t, {position, JointVector::Zero(6), JointVector::Zero(6)});
    }
    const std::string path = write(text);
    return test::input_error([&] { load(path); });
  };
  for (const double side : {-1.0, 1.0}) {
    const double limit = side < 0.0 ? elbow.lower : elbow.upper;
    EXPECT_STREQ(at_rest_at(limit + side * 0.9e-6).what(), "nothing was refused");
    EXPECT_THAT(at_rest_at(limit + side * 1.1e-6),
                refused_at({.line = 2, .key = "joint/elbow_joint/position", .limit = "-3.14159 to 3.14159"}));
  }
}

TEST_F(PlannedMotion, AFileThatIsNotOneIsRefused) {
  EXPECT_THAT([&] { load(folder_ / "none.csv"); }, refused_at({.file = folder_ / "none.csv"}));
  const std::string text = csv();
  const std::string one_row = text.substr(0, text.find('\n', text.find('\n') + 1) + 1);
  const std::string path = folder_ / "plan.csv";
  EXPECT_THAT([&] { load(write(one_row)); },
              refused_at({.file = path, .value = "1", .limit = "at least 2 rows"}));
  std::string no_elbow = text;
  no_elbow.replace(text.find("elbow_joint/velocity"), 5, "ankle");
  EXPECT_THAT([&] { load(write(no_elbow)); },
              refused_at({.file = path, .line = 1, .key = "joint/elbow_joint/velocity"}));
}

}  // namespace planned_motion_test
}  // namespace armtune::internal
