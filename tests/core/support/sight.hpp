#pragma once
// A tool that does not point at its target.

#include <cmath>
#include <random>

#include "core/control/gains.hpp"
#include "core/robot/kinematics.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal::test {

inline Gains gains_for_gaze() {
  Gains gains;
  gains.slerpAngularErrorThreshold = 0.15;
  gains.slerpDurationErrorGain = 2.5;
  return gains;
}

/// A tool whose z axis is `angle` away from the line to the target.
struct Sight {
  Poses poses;
  Eigen::Quaterniond Q_0T;
  Vec3 p_0G;
  double angle;
};

inline Sight sight(std::mt19937& generator, double angle) {
  Sight s;
  s.angle = angle;
  s.Q_0T = random_orientation(generator);
  s.poses.R_0T = s.Q_0T.toRotationMatrix();
  s.poses.p_0T = random_vec3(generator, 1.0);
  const Vec3 axis = s.poses.R_0T * Vec3(std::cos(1.0), std::sin(1.0), 0.0);  // perpendicular to z
  s.p_0G = s.poses.p_0T + 0.8 * (Eigen::AngleAxisd(angle, axis) * s.poses.R_0T.col(2));
  return s;
}

}  // namespace armtune::internal::test
