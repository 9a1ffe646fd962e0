// The files of a plan against the motion they are of.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "core/robot/dynamics.hpp"
#include "core/trajectory/gaze.hpp"
#include "tests/sim/support/csv.hpp"
#include "tests/tuner/support/solved_plan.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/plan_files.hpp"

namespace armtune::internal {
namespace plan_output_test {

using test::a_limited_move;
using test::a_return;
using test::a_switch;
using test::Solved;
using testing::HasSubstr;
using testing::Not;

/// The largest use of a limit over an interval's tenths, by kinematics and dynamics at point_at.
template <typename Use>
std::pair<double, double> largest(const Solved& plan, double from, double to, Use use) {
  std::pair<double, double> found{0.0, 0.0};  // at knots, between them
  const Trajectory& t = plan.motion();
  for (std::size_t k = 0; k < t.time.size(); ++k) {
    for (int part = 0; part < 10; ++part) {
      if (part > 0 && k + 1 == t.time.size()) continue;
      const double time = part == 0 ? t.time[k] : t.time[k] + 0.1 * part * (t.time[k + 1] - t.time[k]);
      if (time < from || time > to) continue;
      const TrajectoryPoint point = point_at(t, time);
      const int n = plan.robot().n();
      const JointVector q = point.position.head(n);
      Poses poses;
      forward_kinematics(plan.robot().chain, q, poses);
      const JointVector qd = point.velocity.head(n);
      const JointVector qdd = point.acceleration.head(n);
      JointVector tau;
      inverse_dynamics(plan.robot().chain, poses, qd, qdd, tau);
      double& worst = part == 0 ? found.first : found.second;
      worst = std::max(worst, use(time, point, poses, tau));
    }
  }
  return found;
}

TEST(PlanLimits, OfASolvedPlanNoneIsBrokenAtAKnotAndThoseThatHoldItBackAreReached) {
  for (const Solved* plan : {&a_switch(), &a_limited_move(), &a_return()}) {
    std::set<std::string> kinds;
    bool any = false;
    for (const LimitUse& use : plan->uses) {
      SCOPED_TRACE(plan->task.name + ": " + use.limit + " of " + use.part);
      kinds.insert(use.limit);
      // 1e-8 is what the solver allows; velocities and sines are a little apart from what it scales.
      EXPECT_LE(use.at_knots, 1.0 + 1e-6);
      EXPECT_LE(use.share, 1.0);
      EXPECT_EQ(use.strength > 0.0, !use.stretches.empty());
      if (use.strength > 0.0) {
        any = true;
        EXPECT_GE(use.at_knots, 1.0 - 0.05) << "a velocity's control point may reach it alone";
      }
      double before = plan->motion().time.front();
      for (const Stretch& stretch : use.stretches) {
        EXPECT_GE(stretch.from, before);
        EXPECT_GE(stretch.to, stretch.from);
        before = stretch.to;
      }
      EXPECT_LE(before, plan->motion().time.back());
    }
    EXPECT_TRUE(any);
    EXPECT_EQ(kinds.count("jerk"), plan->task.limits.jerk.size() > 0 ? 1U : 0U);
    EXPECT_TRUE(std::is_sorted(plan->uses.begin(), plan->uses.end(),
                               [](const LimitUse& a, const LimitUse& b) { return a.strength > b.strength; }));
  }
}

TEST(PlanLimits, BetweenTheKnotsTorquePathAndGazeAreWhatKinematicsAndDynamicsSay) {
  const Solved& plan = a_switch();
  const Scenario& scenario = plan.task.scenario;
  const Path target = scenario.targets[scenario.active_target(plan.task.at + 0.01)].path;
  int seen = 0;
  for (const LimitUse& use : plan.uses) {
    std::pair<double, double> expected;
    if (use.limit == "torque") {
      const auto names = joint_names(plan.robot());
      const auto i = std::find(names.begin(), names.end(), use.part) - names.begin();
      const double limit = plan.robot().joints[static_cast<std::size_t>(i)].limits.effort;
      expected = largest(plan, use.from, use.to,
                         [&](double, const TrajectoryPoint&, const Poses&, const JointVector& tau) {
                           return std::abs(tau[i]) / limit;
                         });
    } else if (use.limit == "tool path") {
      const Eigen::Index axis = use.part[0] - 'x';
      expected = largest(plan, use.from, use.to,
                         [&](double t, const TrajectoryPoint&, const Poses& poses, const JointVector&) {
                           return std::abs(poses.p_0T[axis] - scenario.path.at(t).position[axis]) /
                                  plan.task.path_tolerance;
                         });
    } else if (use.limit == "gaze") {
      EXPECT_NEAR(use.from, plan.task.at + plan.motion().durations[0], 1e-9) << "from the hold on";
      expected = largest(plan, use.from, use.to,
                         [&](double t, const TrajectoryPoint&, const Poses& poses, const JointVector&) {
                           return gaze_angle(poses.R_0T, poses.p_0T, target.at(t).position) /
                                  plan.task.gaze_threshold;
                         });
    } else {
      continue;
    }
    SCOPED_TRACE(use.limit + " of " + use.part);
    ++seen;
    // At knots the trajectory stands as the solver has it; the cubic ends 1e-8 of a unit beside it.
    EXPECT_NEAR(use.at_knots, expected.first, 1e-4);
    EXPECT_NEAR(use.between, expected.second, 1e-9);
  }
  EXPECT_EQ(seen, 6 + 3 + 1);
}

TEST(PlanLimits, ATrajectoryThatIsPulledApartBetweenItsKnotsIsSeen) {
  // The same positions at the knots, one velocity another: only after that knot the tool is elsewhere, by up
  // to 25 ms * 0.2 rad/s at half a metre.
  Solved plan = a_switch();
  plan.planned.trajectory.velocity(0, 50) += 0.2;
  const auto before = worst_between(a_switch().uses, {LimitKind::kToolPath});
  const std::vector<LimitUse> uses = limit_uses(plan.task, plan.problem, plan.planned);
  const auto after = worst_between(uses, {LimitKind::kToolPath});
  ASSERT_NE(after.use, nullptr);
  EXPECT_LT(before.between, 1.5);
  EXPECT_GT(after.between, 2.0);
  EXPECT_GT(after.use->between_time, plan.motion().time[50]);
  EXPECT_LT(after.use->between_time, plan.motion().time[51]);
  EXPECT_NEAR(after.use->at_knots, 1.0, 1e-4);
  const std::vector<LimitKind> distances = {LimitKind::kObstacle, LimitKind::kCellPart, LimitKind::kFloor,
                                            LimitKind::kLinks};
  EXPECT_EQ(worst_between(uses, distances).use, nullptr) << "no clearance, no limit";
  EXPECT_THAT(between_words(uses), testing::AllOf(HasSubstr("torque of"), HasSubstr("gaze at most")));
}

TEST(PlanLimits, AReturnThatEndsAfterASwitchLooksAtTheTargetOfItsEnd) {
  PlanTask task = load_plan_task("ur10_return");
  task.scenario = load_scenario("target_switch");
  task.at = 15.9;  // the targets switch at 16 s; the return takes longer than 0.1 s
  const Solved plan(task, 60);
  const double end = plan.motion().time.back();
  ASSERT_GT(end, 16.0);
  EXPECT_GT(plan.problem.target_until, end);
  const Scenario& scenario = plan.task.scenario;
  const Vec3 target = scenario.targets[scenario.active_target(end)].path.at(end).position;
  EXPECT_EQ(plan.problem.gaze_target(end).position, target);
  Poses poses;
  const JointVector q = plan.motion().position.rightCols<1>();
  forward_kinematics(plan.robot().chain, q, poses);
  EXPECT_LE(gaze_angle(poses.R_0T, poses.p_0T, target), task.gaze_threshold * (1.0 + 1e-6));
  for (const LimitUse& use : plan.uses) {
    if (use.limit == "gaze") {
      EXPECT_LE(use.at_knots, 1.0 + 1e-6);
    }
  }
}

TEST(PlanFiles, TrajectoryHasEveryKnotAndRatiosToTheRobotsLimits) {
  const Solved& plan = a_limited_move();
  const test::Csv csv(trajectory_csv(plan.task, plan.problem, plan.motion()));
  ASSERT_EQ(csv.rows.size(), plan.motion().time.size());
  const std::string joint = "joint/elbow_joint/";
  const JointLimits limits = plan.robot().joints[2].limits;
  double largest_ratio = 0.0;
  for (std::size_t k = 0; k < csv.rows.size(); ++k) {
    EXPECT_EQ(std::stod(csv.at(k, "time")), plan.motion().time[k]);
    EXPECT_EQ(std::stod(csv.at(k, joint + "position")),
              plan.motion().position(2, static_cast<Eigen::Index>(k)));
    const double ratio = std::stod(csv.at(k, joint + "velocity_ratio"));
    EXPECT_DOUBLE_EQ(ratio, std::abs(std::stod(csv.at(k, joint + "velocity"))) / limits.velocity);
    EXPECT_DOUBLE_EQ(std::stod(csv.at(k, joint + "torque_ratio")),
                     std::abs(std::stod(csv.at(k, joint + "torque"))) / limits.effort);
    largest_ratio = std::max(largest_ratio, ratio);
  }
  EXPECT_LE(largest_ratio, 0.5 + 1e-6) << "half the robot's limit is what the task allows";
  for (const PlanColumn& column : trajectory_columns(plan.task, plan.robot())) {
    if (column.name == joint + "velocity_ratio") {
      EXPECT_THAT(column.meaning, HasSubstr("robot's limit; this task allows 0.5"));
    }
    if (column.name == joint + "torque_ratio") {
      EXPECT_THAT(column.meaning, HasSubstr("allows 0.75"));
    }
  }
}

TEST(PlanFiles, MotionIsTheCubicAtEvenTimesWithItsErrors) {
  const Solved& plan = a_switch();
  const test::Csv csv(motion_csv(plan.task, plan.problem, plan.motion(), 101));
  ASSERT_EQ(csv.rows.size(), 101U);
  const double start = plan.motion().time.front();
  const double step = (plan.motion().time.back() - start) / 100.0;
  for (std::size_t row = 0; row < 101; ++row) {
    const double t = std::stod(csv.at(row, "time"));
    EXPECT_NEAR(t, start + static_cast<double>(row) * step, 1e-12 * start);
    const TrajectoryPoint point = point_at(plan.motion(), t);
    EXPECT_DOUBLE_EQ(std::stod(csv.at(row, "joint/wrist_2_joint/position")), point.position[4]);
    EXPECT_DOUBLE_EQ(std::stod(csv.at(row, "joint/wrist_2_joint/acceleration")), point.acceleration[4]);
    for (int axis = 0; axis < 3; ++axis) {
      const std::string end = std::string("position/") + "xyz"[axis];
      const double desired = plan.task.scenario.path.at(t).position[axis];
      EXPECT_DOUBLE_EQ(std::stod(csv.at(row, "desired/" + end)), desired);
      EXPECT_NEAR(std::stod(csv.at(row, "error/" + end)), std::stod(csv.at(row, "tool/" + end)) - desired,
                  1e-15);
    }
  }
  const std::vector<std::string>& header = csv.header;
  EXPECT_EQ(std::set<std::string>(header.begin(), header.end()).size(), header.size());
  EXPECT_THAT(header, Not(testing::Contains(HasSubstr("jerk")))) << "none is limited";
  const test::Csv move(
      motion_csv(a_limited_move().task, a_limited_move().problem, a_limited_move().motion(), 101));
  EXPECT_THAT(move.header, testing::Contains("joint/elbow_joint/jerk"));
  EXPECT_THAT(move.header, Not(testing::Contains(HasSubstr("error/")))) << "a move has no path";
  // Jerk is the slope of the acceleration: over the whole motion it sums up to its change, zero here.
  double sum = 0.0;
  for (std::size_t row = 0; row < 101; ++row)
    sum += std::stod(move.at(row, "joint/elbow_joint/jerk")) / 101.0;
  EXPECT_NEAR(sum, 0.0, 2.0) << "of 100 rad/s^3 at most, at 101 of infinitely many times";
}

TEST(PlanFiles, LimitsSayWhatHoldsThePlanBackAndWhen) {
  const test::Csv csv(limits_csv(a_switch().uses));
  ASSERT_EQ(csv.rows.size(), a_switch().uses.size());
  EXPECT_EQ(csv.header.size(), limits_columns().size());
  EXPECT_EQ(csv.at(0, "limit"), "velocity");
  EXPECT_EQ(csv.at(0, "part"), "wrist_2_joint");
  const std::string when = csv.at(0, "active_lower") + csv.at(0, "active_upper");
  EXPECT_TRUE(std::regex_match(when, std::regex(R"(8\.0\d*:8\.1\d*)"))) << when;
}

TEST(PlanFacts, HeadlineTellsTimeFromError) {
  EXPECT_THAT(plan_headline(a_switch().task, a_switch().problem, a_switch().planned),
              HasSubstr("s is the least time found within the limits"));
  const Solved lap(load_plan_task("ur10_lap"), 40);
  EXPECT_THAT(plan_headline(lap.task, lap.problem, lap.planned), HasSubstr("mm off its path"));
  PlanTask slow = load_plan_task("ur10_move");
  slow.duration = 2.0;
  const Solved move(slow, 20);
  EXPECT_EQ(plan_headline(move.task, move.problem, move.planned),
            "the smoothest motion of 2 s found within the limits");
}

TEST(PlanFacts, AreThoseOfTheSolutionAndOfTheUsesBetweenTheKnots) {
  const PlannedTrajectory& planned = a_switch().planned;
  const PlanFacts facts = plan_facts(a_switch().task, a_switch().problem, planned, a_switch().uses);
  EXPECT_EQ(facts.task, "switch");
  EXPECT_EQ(facts.scenario, a_switch().task.scenario.name);
  EXPECT_EQ(facts.headline, plan_headline(a_switch().task, a_switch().problem, planned));
  EXPECT_EQ(facts.knots, static_cast<long>(planned.trajectory.time.size()));
  EXPECT_EQ(facts.violation, planned.result.last.violation);
  EXPECT_EQ(facts.stationarity, planned.result.last.stationarity);
  EXPECT_EQ(facts.complementarity, planned.result.last.complementarity);
  EXPECT_DOUBLE_EQ(facts.objective * facts.objective_weight, planned.result.last.objective);
  ASSERT_EQ(facts.phases.size(), planned.trajectory.durations.size());
  for (std::size_t p = 0; p < facts.phases.size(); ++p)
    EXPECT_EQ(facts.phases[p].duration, planned.trajectory.durations[p]) << facts.phases[p].name;
  std::set<std::string> kinds;
  for (const BetweenFact& worst : facts.between_knots) {
    EXPECT_TRUE(kinds.insert(worst.kind).second) << worst.kind;
    ASSERT_TRUE(worst.share) << worst.kind;
    for (const LimitUse& use : a_switch().uses) {
      if (use.limit == worst.limit && use.from < use.to) {
        EXPECT_LE(use.between, *worst.share) << use.limit << " of " << use.part;
      }
    }
  }
  EXPECT_THAT(kinds, testing::IsSupersetOf({"torque", "tool_path", "gaze"}));
}

}  // namespace plan_output_test
}  // namespace armtune::internal
