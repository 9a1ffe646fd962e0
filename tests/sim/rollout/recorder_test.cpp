#include "sim/rollout/recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/sim/support/csv.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace recorder_test {

using test::scenario_of;

struct Recorded {
  test::Csv csv{""};
  std::vector<JointVector> q;  ///< of every period
  Metrics metrics;
};

Recorded record(const Scenario& scenario, int stride) {
  const test::TemporaryFolder folder;
  Recorder recorder(scenario, stride);
  Recorded recorded;
  const auto observe = [&](const Observation& o) {
    recorded.q.push_back(*o.q);
    return recorder(o);
  };
  recorded.metrics =
      Rollout(scenario, Stepper::kMidpoint).run(test::published_gains(scenario), observe).metrics;
  recorder.write_csv(folder / "rollout.csv");
  recorded.csv = test::read_csv(folder / "rollout.csv");
  return recorded;
}

TEST(RolloutCsv, NamesAreUniqueTreesWithoutCommasBeginningWithTime) {
  for (const char* name : {"moving_target", "obstacle_pass"}) {
    const auto columns = rollout_columns(scenario_of(name));
    EXPECT_EQ(columns.front().name, "time");
    std::set<std::string> names;
    for (const Column& column : columns) {
      EXPECT_TRUE(names.insert(column.name).second) << column.name << " stands twice";
      EXPECT_EQ(column.name.find_first_of(",\" \n"), std::string::npos) << column.name;
      EXPECT_NE(column.unit, "") << column.name;
    }
    for (const std::string& other : names) {
      for (const std::string& leaf : names) {
        EXPECT_FALSE(other.starts_with(leaf + "/")) << leaf << " is a leaf and a branch";
      }
    }
    EXPECT_EQ(names.contains("obstacle/distance"), std::string(name) == "obstacle_pass");
    for (const char* needed :
         {"state", "tool/position/x", "desired/position/z", "error/position/x", "error/orientation/z",
          "error/linear_velocity/y", "error/angular_velocity/x", "joint/elbow_joint/position",
          "joint/elbow_joint/velocity", "joint/wrist_3_joint/velocity_ratio", "joint/wrist_3_joint/torque",
          "target/position/x", "manipulability", "gaze/angle"}) {
      EXPECT_TRUE(names.contains(needed)) << needed;
    }
  }
}

TEST(RolloutCsv, HasARowForEveryStrideWithRisingTimeAndTheTrueState) {
  for (const int stride : {1, 5, 7}) {
    const Scenario scenario = scenario_of("obstacle_pass", 0.5);
    const Recorded recorded = record(scenario, stride);
    const auto& csv = recorded.csv;
    ASSERT_EQ(csv.rows.size(), static_cast<std::size_t>((250 + stride - 1) / stride));
    double before = -1.0;
    for (std::size_t r = 0; r < csv.rows.size(); ++r) {
      ASSERT_EQ(csv.rows[r].size(), csv.header.size());
      const double time = std::stod(csv.at(r, "time"));
      EXPECT_GT(time, before);
      EXPECT_NEAR(time, 0.002 * stride * static_cast<double>(r), 1e-9);
      before = time;
      const JointVector& q = recorded.q[r * static_cast<std::size_t>(stride)];
      EXPECT_EQ(std::stod(csv.at(r, "joint/elbow_joint/position")), q[2]);
      EXPECT_EQ(csv.at(r, "state"), "0");
    }
  }
}

double largest(const test::Csv& csv, const std::string& ending) {
  double found = 0.0;
  for (const std::string& column : csv.header) {
    if (!column.ends_with(ending)) continue;
    for (std::size_t r = 0; r < csv.rows.size(); ++r) found = std::max(found, std::stod(csv.at(r, column)));
  }
  return found;
}

