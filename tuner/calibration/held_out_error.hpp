#pragma once
// The position error of an arm on the held-out windows of logs, as a function of how far ahead it is
// simulated (the horizon).

#include <array>
#include <span>

#include "tuner/calibration/shooting_fit.hpp"
#include "tuner/validation/motion_validation.hpp"

namespace armtune::internal {

struct HeldOutError {
  /// RMS error of each joint at kReportedHorizons, horizons x n [rad, m]. NaN if no window reaches a horizon.
  Eigen::MatrixXd rms;
  std::array<long, kReportedHorizons.size()> windows{};  ///< number of windows that reach each horizon

  /// Returns the root of the mean square over all joints at a horizon, each relative to that of `other`.
  double ratio_to(const HeldOutError& other, std::size_t horizon) const;
};

/// Time at the beginning of a held-out window to which only the state is fitted [s]. Horizons count from its
/// end.
inline constexpr double kStartTime = 0.25;

/// Which windows of a log are simulated: those that calibrate() holds out, or all of them.
enum class HorizonPart { kHeldOut, kWhole };

/// Simulates an arm on logs that passed the checks of calibrate(). model: the robot file. noise (n): of the
/// encoders [rad, m].
HeldOutError horizon_error(const RobotModel& model, const ShootingArm& arm,
                           std::span<const CommandedLog> logs, const Eigen::VectorXd& noise,
                           HorizonPart part);

}  // namespace armtune::internal
