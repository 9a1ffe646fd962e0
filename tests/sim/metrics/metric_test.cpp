#include "sim/metrics/metric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace armtune {
namespace {

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

TEST(Metric, HasNoValueUntilItGetsOne) {
  Metrics metrics;
  for (const double value : metrics.value) EXPECT_TRUE(std::isnan(value));
  metrics[Metric::kGazeRms] = 0.5;
  EXPECT_EQ(metrics.value[static_cast<std::size_t>(Metric::kGazeRms)], 0.5);
}

}  // namespace
}  // namespace armtune
