#include "sim/metrics/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace armtune::internal {
namespace metric_test {

TEST(Metric, NamesAreUniqueTreesWithoutCommasAndReadBack) {
  std::set<std::string> names;
  std::set<std::string> words;
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const MetricField& field = metric_fields()[i];
    const std::string name = field.name;
    EXPECT_TRUE(names.insert(name).second) << name << " stands twice";
    EXPECT_EQ(name.find_first_of(",\" \n"), std::string::npos) << name;
    EXPECT_NE(std::string(field.unit), "") << name;
    EXPECT_TRUE(words.insert(field.words).second) << field.words << " stands twice";
    EXPECT_NE(std::string(field.meaning), "") << name;
    EXPECT_EQ(metric_from_name(name), static_cast<Metric>(i));
  }
  EXPECT_EQ(metric_from_name("error/position"), std::nullopt);
}

TEST(Metric, TheSmallestOfSomethingIsBetterLargeAndALargestOrAMeanSmall) {
  // The direction is declared with the metric; here it is compared with what the name says.
  for (const Metric m : all_metrics()) {
    const std::string what = name(m);
    const std::string last = what.substr(what.rfind('/') + 1);
    if (last.starts_with("min_")) {
      EXPECT_EQ(field(m).better, Better::kMore) << what;
    }
    if (last == "max" || last == "rms" || last == "max_ratio" || last == "time") {
      EXPECT_EQ(field(m).better, Better::kLess) << what;
    }
    EXPECT_EQ(larger_is_better(m), field(m).better == Better::kMore) << what;
    // Without a direction there is no worse.
    EXPECT_FALSE(only_worsens(m) && field(m).better == Better::kNeither) << what;
  }
  EXPECT_EQ(field(Metric::kResponseBandwidth).better, Better::kMore);
  EXPECT_EQ(field(Metric::kSamples).better, Better::kMore);
  EXPECT_EQ(field(Metric::kJointVelocityMaxRatioTime).better, Better::kNeither);
}

TEST(Metric, HasNoValueUntilItGetsOne) {
  Metrics metrics;
  for (const double value : metrics.value) EXPECT_TRUE(std::isnan(value));
  metrics[Metric::kGazeRms] = 0.5;
  EXPECT_EQ(metrics.value[static_cast<std::size_t>(Metric::kGazeRms)], 0.5);
}

}  // namespace metric_test
}  // namespace armtune::internal
