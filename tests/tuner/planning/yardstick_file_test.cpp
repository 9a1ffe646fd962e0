#include "tuner/planning/yardstick/yardstick_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/csv/csv_table.hpp"
#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace yardstick_file_test {

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

TEST(YardstickCsv, ReadsBackToTheBitAndIsEmptyWithAStatus) {
  std::vector<Measure> all(6);
  for (std::size_t k = 0; k < all.size(); ++k) {
    Measure& m = all[k];
    m.scenario = k == 0 ? test::kAwkwardText : test::kFormula;
    m.held_back_by = k == 1 ? test::kAwkwardText : "";
    m.event.kind = static_cast<EventKind>(k % 3);
    m.event.time = test::awkward(k);
    m.event.reached = test::awkward(k + 1);
    m.limit = test::awkward(k + 3);
    m.clearance = k % 2 == 0 ? NAN : test::awkward(k + 2);
  }
  all[2].status = MeasureStatus::kInfeasible;
  all[2].limit = NAN;
  all[3].event.outcome = EventOutcome::kNotReached;
  all[3].event.reached = NAN;
  all[4].limit = 0.0;
  all[5].limit = INFINITY;
  all[5].event.reached = -INFINITY;
  test::ReadBack read(yardstick_csv(all));
  for (std::size_t row = 0; row < all.size(); ++row) {
    const Measure& m = all[row];
    read.text(row, "scenario", m.scenario);
    read.text(row, "event", name(m.event.kind));
    read.number(row, "time", m.event.time);
    read.text(row, "state", name(m.event.state));
    read.number(row, "reached", m.event.reached);
    read.number(row, "limit", m.limit);
    read.number(row, "ratio", m.ratio());
    read.text(row, "unit", unit(m.event.kind));
    read.text(row, "outcome", words(m.event.outcome));
    read.text(row, "held_back_by", m.held_back_by);
    read.number(row, "clearance", m.clearance);
    read.text(row, "status", words(m.status));
  }
  read.expect_all_seen(all.size());
  for (const std::size_t row : {2U, 3U, 4U, 5U}) read.text(row, "ratio", "");
}

}  // namespace yardstick_file_test
}  // namespace armtune::internal
