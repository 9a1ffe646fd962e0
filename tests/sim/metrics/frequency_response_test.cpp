#include "sim/metrics/frequency_response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/linear_system.hpp"

namespace armtune::internal {
namespace frequency_response_test {

constexpr double kPeriod = 0.002;

using Mat1 = Eigen::Matrix<double, 1, 1>;
using Mat2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;

/// The response of a system to the bundled sines, as a rollout takes it.
template <int N>
FrequencyResponse response_of(const Eigen::Matrix<double, N, N>& A, const Eigen::Matrix<double, N, 1>& b,
                              const Eigen::Matrix<double, N, 1>& c) {
  const Stimulus stimulus = test::bundled_sines();
  const auto& sines = std::get<Multisine>(stimulus.shape);
  FrequencyResponse response(sines.orders, sines.base_period);
  // The transients of a pole at 2 pi 0.5 Hz are exp(-31) after the base period that is let pass.
  test::drive<N>(
      A, b, c, [&stimulus, &sines](double t) { return stimulus.value(t + sines.from); }, kPeriod,
      sines.window_end() - sines.from,
      [&response, &sines](double t, double u, double y) {
        if (reached(t, sines.base_period)) response.add(t, u, y);
      });
  return response;
}

FrequencyResponse first_order(double corner) {
  const double w = 2.0 * M_PI * corner;
  return response_of<1>(Mat1(-w), Mat1(w), Mat1(1.0));
}

FrequencyResponse second_order(double natural, double zeta) {
  const double w = 2.0 * M_PI * natural;
  Mat2 A;
  A << 0.0, 1.0, -w * w, -2.0 * zeta * w;
  return response_of<2>(A, Vec2(0.0, w * w), Vec2(1.0, 0.0));
}

TEST(FrequencyResponse, GainAndPhaseAtEveryOrderAreThoseOfTheSystem) {
  const double corner = 2.0;
  const FrequencyResponse response = first_order(corner);
  const auto orders = std::get<Multisine>(test::bundled_sines().shape).orders;
  for (std::size_t i = 0; i < orders.size(); ++i) {
    const double f = orders[i] / 10.0;
    EXPECT_DOUBLE_EQ(response.frequency(i), f);
    const std::complex<double> expected = 1.0 / std::complex<double>(1.0, f / corner);
    // Runge-Kutta at 0.5 ms of a sine of 10 Hz: (63 * 5e-4)^4 = 1e-6.
    EXPECT_LT(std::abs(response.at(i) - expected), 1e-5) << f << " Hz";
  }
}

// Between orders k and k' the straight line in log-log is off by h^2/8 of the curve's second derivative, h =
// ln(k'/k) = 0.15 from order 6 on: 0.3 % in frequency for one pole, 0.6 % for two; the third to 1 Hz have
// wider gaps.
constexpr double kTolerance = 0.01;

TEST(FrequencyResponse, TheBandwidthOfAFirstOrderLowPassIsItsCorner) {
  for (const double corner : {0.65, 1.1, 1.7, 3.4, 8.3}) {
    EXPECT_NEAR(first_order(corner).bandwidth(), corner, kTolerance * corner);
  }
}

TEST(FrequencyResponse, TheBandwidthOfASecondOrderLowPassIsThatOfTheFormula) {
  for (const double natural : {1.0, 2.6, 5.1}) {
    for (const double zeta : {0.4, 0.7, 1.0}) {
      const double z2 = zeta * zeta;
      const double bandwidth =
          natural * std::sqrt(1.0 - 2.0 * z2 + std::sqrt(4.0 * z2 * z2 - 4.0 * z2 + 2.0));
      EXPECT_NEAR(second_order(natural, zeta).bandwidth(), bandwidth, kTolerance * bandwidth)
          << natural << " Hz, " << zeta;
    }
  }
}

/// Gains of one each at 1, 2, 4 .. Hz.
double bandwidth_of(const std::vector<double>& gains) {
  std::vector<int> orders;
  for (std::size_t i = 0; i < gains.size(); ++i) orders.push_back(1 << i);
  FrequencyResponse response(orders, 1.0);
  for (int k = 0; k < 1000; ++k) {
    const double t = k / 1000.0;
    double u = 0.0;
    double y = 7.0;  // a constant is no sine
    for (std::size_t i = 0; i < gains.size(); ++i) {
      u += std::sin(2.0 * M_PI * orders[i] * t);
      y -= gains[i] * std::cos(2.0 * M_PI * orders[i] * t);
    }
    response.add(t, u, y);
  }
  return response.bandwidth();
}

TEST(FrequencyResponse, TheBandwidthIsWhereTheGainFirstFallsThreeDecibels) {
  EXPECT_NEAR(bandwidth_of({1.0, 1.0, 0.5}), 2.0 * std::sqrt(2.0), 1e-9) << "half way in log-log";
  EXPECT_NEAR(bandwidth_of({1.0, 0.5, 1.0, 0.5}), std::sqrt(2.0), 1e-9) << "the first of two";
  EXPECT_NEAR(bandwidth_of({1.0, 2.0, 0.25}), 2.0 * std::pow(2.0, 0.5), 1e-9) << "behind a peak";
}

TEST(FrequencyResponse, AGainThatNeverFallsEndsAtTheHighestOrderAndALowOneAtTheLowest) {
  EXPECT_EQ(bandwidth_of({1.0, 1.2, 0.9}), 4.0);
  EXPECT_EQ(bandwidth_of({0.6, 0.5, 0.4}), 1.0);
  EXPECT_TRUE(std::isnan(FrequencyResponse({1, 2}, 1.0).bandwidth()));
}

}  // namespace frequency_response_test
}  // namespace armtune::internal
