#pragma once
// Gaze orientation control (equation 7): below the angular threshold the goal orientation itself, above it a
// slerp whose parameter is a quintic over k_s times the angle.

#include "core/control/gains.hpp"
#include "core/robot/kinematics.hpp"
#include "core/trajectory/quintic.hpp"
#include "core/trajectory/slerp.hpp"

namespace armtune {

class GazeControl {
 public:
  struct Output {
    OrientationPoint desired;  ///< Qd, wd, wd'
    bool slerping = false;
  };

  /// Desired orientation at `time` [s] for the measured tool pose and the target's position p_0G [m].
  Output update(const Gains& gains, const Poses& poses, const Eigen::Quaterniond& Q_0T, const Vec3& p_0G,
                double time);

 private:
  bool slerping_ = false;
  double start_time_ = 0.0;
  Mat3 R_start_ = Mat3::Identity();
  Eigen::Quaterniond Q_start_ = Eigen::Quaterniond::Identity();
  Quintic<double> parameter_ = rest_to_rest(0.0, 1.0, 1.0);
};

}  // namespace armtune