TEST(RolloutCsv, MissesNoPeakBetweenItsRows) {
  Scenario scenario = scenario_of("obstacle_pass", 9.0);
  const Recorded every = record(scenario, 1);
  const Recorded recorded = record(scenario, 40);
  const Metrics& m = recorded.metrics;
  EXPECT_DOUBLE_EQ(largest(recorded.csv, "/velocity_ratio"), m[Metric::kJointVelocityMaxRatio]);
  EXPECT_DOUBLE_EQ(largest(recorded.csv, "/torque_ratio"), m[Metric::kJointEffortMaxRatio]);
  double closest = INFINITY;
  for (std::size_t r = 0; r < recorded.csv.rows.size(); ++r) {
    closest = std::min(closest, std::stod(recorded.csv.at(r, "obstacle/distance")));
  }
  EXPECT_EQ(closest, m[Metric::kObstacleMinClearance]);
  for (const char* column : {"joint/elbow_joint/velocity_ratio", "joint/wrist_1_joint/torque_ratio"}) {
    for (std::size_t r = 1; r + 1 < recorded.csv.rows.size(); ++r) {
      double peak = 0.0;
      for (std::size_t k = 40 * (r - 1) + 1; k <= 40 * r; ++k) {
        peak = std::max(peak, std::stod(every.csv.at(k, column)));
      }
      ASSERT_EQ(std::stod(recorded.csv.at(r, column)), peak) << column << ", row " << r;
    }
  }
}

TEST(RolloutCsv, ReadsBackToTheBit) {
  const test::TemporaryFolder folder;
  const Scenario scenario = scenario_of("obstacle_pass", 0.5);
  Recorder recorder(scenario, 1);
  std::vector<double> seen;
  Rollout(scenario, Stepper::kMidpoint).run(test::published_gains(scenario), [&](const Observation& o) {
    for (const Column& column : recorder.columns()) seen.push_back(column.value(o));
    return recorder(o);
  });
  recorder.write_csv(folder / "rollout.csv");
  test::ReadBack read(test::read_text(folder / "rollout.csv"));
  const std::size_t width = recorder.columns().size();
  for (std::size_t i = 0; i < seen.size(); ++i)
    read.number(i / width, recorder.columns()[i % width].name, seen[i]);
  read.expect_all_seen(250);
}

TEST(RolloutCsv, IsEmptyWhereAFigureIsNotFinite) {
  const test::TemporaryFolder folder;
  Scenario scenario = scenario_of("obstacle_pass", 0.1);
  Recorder recorder(scenario, 1);
  Rollout(scenario, Stepper::kMidpoint).run(test::published_gains(scenario), [&](const Observation& o) {
    Observation without = o;
    without.gaze_angle = NAN;
    without.clearance = INFINITY;
    return recorder(without);
  });
  recorder.write_csv(folder / "rollout.csv");
  test::ReadBack read(test::read_text(folder / "rollout.csv"));
  ASSERT_EQ(read.table().rows(), 50U);
  for (std::size_t row = 0; row < 50; ++row) {
    read.text(row, "gaze/angle", "");
    read.text(row, "obstacle/distance", "");
    EXPECT_NE(read.table().text(row, read.table().column("time")), "");
  }
}

TEST(RolloutCsv, OfARunThatFailedEndsWithItsLastPeriod) {
  const test::TemporaryFolder folder;
  const Scenario scenario = scenario_of("moving_target", 0.1);
  Recorder recorder(scenario, 8);
  Rollout(scenario, Stepper::kMidpoint).run(test::published_gains(scenario), [&](const Observation& o) {
    return recorder(o);
  });
  recorder.write_csv(folder / "whole.csv");
  recorder.write_csv(folder / "failed.csv", false);
  const auto whole = test::read_csv(folder / "whole.csv");
  const auto failed = test::read_csv(folder / "failed.csv");
  ASSERT_EQ(whole.rows.size(), 7U) << "50 periods";
  ASSERT_EQ(failed.rows.size(), 8U);
  EXPECT_NEAR(std::stod(failed.at(7, "time")), 0.002 * 49, 1e-9);
}

TEST(RolloutCsv, IsRefusedWhereItCannotBeWritten) {
  const Recorder recorder(scenario_of("moving_target"), 1);
  EXPECT_THAT([&] { recorder.write_csv("/no/such/folder/rollout.csv"); },
              test::refused_at({.file = "/no/such/folder/rollout.csv"}));
}

}  // namespace recorder_test
}  // namespace armtune::internal
