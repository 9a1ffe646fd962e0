// The page of a plan's folder, against the files that are in it.

#include "tuner/report/plan_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/sim/support/files.hpp"
#include "tests/tuner/report/support/decode.hpp"
#include "tests/tuner/report/support/recorded.hpp"
#include "tuner/planning/output/plan_facts.hpp"
#include "tuner/planning/output/plan_files.hpp"
#include "tuner/planning/tasks/solve_plan.hpp"
#include "tuner/report/plan_recording.hpp"
#include "tuner/report/run_report.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace plan_report_test {

using testing::HasSubstr;

constexpr std::size_t kBytes = 4'000'000;

/// A folder as `armtune plan` leaves it, but for the versions and the machine in run.json.
struct Folder {
  PlanTask task;
  PlanProblem problem;
  PlannedTrajectory planned;
  test::TemporaryFolder files;

  Folder(const std::string& name, int knots) : task(load_plan_task(name)) {
    task.knots = knots;
    problem = plan_problem(task);
    planned = solve_plan(problem);
    const auto uses = limit_uses(task, problem, planned);
    files.write("motion.csv", motion_csv(task, problem, planned.trajectory, 401));
    files.write("limits.csv", limits_csv(uses));
    Scene scene = scene_of({task.scenario}, {{"plan", ".", ""}}, task.clearance);
    scene.scenarios.front().name = task.name;
    files.write("scene.json", scene_json(scene));
    RunRecord run;
    run.kind = RunKind::kPlan;
    run.command = "armtune plan";
    run.wall_seconds = 1.5;
    run.plan = plan_facts(task, problem, planned, uses);
    files.write(kRunRecord, run_record_json(run));
  }
};

const Folder& a_switch() {
  static const Folder folder("ur10_switch", 60);
  return folder;
}

const PlanLimit* find(const ReportData& data, const std::string& limit, const std::string& part) {
  for (const PlanLimit& one : data.scenarios.front().limits) {
    if (one.limit == limit && one.part == part) return &one;
  }
  return nullptr;
}

TEST(PlanReport, EveryLimitIsDrawnInAPlotThatHasItsColumnAndItsUnit) {
  for (const char* name : {"ur10_switch", "ur10_clear_of_obstacles"}) {
    const Folder folder(name, 40);
    const ReportData data = report_of(folder.files.path(), kBytes);
    EXPECT_EQ(data.kind, RunKind::kPlan);
    EXPECT_THAT(data.left_out, testing::IsEmpty());
    ASSERT_EQ(data.scenarios.size(), 1U);
    const report::Run& run = data.scenarios.front().runs.at(0);
    for (const PlanLimit& limit : data.scenarios.front().limits) {
      const auto column = std::find_if(run.columns.begin(), run.columns.end(), [&](const PlotColumn& c) {
        return c.name == limit.column && c.group == limit.group && c.unit == limit.unit;
      });
      EXPECT_NE(column, run.columns.end())
          << limit.column << " in " << limit.group << " [" << limit.unit << "]";
      // Where it is in force the motion keeps it, between the knots but for a few hundredths.
      if (column == run.columns.end() || limit.from > 0.0) continue;
      const double room = 0.05 * std::max(std::abs(limit.lower), std::abs(limit.upper));
      if (!std::isnan(limit.lower) && !std::isnan(limit.upper)) {
        EXPECT_GE(column->series.lo, limit.lower - room);
        EXPECT_LE(column->series.hi, limit.upper + room);
      }
    }
  }
}

TEST(PlanReport, TimesCountFromThePlansStartAndActiveStretchesTouchTheLimit) {
  const ReportData data = report_of(a_switch().files.path(), kBytes);
  const ReportScenario& shown = data.scenarios.front();
  const report::Run& run = shown.runs.front();
  EXPECT_EQ(data.plan->start, 8.0);
  EXPECT_EQ(run.time.lo, 0.0);
  EXPECT_NEAR(run.end, a_switch().planned.trajectory.time.back() - 8.0, 1e-12);
  EXPECT_EQ(shown.duration, run.end);
  const PlanLimit* gaze = find(data, "gaze", "angle");
  ASSERT_NE(gaze, nullptr);
  EXPECT_NEAR(gaze->from, a_switch().planned.trajectory.durations[0], 1e-9) << "acquired, then held";
  EXPECT_TRUE(std::isnan(gaze->lower));
  const PlanLimit* wrist = find(data, "velocity", "wrist_2_joint");
  ASSERT_NE(wrist, nullptr);
  const auto& active = wrist->active_upper.empty() ? wrist->active_lower : wrist->active_upper;
  const double bound = wrist->active_upper.empty() ? wrist->lower : wrist->upper;
  ASSERT_FALSE(active.empty());
  const auto column = std::find_if(run.columns.begin(), run.columns.end(),
                                   [&](const PlotColumn& c) { return c.name == wrist->column; });
  ASSERT_NE(column, run.columns.end());
  const double interval = a_switch().planned.trajectory.time[1] - a_switch().planned.trajectory.time[0];
  int touched = 0;
  for (std::size_t i = 0; i < run.time.steps.size(); ++i) {
    const double t = run.time.at(i);
    // In its first interval it is the parabola's control point that is at the limit.
    if (t < active.front().first + interval || t > active.front().second) continue;
    EXPECT_NEAR(column->series.at(i), bound, 0.02 * std::abs(bound)) << t;
    ++touched;
  }
  EXPECT_GT(touched, 20);
}

