#include "tuner/study/thresholds.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace armtune::internal {
namespace thresholds_test {

using testing::HasSubstr;

TEST(VerdictThresholds, ALoosenedOneIsNamedAndAStricterOneIsNot) {
  for (const ThresholdField& field : threshold_fields()) {
    VerdictThresholds thresholds;
    EXPECT_TRUE(loosened(thresholds).empty());
    const double usual = thresholds.*field.value;
    thresholds.*field.value = field.larger_is_stricter ? 0.5 * usual : 2.0 * usual;
    const auto sentences = loosened(thresholds);
    ASSERT_EQ(sentences.size(), 1U) << field.name;
    EXPECT_THAT(sentences.front(), HasSubstr(field.name));
    thresholds.*field.value = field.larger_is_stricter ? 2.0 * usual : 0.5 * usual;
    EXPECT_TRUE(loosened(thresholds).empty()) << field.name;
    EXPECT_GE(usual, field.least);
    EXPECT_LE(usual, field.most);
  }
}

}  // namespace thresholds_test
}  // namespace armtune::internal
