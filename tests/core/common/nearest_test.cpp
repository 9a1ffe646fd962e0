#include "core/common/nearest.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace armtune::internal {
namespace nearest_test {

const std::vector<std::string> kKeys = {"duration", "damping", "payload", "kp", "kd"};

TEST(Nearest, FindsAWordWithOneLetterTooMany) {
  EXPECT_EQ(nearest("durration", kKeys), "duration");
}
TEST(Nearest, FindsAWordWithOneLetterMissing) {
  EXPECT_EQ(nearest("payoad", kKeys), "payload");
}
TEST(Nearest, FindsAWordWithOneWrongLetter) {
  EXPECT_EQ(nearest("dumping", kKeys), "damping");
}
TEST(Nearest, IgnoresCase) {
  EXPECT_EQ(nearest("DURATION", kKeys), "duration");
}

TEST(Nearest, CountsASwapOfNeighboursAsOneEdit) {
  // As two substitutions, "bac" would only tie with "abxxc" and lose by order.
  const std::vector<std::string> candidates = {"abxxc", "bac"};
  EXPECT_EQ(nearest("abc", candidates), "bac");
}

TEST(Nearest, PrefersTheFirstOfEquallyCloseWords) {
  const std::vector<std::string> candidates = {"kd", "kp"};
  EXPECT_EQ(nearest("ki", candidates), "kd");
}

TEST(Nearest, PrefersAnExactMatchOverAnEarlierCloseOne) {
  EXPECT_EQ(nearest("kd", kKeys), "kd");
}

TEST(Nearest, IsEmptyWhenNothingIsClose) {
  EXPECT_EQ(nearest("gravity", kKeys), "");
}

TEST(Nearest, AllowsTwoEditsInAShortWordAndNotThree) {
  const std::vector<std::string> candidates = {"target"};
  EXPECT_EQ(nearest("tarxxt", candidates), "target");
  EXPECT_EQ(nearest("taxxxt", candidates), "");
}

TEST(Nearest, AllowsAThirdOfTheLettersInALongWord) {
  const std::vector<std::string> candidates = {"orientation_tolerance"};  // 21 letters: 7 edits
  EXPECT_EQ(nearest("xxxxxxxtion_tolerance", candidates), "orientation_tolerance");
  EXPECT_EQ(nearest("xxxxxxxxion_tolerance", candidates), "");
}

TEST(Nearest, DoesNotOfferAWordWithNoLetterInPlace) {
  EXPECT_EQ(nearest("x", kKeys), "");
}

TEST(Nearest, OfNothingIsNothing) {
  EXPECT_EQ(nearest("kp", {}), "");
  EXPECT_EQ(nearest("", kKeys), "");
}

TEST(Suggestion, EndsAMessage) {
  EXPECT_EQ(suggestion("durration", kKeys), " (did you mean 'duration'?)");
}
TEST(Suggestion, IsEmptyWhenNothingIsClose) {
  EXPECT_EQ(suggestion("gravity", kKeys), "");
}

}  // namespace nearest_test
}  // namespace armtune::internal