TEST(PlanReport, ADistanceIsDrawnWhereItsKindIsWhateverTheObstacleIsCalled) {
  const auto columns_of = [](const std::string& name) {
    std::vector<LimitUse> uses(4);
    for (std::size_t i = 0; i < uses.size(); ++i) {
      uses[i].kind = static_cast<LimitKind>(static_cast<std::size_t>(LimitKind::kObstacle) + i);
      uses[i].limit = name;
    }
    std::vector<std::string> columns;
    for (const PlanLimit& limit :
         plan_limits_of(CsvTable::parse(limits_csv(uses), "limits.csv"), nullptr, 0.0)) {
      EXPECT_EQ(limit.group, "clearance");
      columns.push_back(limit.column);
    }
    return columns;
  };
  for (const char* name : {"distance to ball", "distance to part of it", "distance to the floor"}) {
    EXPECT_THAT(columns_of(name), testing::ElementsAre("obstacle/distance", "clearance/cell",
                                                       "clearance/floor", "clearance/self"))
        << name;
  }
}

TEST(PlanReport, TheReplayPutsTheToolWhereThePlanHasIt) {
  const ReportData data = report_of(a_switch().files.path(), kBytes);
  const Replay& replay = data.scenarios.front().runs.front().replay;
  EXPECT_GE(replay.n, 200U) << "a motion of half a second as well";
  ASSERT_EQ(replay.target.size(), 3U);
  for (std::size_t i = 0; i < replay.n; i += 9) {
    std::vector<double> q;
    for (const Series& joint : replay.q) q.push_back(joint.at(i));
    const Vec3 tool = test::frames(data.arms.front(), q).back() * data.arms.front().tool.p;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(tool[axis], replay.tool[static_cast<std::size_t>(axis)].at(i),
                  1e-4);  // q in steps of 1e-5 rad
  }
}

TEST(PlanReport, TheVerdictNamesTheTimeAndWhatHoldsItBack) {
  const ReportData data = report_of(a_switch().files.path(), kBytes);
  EXPECT_THAT(data.verdict.sentence, testing::AllOf(HasSubstr("is the least time found within the limits"),
                                                    HasSubstr("held back by velocity of wrist_2_joint")));
  EXPECT_THAT(data.title, testing::StartsWith("plan ur10_switch"));
  const yaml::Node page = test::parsed(report_json(data));
  EXPECT_EQ(test::at(page, "kind").as_string(), "plan");
  EXPECT_EQ(test::at(page, "scenarios/0/limits").items().size(), data.scenarios.front().limits.size());
  EXPECT_EQ(test::at(page, "plan/start").as_number(), 8.0);
  const RunRecord record = find_run_record(a_switch().files.path()).value();
  ASSERT_TRUE(record.plan);
  EXPECT_EQ(data.plan->scenario, record.plan->scenario);
  EXPECT_EQ(data.provenance.command, "armtune plan");
  const auto& figures = data.plan->figures;
  EXPECT_THAT(figures,
              testing::Contains(testing::Pair("knots of the time grid",
                                              std::to_string(a_switch().planned.trajectory.time.size()))));
  EXPECT_THAT(figures, testing::Contains(testing::Pair("wall clock seconds", "1.500")));
  EXPECT_THAT(figures,
              testing::Contains(testing::Pair("interior-point steps on all grids",
                                              std::to_string(a_switch().planned.interior_iterations))));
}

TEST(PlanReport, WhatIsMissingOrSpoiltIsLeftOutAndSaid) {
  const Folder& whole = a_switch();
  for (const char* gone : {"limits.csv", kRunRecord, "scene.json"}) {
    const test::TemporaryFolder folder;
    for (const char* file : {"motion.csv", "limits.csv", kRunRecord, "scene.json"}) {
      if (std::string(file) != gone) folder.write(file, test::read_text(whole.files / file));
    }
    const ReportData data = report_of(folder.path(), kBytes);
    ASSERT_EQ(data.left_out.size(), 1U) << gone;
    EXPECT_THAT(data.left_out.front(), HasSubstr(gone));
    EXPECT_EQ(data.scenarios.front().runs.size(), 1U) << gone;
    EXPECT_EQ(data.scenarios.front().runs.front().replay.n == 0, std::string(gone) == "scene.json");
  }
  const test::TemporaryFolder folder;
  folder.write("motion.csv", test::read_text(whole.files / "motion.csv"));
  std::string limits = test::read_text(whole.files / "limits.csv");
  limits.replace(limits.find(",8:"), 3, ",x:");
  folder.write("limits.csv", limits);
  EXPECT_THAT(report_of(folder.path(), kBytes).left_out, testing::Contains(HasSubstr("expected FROM:TO")));
}

}  // namespace plan_report_test
}  // namespace armtune::internal::report
