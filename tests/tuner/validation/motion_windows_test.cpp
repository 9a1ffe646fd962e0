#include "tuner/validation/motion_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace motion_windows_test {

constexpr double kPeriod = 0.01;

/// A stretch with one joint at q = t^3 - t.
MotionStretch stretch_of(double begin, double duration) {
  MotionStretch stretch{begin, kPeriod, kPeriod, {}};
  for (int i = 0; i <= std::lround(duration / kPeriod); ++i) {
    FilteredMotion at;
    const double t = i * kPeriod;
    at.q = JointVector::Constant(1, t * t * t - t);
    stretch.instants.push_back(at);
  }
  return stretch;
}

MotionCommands commands_between(double begin, double end) {
  MotionCommands commands;
  for (double t = begin; t < end - 1e-9; t += kPeriod) commands.time.push_back(t);
  return commands;
}

std::vector<WindowPlace> places(const LoggedMotion& motion, const MotionCommands& commands) {
  return place_windows(motion, commands, ValidationThresholds{});
}

TEST(MotionWindows, OverlapByHalfAndStayInTheirStretch) {
  LoggedMotion motion;
  motion.stretches = {stretch_of(5.0, 10.0), stretch_of(20.0, 5.5)};
  const std::vector<WindowPlace> all = places(motion, commands_between(0.0, 100.0));
  ASSERT_EQ(all.size(), 9U + 4U);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const MotionStretch& stretch = motion.stretches[all[i].stretch];
    EXPECT_EQ(all[i].duration, kLongestWindow);
    const double end = static_cast<double>(all[i].first) * kPeriod + all[i].duration;
    EXPECT_LE(end, static_cast<double>(stretch.instants.size() - 1) * kPeriod + 1e-5);
    if (i > 0 && all[i].stretch == all[i - 1].stretch) {
      EXPECT_NEAR(static_cast<double>(all[i].first - all[i - 1].first) * kPeriod, 0.5 * kLongestWindow, 1e-9);
    }
  }
}

TEST(MotionWindows, LieWhereCommandsAreKnown) {
  LoggedMotion motion;
  motion.stretches = {stretch_of(0.0, 20.0)};
  MotionCommands commands = commands_between(3.0, 8.0);
  const MotionCommands later = commands_between(9.0, 10.5);
  commands.time.insert(commands.time.end(), later.time.begin(), later.time.end());
  const std::vector<WindowPlace> all = places(motion, commands);
  ASSERT_EQ(all.size(), 4U + 1U);
  EXPECT_EQ(all.front().first, 300U);
  EXPECT_EQ(all[3].first, 600U);
  EXPECT_EQ(all[4].first, 900U);
  EXPECT_NEAR(all[4].duration, 1.5, 1e-6);
  EXPECT_TRUE(places(motion, commands_between(30.0, 40.0)).empty());
  EXPECT_TRUE(places(motion, commands_between(3.0, 3.05)).empty()) << "shorter than the shortest horizon";
}

TEST(MotionWindows, AreSpreadOverLongLogs) {
  LoggedMotion motion;
  motion.stretches = {stretch_of(0.0, 300.0)};
  const std::vector<WindowPlace> all = places(motion, commands_between(0.0, 301.0));
  ASSERT_EQ(all.size(), kMostWindows);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double step = static_cast<double>(all[i].first - all[i - 1].first) * kPeriod;
    EXPECT_GE(step, 1.0 - 1e-9);
    EXPECT_LE(step, 2.0 + 1e-9);
  }
  EXPECT_GT(static_cast<double>(all.back().first) * kPeriod, 295.0);
}

TEST(PositionBetweenInstants, IsExactForCubics) {
  const MotionStretch stretch = stretch_of(7.0, 1.0);
  for (const double t : {0.0, 0.0034, 0.5, 0.5055, 0.9971, 1.0}) {
    EXPECT_NEAR(position_at(stretch, t)[0], t * t * t - t, 1e-12) << t;
  }
}

}  // namespace motion_windows_test
}  // namespace armtune::internal
