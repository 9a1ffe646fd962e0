#include "tuner/validation/horizon_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace armtune::internal {
namespace horizon_curve_test {

/// A window of one joint that accelerates with `a` from the velocity v, in simulation `scale` times as far.
WindowRun accelerating(double v, double a, double scale, int instants) {
  WindowRun run;
  run.start_velocity = JointVector::Constant(1, v);
  run.measured.resize(instants, 1);
  run.simulated.resize(instants, 1);
  for (int i = 0; i < instants; ++i) {
    const double t = i * kHorizonStep;
    run.time.push_back(t);
    const double moved = v * t + 0.5 * a * t * t;
    run.measured(i, 0) = 0.3 + moved;
    run.simulated(i, 0) = 0.3 + scale * moved;
  }
  return run;
}

TEST(HorizonCurve, ComparesWithPredictionsWithoutAModel) {
  const std::vector<WindowRun> runs = {accelerating(1.0, 2.0, 1.1, 6), accelerating(-1.0, -2.0, 1.1, 6)};
  const HorizonCurve curve = horizon_curve(runs, 0, 6);
  for (std::size_t h = 0; h < 6; ++h) {
    const double t = static_cast<double>(h) * kHorizonStep;
    EXPECT_NEAR(curve.stays[h], t + t * t, 1e-12);
    EXPECT_NEAR(curve.keeps_velocity[h], t * t, 1e-12);
    EXPECT_NEAR(curve.rms[h], 0.1 * (t + t * t), 1e-12);
    EXPECT_NEAR(curve.slope[h], h == 0 ? 0.0 : 0.1, 1e-9) << "the simulation moves further";
    EXPECT_EQ(curve.yardstick(h), std::min(curve.stays[h], curve.keeps_velocity[h]));
  }
  EXPECT_EQ(curve.rms[0], 0.0);
}

TEST(HorizonCurve, HasANegativeSlopeIfTheSimulationFallsShort) {
  const HorizonCurve curve = horizon_curve({accelerating(0.5, -0.2, 0.8, 6)}, 0, 6);
  for (std::size_t h = 1; h < 6; ++h) EXPECT_NEAR(curve.slope[h], -0.2, 1e-9);
}

TEST(HorizonCurve, CountsWindowsUpToTheirEnd) {
  const std::vector<WindowRun> runs = {accelerating(1.0, 0.0, 1.5, 6), accelerating(1.0, 0.0, 1.1, 3)};
  const HorizonCurve curve = horizon_curve(runs, 0, 8);
  EXPECT_NEAR(curve.rms[2], std::sqrt(0.5 * (0.25 + 0.01)) * 2 * kHorizonStep, 1e-12);
  EXPECT_NEAR(curve.rms[3], 0.5 * 3 * kHorizonStep, 1e-12) << "only the longer window reaches it";
  EXPECT_TRUE(std::isnan(curve.rms[6]));
}

}  // namespace horizon_curve_test
}  // namespace armtune::internal
