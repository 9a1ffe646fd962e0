// The time in which the gaze is on its target again after an event, computed by Reacquisition.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/metrics/accumulator.hpp"

namespace armtune::internal {
namespace reacquisition_test {

/// Feeds a window of one sample per second from an event at 0 s to its end.
double reacquisition(const std::vector<bool>& outside) {
  Reacquisition r;
  r.start(0.0);
  double t = 0.0;
  for (const bool sample : outside) r.add(t++, sample);
  return r.longest(t);
}

TEST(Reacquisition, IsZeroWhereTheGazeWasNeverLost) {
  EXPECT_EQ(reacquisition({false, false, false}), 0.0);
}
TEST(Reacquisition, LastsUntilTheGazeIsInside) {
  EXPECT_EQ(reacquisition({true, true, true, false, false}), 3.0);
}
TEST(Reacquisition, LastsUntilTheGazeIsInsideForGood) {
  EXPECT_EQ(reacquisition({true, false, false, true, false, false}), 4.0);
  EXPECT_EQ(reacquisition({false, false, true, false}), 3.0);
}
TEST(Reacquisition, IsTheWholeWindowIfTheGazeNeverSettles) {
  EXPECT_EQ(reacquisition({true, true, true}), 3.0);
  EXPECT_EQ(reacquisition({true, false, true}), 3.0);
}

TEST(Reacquisition, OfSeveralEventsTheLongestCounts) {
  Reacquisition r;
  r.add(0.0, true);  // before any event
  r.start(1.0);
  for (const double t : {1.0, 2.0, 3.0}) r.add(t, true);
  r.add(4.0, false);
  r.start(10.0);  // the second takes 2 s, not 3
  r.add(10.0, true);
  r.add(12.0, false);
  EXPECT_EQ(r.longest(20.0), 3.0);
}

TEST(Reacquisition, AnEventEndsTheWindowOfTheOneBefore) {
  Reacquisition r;
  r.start(0.0);
  r.add(0.0, true);
  r.start(5.0);  // never settled: 5 s
  r.add(5.0, true);
  r.add(6.0, false);
  EXPECT_EQ(r.longest(8.0), 5.0);
}

TEST(Reacquisition, HasNoValueWithoutAnEvent) {
  Reacquisition r;
  r.add(0.0, true);
  EXPECT_TRUE(std::isnan(r.longest(1.0)));
}

}  // namespace reacquisition_test
}  // namespace armtune::internal
