#include "tuner/trade_off/criterion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace criterion_test {

Evaluation evaluation(const std::vector<double>& values, Metric metric) {
  Evaluation e;
  e.objective = 0.7;
  for (const double v : values) {
    e.results.emplace_back();
    e.results.back().metrics[metric] = v;
  }
  return e;
}

TEST(Criterion, IsTheObjectiveOrAMetricsWorstOverTheScenarios) {
  std::vector<Scenario> scenarios(3);
  const Criterion objective = criterion_from_name("objective");
  EXPECT_EQ(value(objective, evaluation({1, 2, 3}, Metric::kGazeRms), scenarios), 0.7);
  const Criterion error = criterion_from_name("gaze/rms");
  EXPECT_EQ(value(error, evaluation({0.1, 0.3, 0.2}, Metric::kGazeRms), scenarios), 0.3);
  EXPECT_EQ(cost(error, evaluation({0.1, 0.3, 0.2}, Metric::kGazeRms), scenarios), 0.3);
  EXPECT_TRUE(std::isnan(value(error, evaluation({0.1, NAN, 0.2}, Metric::kGazeRms), scenarios)))
      << "a scenario that should have given it did not";
  const Criterion clearance = criterion_from_name("obstacle/min_clearance");
  const Evaluation near = evaluation({NAN, 0.2, 0.1}, Metric::kObstacleMinClearance);
  EXPECT_TRUE(std::isnan(value(clearance, near, scenarios))) << "no obstacle anywhere";
  scenarios[1].obstacles.resize(1);
  scenarios[2].obstacles.resize(1);
  EXPECT_EQ(value(clearance, near, scenarios), 0.1) << "of clearance less is worse";
  EXPECT_EQ(cost(clearance, near, scenarios), -0.1);
}

TEST(Criterion, OfAnotherNameIsRefusedWithAGuess) {
  const InputError error = test::input_error([] { criterion_from_name("gaze/rmz"); });
  EXPECT_THAT(error,
              test::refused_at({.value = "gaze/rmz", .limit = testing::StartsWith("one of: objective, ")}));
  EXPECT_EQ(test::suggested_by(error), "gaze/rms");
}

TEST(Criterion, WithoutADirectionIsRefused) {
  for (const Metric m : all_metrics()) {
    if (field(m).better != Better::kNeither) {
      EXPECT_EQ(criterion_from_name(name(m)).larger_is_better(), field(m).better == Better::kMore);
      continue;
    }
    EXPECT_THAT([m] { criterion_from_name(name(m)); },
                test::refused_at({.value = name(m),
                                  .limit = "a metric that is better the smaller (or the larger) it is"}));
  }
}

}  // namespace criterion_test
}  // namespace armtune::internal
