#include "tuner/calibration/calibration_windows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/core/support/refused_at.hpp"

namespace armtune::internal::calibration_windows_test {
namespace {

JointLog waves(double duration, double noise) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  JointLog log;
  log.source = "waves";
  const int samples = static_cast<int>(250.0 * duration);
  log.q.resize(samples, 2);
  for (int i = 0; i < samples; ++i) {
    const double t = i / 250.0;
    log.time.push_back(t);
    log.q.row(i) << std::sin(2.0 * t) + noise * normal(generator),
        std::cos(3.0 * t) + 3.0 * noise * normal(generator);
  }
  return log;
}

TEST(CalibrationWindows, NoWindowIsBothFittedAndHeldOut) {
  const JointLog log = waves(20.0, 1e-4);
  const WindowPlan plan = window_plan(log, {0.0, 20.0});
  std::vector<int> used(log.time.size(), 0);
  for (const LogWindow& w : plan.fitted)
    for (Eigen::Index i = w.first; i < w.first + w.count; ++i) ++used[static_cast<std::size_t>(i)];
  for (const LogWindow& w : plan.held_out)
    for (Eigen::Index i = w.first; i < w.first + w.count; ++i) ++used[static_cast<std::size_t>(i)];
  for (const int count : used) EXPECT_LE(count, 1);
  EXPECT_EQ(plan.held_out.size(), 2u);
}

TEST(CalibrationWindows, NoWindowSpansAGap) {
  JointLog log = waves(20.0, 1e-4);
  for (std::size_t i = 1000; i < log.time.size(); ++i) log.time[i] += 0.3;
  const WindowPlan plan = window_plan(log, {0.0, 21.0});
  for (const std::vector<LogWindow>* windows : {&plan.fitted, &plan.held_out})
    for (const LogWindow& w : *windows) EXPECT_FALSE(w.first < 1000 && w.first + w.count > 1000);
}

TEST(CalibrationWindows, WindowsLieWhereCommandsAreKnown) {
  const JointLog log = waves(20.0, 1e-4);
  const WindowPlan plan = window_plan(log, {3.0, 18.0});
  for (const LogWindow& w : plan.fitted) {
    EXPECT_GE(log.time[static_cast<std::size_t>(w.first)], 3.0);
    EXPECT_LE(log.time[static_cast<std::size_t>(w.first + w.count - 1)], 18.0);
  }
}

TEST(CalibrationWindows, ALogOfPiecesIsRefused) {
  JointLog log = waves(20.0, 1e-4);
  for (std::size_t i = 0; i < log.time.size(); ++i) log.time[i] += 0.5 * static_cast<double>(i / 15);
  EXPECT_THAT(
      [&] {
        return window_plan(log, {0.0, 1000.0});
      },
      (test::refused_at({.file = "waves", .key = "time"})));
}

TEST(EncoderNoise, IsFoundWithinTenPercentInAMovingJoint) {
  const JointLog log = waves(20.0, 1e-4);
  const Eigen::VectorXd noise = encoder_noise(log, 0.004);
  EXPECT_NEAR(noise[0], 1e-4, 1e-5);
  EXPECT_NEAR(noise[1], 3e-4, 3e-5);
}

}  // namespace
}  // namespace armtune::internal::calibration_windows_test
