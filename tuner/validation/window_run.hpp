#pragma once
// Simulates one window of a log in core's own dynamics, from its logged state and under its logged commands.

#include <memory>

#include "sim/plant/plant.hpp"
#include "tuner/validation/command_follower.hpp"
#include "tuner/validation/motion_windows.hpp"

namespace armtune::internal {

/// Time between the instants at which positions are compared [s]. The reported horizons are multiples of it.
inline constexpr double kHorizonStep = 0.02;

/// Returns the number of instants in a window of this duration [s], its start included.
inline std::size_t horizon_count(double duration) {
  return static_cast<std::size_t>(duration / kHorizonStep + 1e-6) + 1;
}

/// Measured and simulated positions of a window at K instants: the steps of the simulation that are nearest
/// to multiples of kHorizonStep. The first one is the start.
struct WindowRun {
  double begin = 0.0;                   ///< time of the start [s]
  std::vector<double> time;             ///< K, since the start [s]
  Eigen::MatrixXd measured, simulated;  ///< K x n [rad, m]
  JointVector start_velocity;           ///< n
  double failed_at = -1.0;  ///< when the simulation diverged, after the start [s]; below zero: not
  int limit_joint = -1;     ///< the first joint whose simulated position left its limits; -1: none
  double limit_at = -1.0;   ///< when, after the start [s]
};

/// Simulates windows of one model under one kind of commands. All references must outlive the object.
class WindowSimulator {
 public:
  WindowSimulator(const RobotModel& model, const MotionCommands& commands);
  /// The result ends before the instant at which the simulation diverges, if it does. It contains the start.
  WindowRun run(const MotionStretch& stretch, const WindowPlace& place);

 private:
  const RobotModel& model_;
  const MotionCommands& commands_;
  std::unique_ptr<Plant> plant_;
  std::unique_ptr<CommandFollower> follower_;
  double sample_period_ = 0.0;  ///< for which the follower was made
};

}  // namespace armtune::internal
