// What the page is given of a rollout, against the rollout itself.

#include "tuner/report/recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "tests/tuner/report/support/recorded.hpp"
#include "tuner/report/buckets.hpp"

namespace armtune::internal::report {
namespace recording_test {

using test::recorded;

Run whole_run() {
  return run_of(recorded().table, &recorded().shown(), &recorded().arm(), {});
}

double half_step(const Series& series) {
  return (series.hi - series.lo) / Series::kSteps / 2.0 * (1.0 + 1e-9);
}

std::size_t row_at(const CsvTable& table, double time) {
  const auto times = table.numbers(table.column("time"));
  const auto after = std::lower_bound(times.begin(), times.end(), time - 1e-6);
  return std::min(static_cast<std::size_t>(after - times.begin()), times.size() - 1);
}

TEST(Recording, ReplaysJointsTargetAndToolAsTheyWere) {
  const CsvTable& table = recorded().table;
  const auto run = whole_run();
  const Replay& replay = run.replay;
  EXPECT_DOUBLE_EQ(replay.dt, 0.04);
  EXPECT_EQ(replay.n, 200U) << "25 a second, for the 7.99 s between the first row and the last";
  ASSERT_EQ(replay.q.size(), recorded().arm().joints.size());
  for (std::size_t i = 0; i < replay.n; ++i) {
    const std::size_t row = row_at(table, static_cast<double>(i) * replay.dt);
    for (std::size_t j = 0; j < replay.q.size(); ++j) {
      const std::string joint = "joint/" + recorded().arm().joints[j].name;
      EXPECT_NEAR(replay.q[j].at(i), table.number(row, table.column(joint + "/position")),
                  half_step(replay.q[j]));
    }
    EXPECT_NEAR(replay.target[1].at(i), table.number(row, table.column("target/position/y")),
                half_step(replay.target[1]));
  }
}

TEST(Recording, TheReplaysVelocityRatiosMissNoPeak) {
  const CsvTable& table = recorded().table;
  const auto run = whole_run();
  const auto time = table.numbers(table.column("time"));
  for (std::size_t j = 0; j < run.replay.velocity_ratio.size(); ++j) {
    const Series& shown = run.replay.velocity_ratio[j];
    const auto ratio =
        table.numbers(table.column("joint/" + recorded().arm().joints[j].name + "/velocity_ratio"));
    EXPECT_EQ(shown.hi, *std::max_element(ratio.begin(), ratio.end()));
    for (std::size_t r = 0; r < time.size(); ++r) {
      // Of the samples on both sides of a row, one is no more than dt / 2 away and shows no less.
      const double at = time[r] / run.replay.dt;
      const std::size_t before = std::min(static_cast<std::size_t>(at), run.replay.n - 1);
      const std::size_t after = std::min(before + 1, run.replay.n - 1);
      EXPECT_GE(std::max(shown.at(before), shown.at(after)), ratio[r] - half_step(shown)) << time[r];
    }
  }
}

TEST(Recording, ThePagesKinematicsPutTheToolWhereItWas) {
  const auto run = whole_run();
  const Arm& arm = recorded().arm();
  // Each joint is half a step of 6 rad / 65534 off at most, on a reach of 1.3 m; six of them, and the tool's
  // own half step: below 0.5 mm.
  for (std::size_t i = 0; i < run.replay.n; i += 7) {
    std::vector<double> q;
    for (const Series& joint : run.replay.q) q.push_back(joint.at(i));
    const Eigen::Isometry3d last = test::frames(arm, q).back();
    const Vec3 tool = last * arm.tool.p;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(tool[axis], run.replay.tool[static_cast<std::size_t>(axis)].at(i), 5e-4) << i;
    }
  }
}

TEST(Recording, ObstaclesAreAsFarFromJointsAndToolAsTheRolloutSaw) {
  // Of every period: the column is the least since the previous row.
  const CsvTable table = test::recording_of(recorded().scenario, recorded().gains, 1);
  const auto run = run_of(table, &recorded().shown(), &recorded().arm(), {});
  const Arm& arm = recorded().arm();
  ASSERT_FALSE(run.replay.obstacles.empty());
  for (std::size_t i = 0; i < run.replay.n; i += 5) {
    std::vector<double> q;
    for (const Series& joint : run.replay.q) q.push_back(joint.at(i));
    const auto frames = test::frames(arm, q);
    std::vector<Vec3> points = {frames.back() * arm.tool.p};
    for (const Eigen::Isometry3d& frame : frames) points.emplace_back(frame.translation());
    double nearest = INFINITY;
    for (const Vec3& point : points) {
      for (const auto& center : run.replay.obstacles) {
        const Vec3 p(center[0].at(i), center[1].at(i), center[2].at(i));
        nearest = std::min(nearest, (point - p).norm());
      }
    }
    const std::size_t row = row_at(table, static_cast<double>(i) * run.replay.dt);
    // As above, and a millimetre of obstacle within its own steps.
    EXPECT_NEAR(nearest, table.number(row, table.column("obstacle/distance")), 1e-3) << i;
  }
}

TEST(Recording, StatesAndSlerpsBeginAndEndWithTheirRows) {
  const CsvTable& table = recorded().table;
  const auto run = whole_run();
  const auto time = table.numbers(table.column("time"));
  ASSERT_FALSE(run.states.empty());
  EXPECT_EQ(run.states.front().time, time.front());
  const auto state = [&run](double t) {
    int now = -1;
    for (const StateChange& change : run.states) {
      if (change.time <= t) now = change.state;
    }
    return now;
  };
  for (std::size_t r = 0; r < time.size(); ++r) {
    EXPECT_EQ(state(time[r]), static_cast<int>(table.number(r, table.column("state")))) << time[r];
  }
  for (std::size_t i = 1; i < run.states.size(); ++i) EXPECT_NE(run.states[i].state, run.states[i - 1].state);
}

TEST(Recording, SlerpsAreTheTimesInWhichTheColumnIsOne) {
  const std::string header =
      "time,state,slerping,tool/position/x,error/position/x,error/position/y,error/position/z\n";
  std::string rows;
  const int slerping[] = {0, 1, 1, 0, 0, 1, 0, 1};
  for (int i = 0; i < 8; ++i) rows += std::to_string(i) + ",2," + std::to_string(slerping[i]) + ",0,0,0,0\n";
  const auto run = run_of(CsvTable::parse(header + rows, "t"), nullptr, nullptr, {});
  const std::vector<std::pair<double, double>> expected = {{1, 3}, {5, 6}, {7, 7}};
  EXPECT_EQ(run.slerps, expected);
  EXPECT_EQ(run.replay.n, 0U) << "without a scene there is nothing to replay";
}

TEST(Recording, PlotsHaveEveryGroupWithExtremesOfTheWholeColumn) {
  const CsvTable& table = recorded().table;
  Resolution coarse;
  coarse.buckets = 50;
  const auto run = run_of(table, &recorded().shown(), &recorded().arm(), coarse);
  const char* groups[] = {"position", "position_error", "orientation_error", "linear_velocity_error",
                          "gaze",     "velocity_ratio", "torque_ratio",      "angular_velocity_error",
                          "theta",    "clearance",      "manipulability"};
  for (const char* group : groups) {
    EXPECT_TRUE(std::any_of(run.columns.begin(), run.columns.end(), [group](const PlotColumn& c) {
      return c.group == group;
    })) << group;
  }
  EXPECT_EQ(run.time.steps.size(), 100U);
  for (const PlotColumn& column : run.columns) {
    EXPECT_EQ(column.series.steps.size(), run.time.steps.size()) << column.name;
    const auto c = table.find(column.name);
    if (!c) continue;                                 // made from others
    if (column.name.starts_with("error/")) continue;  // have gaps
    const auto values = table.numbers(*c);
    EXPECT_EQ(column.series.lo, *std::min_element(values.begin(), values.end())) << column.name;
    EXPECT_EQ(column.series.hi, *std::max_element(values.begin(), values.end())) << column.name;
  }
}

TEST(Recording, ARunThatBeginsWithAPlanCountsItsTimeFromThereAndShowsJointErrors) {
  Scenario scenario = test::scenario_of("moving_target", 0.2);
  const int n = scenario.robot->n();
  const JointVector zero = JointVector::Zero(n);
  const MotionPoint<JointVector> still{scenario.start_position, zero, zero};
  scenario.planned = std::make_shared<const JointSpline>(std::vector{8.0, 9.0},
                                                         std::vector<MotionPoint<JointVector>>{still, still});
  scenario.start_time = 8.0;
  const Gains gains = test::published_gains(scenario);
  const Scene scene = scene_of({scenario}, {{"gains", ".", "errors.csv"}}, gains.obstacleInfluenceRadius);
  const CsvTable table = test::recording_of(scenario, gains, 5);
  const auto run = run_of(table, &scene.scenarios.front(), &scene.arms.front(), {});
  EXPECT_EQ(run.start, 8.0);
  EXPECT_NEAR(run.end, 0.19, 1e-9);
  EXPECT_EQ(run.time.lo, 0.0);
  ASSERT_EQ(run.states.size(), 1U);
  EXPECT_EQ(run.states[0].time, 0.0);
  EXPECT_EQ(run.states[0].state, static_cast<int>(ControlState::kFollowPlan));
  EXPECT_EQ(std::count_if(run.columns.begin(), run.columns.end(),
                          [](const PlotColumn& c) { return c.group == "joint_error"; }),
            n);
  EXPECT_EQ(run.replay.target[0].at(0), table.number(0, table.column("target/position/x")));
}

/// The recording without the columns whose names end so, as an older armtune wrote it.
CsvTable without(const std::string& ending) {
  const CsvTable& table = recorded().table;
  std::string text;
  for (std::size_t r = 0; r <= table.rows(); ++r) {
    std::string row;
    for (std::size_t c = 0; c < table.header().size(); ++c) {
      if (table.header()[c].ends_with(ending)) continue;
      row += (row.empty() ? "" : ",") + (r == 0 ? table.header()[c] : table.text(r - 1, c));
    }
    text += row + '\n';
  }
  return CsvTable::parse(text, "old.csv");
}

TEST(Recording, TorquesAreSharesOfTheirLimitsAlsoOfFilesThatOnlyHaveTorques) {
  const auto run = whole_run();
  const auto old = run_of(without("/torque_ratio"), &recorded().shown(), &recorded().arm(), {});
  for (const JointInfo& joint : recorded().scenario.robot->joints) {
    const std::string name = "joint/" + joint.name + "/torque_ratio";
    const auto is_it = [&name](const PlotColumn& c) { return c.name == name; };
    const auto commanded = std::find_if(run.columns.begin(), run.columns.end(), is_it);
    const auto sent = std::find_if(old.columns.begin(), old.columns.end(), is_it);
    ASSERT_NE(commanded, run.columns.end());
    ASSERT_NE(sent, old.columns.end());
    EXPECT_LE(sent->series.hi, 1.0) << "what was sent is inside the limit";
    EXPECT_GE(commanded->series.hi, sent->series.hi);
  }
}

TEST(Recording, ErrorsHaveGapsWhereNothingTracksThem) {
  const CsvTable& table = recorded().table;
  Resolution fine;
  fine.buckets = table.rows();
  const auto run = run_of(table, &recorded().shown(), &recorded().arm(), fine);
  std::set<int> states;
  for (const PlotColumn& column : run.columns) {
    const bool position = column.group == "position_error";
    if (!column.name.starts_with("error/")) continue;
    for (std::size_t r = 0; r < table.rows(); ++r) {
      const auto state = static_cast<int>(table.number(r, table.column("state")));
      const bool tracked = state != 0 && !(position && state == 3);
      states.insert(state);
      ASSERT_EQ(std::isnan(column.series.at(r)), !tracked) << column.name << ", row " << r;
    }
  }
  EXPECT_TRUE(states.contains(0) && states.contains(3)) << "both kinds of gap are in it";
}

TEST(Recording, ResolutionFallsWithTheBytesOfARunAndNeverToNothing) {
  std::size_t buckets = 700;
  double rate = 25.0;
  for (const std::size_t bytes : {4'000'000U, 500'000U, 100'000U, 20'000U, 0U}) {
    const Resolution r = resolution_for(bytes, 34, 19, 60.0);
    EXPECT_LE(r.buckets, buckets);
    EXPECT_LE(r.replay_rate, rate);
    EXPECT_GE(r.buckets, 50U);
    EXPECT_GE(r.replay_rate * 60.0, 99.9) << "a hundred samples";
    buckets = r.buckets;
    rate = r.replay_rate;
  }
  EXPECT_EQ(resolution_for(500'000, 34, 19, 50.0).buckets, 700U) << "the bundled study is shown in full";
  EXPECT_EQ(resolution_for(500'000, 34, 19, 50.0).replay_rate, 25.0);
}

TEST(Recording, AnEmptyCellIsCalledThat) {
  const std::string header =
      "time,state,slerping,tool/position/x,error/position/x,error/position/y,error/position/z\n";
  for (const char* rows : {"0,1,0,0,0,0,0\n,1,0,0,0,0,0\n", "0,1,0,0,0,0,0\n1,,0,0,0,0,0\n"}) {
    const NumberTable table = CsvTable::parse(header + rows, "rollout.csv");
    const InputError error =
        test::input_error([&] { run_of(table, nullptr, nullptr, resolution_for(100'000, 4, 0, 1.0)); });
    EXPECT_THAT(error, test::refused_at({.file = "rollout.csv", .line = 3}));
    EXPECT_THAT(error.what(), testing::HasSubstr("an empty cell in the column '" + error.place().key));
  }
}

/// Text of a recording with these times, at rest.
CsvTable with_times(const std::string& cells) {
  std::string text = "time,state,slerping\n";
  std::istringstream words(cells);
  for (std::string time; words >> time;) text += (time == "-" ? "" : time) + ",2,0\n";
  return CsvTable::parse(text, "rollout_a.csv");
}

TEST(Recording, TimesThatAreMissingFallOrAreNoTimesAreRefusedWithTheirLine) {
  for (const auto& [times, line] :
       {std::pair{"- - -", 2L}, std::pair{"0 0.01 0.005", 4L}, std::pair{"-1e308 1e308", 2L}}) {
    const CsvTable table = with_times(times);
    EXPECT_THAT([&] { run_of(table, nullptr, nullptr, {}); },
                test::refused_at({.file = "rollout_a.csv", .line = line, .key = "time"}));
  }
  EXPECT_EQ(run_of(with_times("0.5 0.5 0.5"), nullptr, nullptr, {}).end, 0.0) << "they do not fall";
}

TEST(Recording, AStateThatIsNoneOfTheControllersIsRefusedWithItsLine) {
  for (const char* state : {"5", "-1", "1.5", "1e300", ""}) {
    const CsvTable table =
        CsvTable::parse(std::string("time,state,slerping\n0,2,0\n1,") + state + ",0\n", "rollout_a.csv");
    EXPECT_THAT([&] { run_of(table, nullptr, nullptr, {}); },
                test::refused_at({.file = "rollout_a.csv", .line = 3, .key = "state"}))
        << state;
  }
}

TEST(Recording, OfChangesInEveryRowKeepsTheLongestAndSaysSo) {
  std::string text = "time,state,slerping\n";
  for (int r = 0; r < 6000; ++r) text += std::to_string(r) + "," + std::to_string(r % 2 + 2) + ",0\n";
  for (int r = 6000; r < 8000; ++r) text += std::to_string(r) + ",1,0\n";
  const report::Run run = run_of(CsvTable::parse(text, "t"), nullptr, nullptr, {});
  EXPECT_LE(run.states.size(), 2000U);
  EXPECT_GT(run.shortest_state, 1.0);
  EXPECT_EQ(run.states.back().time, 6000.0);
  EXPECT_EQ(run.states.back().state, 1);
}

TEST(Recording, AReplayHasASampleWhateverTheTimes) {
  const CsvTable& whole = recorded().table;
  for (const double span : {0.0, 1e-9, 1e9}) {
    std::string text;
    for (std::size_t c = 0; c < whole.header().size(); ++c) text += (c > 0 ? "," : "") + whole.header()[c];
    for (std::size_t r = 0; r < 5; ++r) {
      text += '\n';
      for (std::size_t c = 0; c < whole.header().size(); ++c)
        text += (c > 0 ? "," : "") +
                (c == 0 ? std::to_string(span * static_cast<double>(r) / 4.0) : whole.text(r, c));
    }
    const report::Run run = run_of(CsvTable::parse(text + "\n", "t"), &recorded().shown(), &recorded().arm(),
                                   resolution_for(0, 34, 19, span));
    EXPECT_GE(run.replay.n, 1U) << span;
    EXPECT_TRUE(std::isfinite(run.replay.dt)) << span;
    for (const Series& q : run.replay.q) EXPECT_EQ(q.steps.size(), run.replay.n);
  }
}

}  // namespace recording_test
}  // namespace armtune::internal::report
