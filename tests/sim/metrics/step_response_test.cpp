#include "sim/metrics/step_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace armtune::internal {
namespace step_response_test {

constexpr double kPeriod = 0.002;
// What the sampling may cost. The chord between two samples is off by h^2/8 |y''| and |y''| <= wn^2; at the
// fastest wn, 40 rad/s, that is 8e-4 over a slope of at least 10 per second: 0.2 % of the rise time of 0.04
// s.
constexpr double kTolerance = 0.004;

/// Unit step response of wn^2 / (s^2 + 2 zeta wn s + wn^2).
double second_order(double wn, double zeta, double t) {
  if (zeta == 1.0) return 1.0 - (1.0 + wn * t) * std::exp(-wn * t);
  if (zeta > 1.0) {
    const double root = std::sqrt(zeta * zeta - 1.0);
    const double slow = wn * (zeta - root);
    const double fast = wn * (zeta + root);
    return 1.0 - (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow);
  }
  const double root = std::sqrt(1.0 - zeta * zeta);
  const double wd = wn * root;
  return 1.0 - std::exp(-zeta * wn * t) * (std::cos(wd * t) + zeta / root * std::sin(wd * t));
}

StepResponse seen(const std::function<double(double)>& y, double span) {
  StepResponse response(span);
  const long count = std::lround(span / kPeriod);
  for (long k = 0; k < count; ++k)
    response.add(static_cast<double>(k) * kPeriod, y(static_cast<double>(k) * kPeriod));
  return response;
}

/// First or last time in (0, span) at which `inside` changes, to the microsecond, without interpolating.
double first_time(const std::function<bool(double)>& holds, double span) {
  for (double t = 0.0; t < span; t += 1e-6) {
    if (holds(t)) return t;
  }
  return span;
}
double last_time(const std::function<bool(double)>& holds, double span) {
  for (double t = span; t > 0.0; t -= 1e-6) {
    if (holds(t)) return t;
  }
  return 0.0;
}

class SecondOrder : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(SecondOrder, RiseOvershootAndSettlingAreThoseOfTheFormula) {
  const double wn = GetParam().first;
  const double zeta = GetParam().second;
  const double span = 40.0 / wn;  // by then the slowest of them is within 1e-3 of its end
  const auto y = [wn, zeta](double t) { return second_order(wn, zeta, t); };
  const StepResponse response = seen(y, span);
  const double rise = first_time([&y](double t) { return y(t) >= 0.9; }, span) -
                      first_time([&y](double t) { return y(t) >= 0.1; }, span);
  EXPECT_NEAR(response.rise_time(), rise, kTolerance * rise);
  const double settling = last_time([&y](double t) { return std::abs(y(t) - 1.0) > 0.02; }, span);
  EXPECT_NEAR(response.settling_time(kPeriod), settling, kTolerance * settling);
  const double overshoot = zeta < 1.0 ? std::exp(-M_PI * zeta / std::sqrt(1.0 - zeta * zeta)) : 0.0;
  EXPECT_NEAR(response.overshoot(), overshoot, kTolerance * overshoot);
  EXPECT_LT(response.steady_state_error(), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(FrequenciesAndDampings, SecondOrder,
                         testing::Values(std::pair{10.0, 0.2}, std::pair{10.0, 0.4}, std::pair{10.0, 0.5},
                                         std::pair{10.0, 0.7}, std::pair{10.0, 0.9}, std::pair{10.0, 1.0},
                                         std::pair{10.0, 2.0}, std::pair{40.0, 0.3}, std::pair{40.0, 0.6},
                                         std::pair{3.0, 0.3}, std::pair{3.0, 0.8}));

TEST(StepResponse, TheSteadyStateErrorIsWhatIsMissingOfTheStepOrTooMuch) {
  for (const double gain : {0.95, 1.07}) {
    const StepResponse response = seen([gain](double t) { return gain * second_order(10.0, 0.7, t); }, 4.0);
    EXPECT_NEAR(response.steady_state_error(), std::abs(1.0 - gain), 1e-6) << gain;
    EXPECT_NEAR(response.settling_time(kPeriod), 4.0, 1e-9) << "never within 2 % for good: the whole time";
    EXPECT_GT(response.rise_time(), 0.0);
  }
  const StepResponse low = seen([](double t) { return 0.85 * second_order(10.0, 1.0, t); }, 4.0);
  EXPECT_TRUE(std::isnan(low.rise_time())) << "it never came to 90 %";
  EXPECT_EQ(low.overshoot(), 0.0);
  EXPECT_NEAR(low.steady_state_error(), 0.15, 1e-6);
}

TEST(StepResponse, TheSteadyStateErrorIsAMeanOverTheLastTenth) {
  // Wrong all the time before, then 0.1 to either side for equally long.
  const StepResponse response = seen(
      [](double t) {
        if (t < 8.999) return 0.0;
        return t < 9.499 ? 1.1 : 0.9;
      },
      10.0);
  EXPECT_NEAR(response.steady_state_error(), 0.0, 1e-9);
}

TEST(StepResponse, SettledMeansForGood) {
  const auto y = [](double t) { return t < 1.0 || (t > 2.0 && t < 2.5) ? 0.9 : 1.0; };
  // The crossing lies in the period from 0.9 at 2.498 s to 1 at 2.5 s, at 0.98 of the step.
  EXPECT_NEAR(seen(y, 5.0).settling_time(kPeriod), 2.498 + 0.8 * kPeriod, 1e-9);
}

TEST(StepResponse, ItSettlesFromAboveAtTheUpperEdge) {
  const auto y = [](double t) { return t < 1.0 ? 1.1 : 1.0; };
  EXPECT_NEAR(seen(y, 5.0).settling_time(kPeriod), 0.998 + 0.8 * kPeriod, 1e-9);
}

TEST(StepResponse, WithoutSamplesNothingHasAValue) {
  const StepResponse response(1.0);
  EXPECT_TRUE(std::isnan(response.rise_time()));
  EXPECT_TRUE(std::isnan(response.overshoot()));
  EXPECT_TRUE(std::isnan(response.settling_time(kPeriod)));
  EXPECT_TRUE(std::isnan(response.steady_state_error()));
}

}  // namespace step_response_test
}  // namespace armtune::internal
