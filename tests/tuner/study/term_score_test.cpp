#include "tuner/study/term_score.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace armtune::internal {
namespace term_score_test {

const std::vector<double> kReferences = {1e-4, 0.3, 1.0, 250.0};

std::vector<Metric> goals() {
  std::vector<Metric> found;
  for (const Metric m : all_metrics()) {
    if (field(m).better != Better::kNeither) found.push_back(m);
  }
  return found;
}

TEST(TermScore, OfTheReferenceIsOne) {
  for (const Metric m : goals()) {
    for (const double reference : kReferences) EXPECT_EQ(term_score(m, reference, reference), 1.0) << name(m);
  }
}

TEST(TermScore, ABetterValueInTheDeclaredDirectionNeverScoresWorse) {
  // From ten references below zero, where a margin or a clearance can be, to beyond every cap. What less is
  // better of is never negative.
  for (const Metric m : goals()) {
    const bool more = field(m).better == Better::kMore;
    for (const double reference : kReferences) {
      for (int k = more ? -1000 : 0; k < 3000; ++k) {
        const double low = reference * 0.01 * k;
        const double high = reference * 0.01 * (k + 1);
        const double better = term_score(m, more ? high : low, reference);
        const double worse = term_score(m, more ? low : high, reference);
        EXPECT_LE(better, worse) << name(m) << " " << low << " of " << reference;
        if (more || k + 1 < 1000) {
          EXPECT_LT(better, worse) << name(m) << " " << low << " of " << reference;
        }
      }
    }
  }
}

TEST(TermScore, IsFiniteAndWithinZeroAndTenWhateverTheValue) {
  for (const Metric m : goals()) {
    for (const double value : {0.0, 1e-308, 1e-9, 1.0, 1e9, 1e308, -1e-308, -1.0, -1e308}) {
      if (value < 0.0 && field(m).better == Better::kLess) continue;
      const double score = term_score(m, value, 1e-3);
      EXPECT_GE(score, 0.0) << name(m) << " " << value;
      EXPECT_LE(score, kLargestRatio) << name(m) << " " << value;
    }
  }
}

TEST(TermScore, WhereLessIsBetterIsTheRatioUpToTen) {
  for (const Metric m : goals()) {
    if (field(m).better != Better::kLess) continue;
    for (const double reference : kReferences) {
      for (const double value : {0.0, 1e-7, 0.01, 0.7, 3.0, 1e5})
        EXPECT_EQ(term_score(m, value, reference), std::min(value / reference, 10.0)) << name(m);
    }
  }
}

TEST(TermScore, SoManyTimesTheBandwidthIsWorthAsMuchAsThatFractionOfAnError) {
  for (const double factor : {0.25, 0.5, 0.9, 1.0, 1.3, 4.0, 100.0}) {
    EXPECT_DOUBLE_EQ(term_score(Metric::kResponseBandwidth, factor * 5.0, 5.0),
                     term_score(Metric::kPositionMax, 0.002 / factor, 0.002));
  }
}

TEST(TermScore, WhereMoreIsBetterIsSmoothWhereItsTwoBranchesMeet) {
  const auto at = [](double r) { return term_score(Metric::kObstacleMinClearance, r, 1.0); };
  constexpr double kMeet = 0.2;
  EXPECT_NEAR(at(kMeet), 5.0, 1e-14);
  for (const double h : {1e-3, 1e-2, 0.1}) {
    // Point reflection: both branches go through (1/5, 5) with the same slope of -25.
    EXPECT_NEAR(at(kMeet - h) + at(kMeet + h), 10.0, 1e-13) << h;
  }
  // Curvatures of +-250 leave 125 steps of difference.
  constexpr double kStep = 1e-6;
  EXPECT_NEAR((at(kMeet + kStep) - at(kMeet - kStep)) / (2.0 * kStep), -25.0, 130.0 * kStep);
}

TEST(TermScore, ItsSlopeIsTheDerivative) {
  for (const Metric m : goals()) {
    const bool more = field(m).better == Better::kMore;
    for (const double reference : kReferences) {
      for (const double r : {-3.0, 0.0, 0.1, 0.3, 1.0, 4.0, 9.0, 12.0}) {
        if (!more && r < 0.0) continue;
        const double h = 1e-5 * reference;
        const double slope =
            (term_score(m, r * reference + h, reference) - term_score(m, r * reference - h, reference)) /
            (2.0 * h);
        // Central differences of 1/s are wrong by h^2/s^4, where s is at least 0.2 here.
        EXPECT_NEAR(term_slope(m, r * reference, reference), slope, 1e-6 / reference) << name(m) << " " << r;
        if (more) {
          EXPECT_LT(slope, 0.0);
        }
      }
    }
  }
}

}  // namespace term_score_test
}  // namespace armtune::internal
