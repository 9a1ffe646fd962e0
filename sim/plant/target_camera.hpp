#pragma once
// Computes the motion of the gaze targets, at which the tool points, as the controller receives it. Without a
// camera it is the true motion. With a camera, a filter estimates it from the noisy positions that the camera
// measures.

#include <random>
#include <vector>

#include "core/trajectory/motion_filter.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

class TargetCamera {
 public:
  /// The scenario must outlive this object.
  explicit TargetCamera(const Scenario& scenario)
      : scenario_(scenario), generator_(scenario.seed ^ kStream), normal_(0.0, 1.0) {
    if (!scenario.camera) return;
    filters_.assign(scenario.targets.size(), {scenario.camera->bandwidth, scenario.control_period});
  }

  /// Returns the motion of the target `active` at `time` [s] as the controller receives it. truth: its true
  /// motion. Call it once per control period, because the filters of all targets are updated in every call.
  MotionPoint<Vec3> see(std::size_t active, const MotionPoint<Vec3>& truth, double time) {
    if (!scenario_.camera) return truth;
    MotionPoint<Vec3> seen = truth;
    for (std::size_t i = 0; i < filters_.size(); ++i) {
      Vec3 sample = i == active ? truth.position : scenario_.targets[i].path.at(time).position;
      for (double& x : sample) x += scenario_.camera->noise * normal_(generator_);
      const MotionPoint<Vec3>& estimate = filters_[i].update(sample);
      if (i == active) seen = estimate;
    }
    return seen;
  }

 private:
  /// Makes the noise of the camera independent of that of the joint sensors, which use the same seed.
  static constexpr std::uint64_t kStream = 0x63616d657261;

  const Scenario& scenario_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
  std::vector<MotionFilter> filters_;
};

}  // namespace armtune::internal
