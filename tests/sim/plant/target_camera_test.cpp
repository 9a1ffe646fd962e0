#include "sim/plant/target_camera.hpp"

#include <gtest/gtest.h>

#include "sim/metrics/accumulator.hpp"

namespace armtune::internal {
namespace target_camera_test {

Scenario two_targets() {
  Scenario scenario;
  scenario.control_period = 0.002;
  scenario.seed = 7;
  const HarmonicTerm circle{1, Vec3(0.2, 0.0, 0.0), Vec3(0.0, 0.2, 0.0)};
  scenario.targets = {{"one", {Vec3(1, 0, 0), 0.7, 0.0, {circle}}},
                      {"two", {Vec3(0, 1, 0), 1.1, 0.5, {circle}}}};
  return scenario;
}

TEST(TargetCamera, WithoutOneTheTrueMotionIsKnown) {
  const Scenario scenario = two_targets();
  TargetCamera camera(scenario);
  const MotionPoint<Vec3> truth = scenario.targets[0].path.at(1.0);
  const MotionPoint<Vec3> seen = camera.see(0, truth, 1.0);
  EXPECT_EQ(seen.position, truth.position);
  EXPECT_EQ(seen.velocity, truth.velocity);
  EXPECT_EQ(seen.acceleration, truth.acceleration);
}

TEST(TargetCamera, WithoutNoiseItsLagIsThatOfAChangingAccelerationOnly) {
  Scenario scenario = two_targets();
  scenario.camera = Camera{0.0, 30.0};
  TargetCamera camera(scenario);
  Spread position, velocity;
  for (int k = 0; k < 5000; ++k) {
    const double t = k * scenario.control_period;
    // The other target becomes active after 5 s; its filter has been running all along.
    const std::size_t active = k < 2500 ? 0 : 1;
    const MotionPoint<Vec3> truth = scenario.targets[active].path.at(t);
    const MotionPoint<Vec3> seen = camera.see(active, truth, t);
    if (t < 1.0) continue;
    position.add((seen.position - truth.position).norm());
    velocity.add((seen.velocity - truth.velocity).norm());
  }
  // The steady error of such a filter is jerk / bandwidth^3 in position and 3 jerk / bandwidth^2 in velocity;
  // the largest jerk is 0.2 m 1.1^3 / s^3.
  const double jerk = 0.2 * 1.1 * 1.1 * 1.1;
  EXPECT_LT(position.max(), 1.1 * jerk / (30.0 * 30.0 * 30.0));
  EXPECT_LT(velocity.max(), 1.1 * 3.0 * jerk / (30.0 * 30.0));
  EXPECT_GT(velocity.max(), 0.5 * 3.0 * jerk / (30.0 * 30.0));
}

TEST(TargetCamera, NoiseFollowsFromTheSeedAlone) {
  Scenario scenario = two_targets();
  scenario.camera = Camera{0.01, 15.0};
  const auto after = [&scenario](int periods) {
    TargetCamera camera(scenario);
    MotionPoint<Vec3> seen;
    for (int k = 0; k < periods; ++k) {
      const double t = k * scenario.control_period;
      seen = camera.see(0, scenario.targets[0].path.at(t), t);
    }
    return seen.position;
  };
  const Vec3 once = after(500);
  EXPECT_EQ(after(500), once);
  scenario.seed = 8;
  EXPECT_NE(after(500), once);
}

}  // namespace target_camera_test
}  // namespace armtune::internal
