#pragma once
// Simulates the joint sensors. They add white Gaussian noise to joint positions and velocities, and positions
// can have constant offsets. The noise is drawn from a seeded generator in each control period and, if the
// robot has drives, in each period of its drives.

#include <cstdint>
#include <random>

#include "core/control/laws/controller.hpp"

namespace armtune::internal {

class Sensors {
 public:
  /// position_noise, velocity_noise: standard deviations [rad, m] and [rad/s, m/s]. For a standard deviation
  /// of zero no random numbers are drawn. offset: true minus measured positions (n or empty) [rad, m].
  Sensors(double position_noise, double velocity_noise, std::uint64_t seed, const JointVector& offset = {})
      : position_noise_(position_noise), velocity_noise_(velocity_noise), offset_(offset), generator_(seed) {}

  /// True if the measured state is the true state.
  bool exact() const { return position_noise_ <= 0.0 && velocity_noise_ <= 0.0 && offset_.size() == 0; }

  void measure(const JointVector& q, const JointVector& qd, JointState& measured) {
    measured.q = q;
    if (offset_.size() > 0) measured.q -= offset_;
    measured.qd = qd;
    add(position_noise_, measured.q);
    add(velocity_noise_, measured.qd);
  }

 private:
  void add(double deviation, JointVector& value) {
    if (deviation <= 0.0) return;
    for (double& x : value) x += deviation * normal_(generator_);
  }

  double position_noise_;
  double velocity_noise_;
  JointVector offset_;
  std::mt19937_64 generator_;
  std::normal_distribution<double> normal_;
};

}  // namespace armtune::internal
