#include "tuner/identification/low_pass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "tuner/identification/moving_window.hpp"

namespace armtune::internal {
namespace low_pass_test {

constexpr double kPeriod = 0.002;
constexpr double kCutoff = 5.0;

double response(const LowPass& filter, const Eigen::VectorXd& weights, double frequency, bool odd) {
  double sum = 0.0;
  for (int k = 0; k < filter.length(); ++k) {
    const double angle = 2.0 * M_PI * frequency * (k - filter.half) * kPeriod;
    sum += weights[k] * (odd ? std::sin(angle) : std::cos(angle));
  }
  return sum;
}

TEST(LowPass, IsFlatBelowHalfTheCutoffAndSilentFromOneAndAHalf) {
  const LowPass filter = low_pass(kCutoff, kPeriod);
  EXPECT_NEAR(response(filter, filter.value, kCutoff, false), 0.5, 1e-3);
  for (double f = 0.0; f <= 0.5 * kCutoff; f += 0.1) {
    EXPECT_NEAR(response(filter, filter.value, f, false), 1.0, 1e-4) << f;
    // The derivatives of sin(w t) and cos(w t) at zero are w and -w^2.
    const double w = 2.0 * M_PI * f;
    EXPECT_NEAR(response(filter, filter.first, f, true), w, 1e-3 * w + 1e-12) << f;
    EXPECT_NEAR(response(filter, filter.second, f, false), -w * w, 1e-3 * w * w + 1e-12) << f;
  }
  for (double f = 1.5 * kCutoff; f <= 0.5 / kPeriod; f += 0.37) {
    EXPECT_NEAR(response(filter, filter.value, f, false), 0.0, 1e-4) << f;
  }
}

TEST(LowPass, HasNoPhase) {
  const LowPass filter = low_pass(kCutoff, kPeriod);
  EXPECT_LT((filter.value - filter.value.reverse()).norm(), 1e-15);
  EXPECT_LT((filter.first + filter.first.reverse()).norm(), 1e-12);
  EXPECT_LT((filter.second - filter.second.reverse()).norm(), 1e-9);
}

TEST(LowPass, IsExactOnCubicSignals) {
  const LowPass filter = low_pass(kCutoff, kPeriod);
  Eigen::VectorXd signal(filter.length());
  for (int k = 0; k < filter.length(); ++k) {
    const double t = (k - filter.half) * kPeriod;
    signal[k] = 0.7 - 0.3 * t + 1.1 * t * t;
  }
  EXPECT_NEAR(filter.first.dot(signal), -0.3, 1e-11);
  EXPECT_NEAR(filter.second.dot(signal), 2.2, 1e-9);
}

TEST(LowPass, ADelayGivesTheSignalOfSoMuchEarlier) {
  const double delay = 0.003;
  const LowPass filter = low_pass(20.0, kPeriod, delay);
  Eigen::VectorXd signal(filter.length());
  const auto wave = [](double t) { return std::sin(2.0 * M_PI * 2.0 * t + 0.4); };
  for (int k = 0; k < filter.length(); ++k) signal[k] = wave((k - filter.half) * kPeriod);
  EXPECT_NEAR(filter.value.dot(signal), wave(-delay), 1e-3);
  EXPECT_GT(std::abs(wave(-delay) - wave(0.0)), 0.02) << "or the line above says nothing";
}

TEST(MovingWindow, GivesWeightedSumsOfTheLastSamplesEverySoManySteps) {
  constexpr int kLength = 7;
  constexpr int kStep = 3;
  MovingWindow window(2, kLength, kStep);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(kLength, 1.0, 3.0);
  const auto sample = [](int k) { return Eigen::Vector2d(std::sin(0.3 * k), k * k); };
  for (int k = 0; k < 200; ++k) {
    const bool due = window.push(sample(k));
    EXPECT_EQ(due, k >= kLength - 1 && (k - kLength + 1) % kStep == 0) << k;
    if (!due) continue;
    Eigen::Vector2d expected = Eigen::Vector2d::Zero();
    for (int i = 0; i < kLength; ++i) expected += weights[i] * sample(k - kLength + 1 + i);
    EXPECT_LT((window.sum(weights, 0, 2) - expected).norm(), 1e-9) << k;
    EXPECT_EQ(window.sum(weights, 1, 1)[0], window.sum(weights, 0, 2)[1]);
  }
}

}  // namespace low_pass_test
}  // namespace armtune::internal
