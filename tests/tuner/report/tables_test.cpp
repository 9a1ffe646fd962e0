#include "tuner/report/tables.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tuner/report/support/two_sets.hpp"
#include "tuner/report/findings.hpp"

namespace armtune::internal::report {
namespace tables_test {

using test::errors_of;
using test::result_of;
using test::two_sets;
using testing::ElementsAre;

TEST(Tables, PutTheSetsOfAScenarioSideBySide) {
  const auto tables = two_sets();
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].scenario, "a");
  EXPECT_EQ(value_of(tables[0], Metric::kOrientationMax, 0), 0.4);
  EXPECT_EQ(value_of(tables[0], Metric::kOrientationMax, 1), 0.1);
  EXPECT_TRUE(std::isnan(value_of(tables[1], Metric::kPositionMax, 0))) << "no set has one in b: no row";
  for (const MetricRow& row : tables[1].rows) EXPECT_NE(row.metric, Metric::kPositionMax);
  EXPECT_TRUE(std::isnan(value_of(tables[0], Metric::kGazeRms, 0)));
  EXPECT_THAT(tables[1].status, ElementsAre("completed", "completed"));
}

TEST(Tables, KeepTheirColumnsWhereASetHasNoFile) {
  const auto tables = tables_of({std::nullopt, errors_of({result_of("a", {{Metric::kPositionMax, 1.0}})})});
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_TRUE(std::isnan(value_of(tables[0], Metric::kPositionMax, 0)));
  EXPECT_EQ(value_of(tables[0], Metric::kPositionMax, 1), 1.0);
  EXPECT_THAT(tables[0].status, ElementsAre("", "completed"));
}

TEST(Tables, HaveEveryMetricUntilAsked) {
  auto tables =
      tables_of({errors_of({result_of("a", {{Metric::kPositionXMax, 1.0}, {Metric::kPositionMax, 2.0}})})});
  EXPECT_EQ(value_of(tables[0], Metric::kPositionXMax, 0), 1.0) << "no headline";
  auto asked = tables;
  keep_rows(asked, {Metric::kPositionXMax});
  EXPECT_EQ(asked[0].rows.size(), 2U);
  keep_rows(tables, {});
  ASSERT_EQ(tables[0].rows.size(), 1U);
  EXPECT_EQ(tables[0].rows[0].metric, Metric::kPositionMax);
}

TEST(Changes, AreMeanRatiosOverTheTermsScenarios) {
  const auto tables = two_sets();
  const auto one = changes(tables, {{Metric::kOrientationMax, {"a"}}}, 1);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_DOUBLE_EQ(one[0].ratio, 0.1 / 0.4);
  const auto both = changes(tables, {{Metric::kOrientationMax, {}}}, 1);
  // Rounding of a logarithm and an exponential.
  EXPECT_NEAR(both[0].ratio, std::sqrt(0.1 / 0.4 * 0.1 / 0.9), 1e-14);
  EXPECT_TRUE(changes(tables, {{Metric::kGazeRms, {}}}, 1).empty()) << "there is no such value";
  EXPECT_THAT(both[0].scenarios, ElementsAre("a", "b"));
  EXPECT_THAT(one[0].scenarios, ElementsAre("a"));
}

TEST(Changes, PutTheBestFirstWhicheverDirectionIsBetter) {
  const auto found = changes(
      two_sets(),
      {{Metric::kEffortRateRms, {}}, {Metric::kObstacleMinClearance, {}}, {Metric::kOrientationMax, {}}}, 1);
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].metric, Metric::kOrientationMax);
  EXPECT_EQ(found[1].metric, Metric::kEffortRateRms) << "half as much again";
  EXPECT_EQ(found[2].metric, Metric::kObstacleMinClearance) << "half the clearance is twice as bad";
}

TEST(Changes, TheWorstStepIsOfOneScenarioNotOfTheirMean) {
  const auto worst =
      worst_step(two_sets(), {Metric::kJointVelocityMaxRatio, Metric::kObstacleMinClearance}, 1);
  ASSERT_TRUE(worst);
  EXPECT_EQ(worst->metric, Metric::kObstacleMinClearance) << "half of it is worse than 0.6 to 0.88";
  EXPECT_EQ(worst->scenario, "a");
  EXPECT_EQ(worst->before, 0.2);
  EXPECT_EQ(worst->after, 0.1);
  EXPECT_EQ(worst_step(two_sets(), {Metric::kJointVelocityMaxRatio}, 1)->scenario, "b") << "a got better";
  EXPECT_FALSE(worst_step(two_sets(), {Metric::kOrientationMax}, 1)) << "better in both";
}

}  // namespace tables_test
}  // namespace armtune::internal::report
