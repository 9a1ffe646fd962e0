#include "tuner/planning/yardstick/yardstick_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/csv/csv_table.hpp"

namespace armtune {
namespace {

using testing::HasSubstr;

TEST(Yardstick, WritesARowAnEventAndLeavesEmptyWhatThereIsNot) {
  Measure solved;
  solved.scenario = "s";
  solved.event.time = 8.0;
  solved.event.reached = 1.5;
  solved.limit = 0.5;
  solved.clearance = 0.325;
  solved.status = MeasureStatus::kSolved;
  solved.held_back_by = "velocity of elbow_joint";
  Measure infeasible = solved;
  infeasible.status = MeasureStatus::kInfeasible;
  infeasible.limit = infeasible.clearance = NAN;
  infeasible.scenario = "with, comma";
  Measure missed = solved;
  missed.event.outcome = EventOutcome::kNotReached;
  missed.event.reached = NAN;
  missed.event.state = ControlState::kReturnToTrajectory;
  const std::string text = yardstick_csv({solved, infeasible, missed});
  EXPECT_THAT(
      text,
      HasSubstr("\ns,switch,8,followTrajectory,1.5,0.5,3,s,reached,velocity of elbow_joint,0.325,solved\n"));
  EXPECT_THAT(text, HasSubstr("\n\"with, comma\",switch,8,followTrajectory,1.5,,,s,reached,velocity of "
                              "elbow_joint,,infeasible\n"));
  EXPECT_THAT(text,
              HasSubstr("\ns,switch,8,returnToTrajectory,,0.5,,s,not before the next switch,velocity of "
                        "elbow_joint,0.325,solved\n"));
  // Every column is declared, and no row has another number of them.
  const auto table = CsvTable::parse(text, "yardstick.csv");
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.header().size(), yardstick_columns().size());
}

}  // namespace
}  // namespace armtune
