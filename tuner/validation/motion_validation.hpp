#pragma once
// Answers whether a robot model predicts the motion of a log. The log is divided into windows. In each one
// the simulated arm starts from the logged state and is moved by the logged commands. The distance between
// simulated and logged positions, against the time since the start of the window, is the result:
//
//     const MotionValidation found = validate_motion(*load_robot("ur5e"), log, commands);
//     for (const std::string& sentence : sentences(found, model)) ...

#include <array>
#include <string>
#include <vector>

#include "tuner/validation/horizon_curve.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

/// The horizons that reports and the command print [s].
inline constexpr std::array kReportedHorizons = {0.1, 0.5, 1.0, 2.0};

/// A part of the log that was simulated.
struct MotionWindow {
  double begin = 0.0;       ///< time of its start [s]
  double duration = 0.0;    ///< at most 2 s; shorter only if the log has no longer part without a gap [s]
  double failed_at = -1.0;  ///< time after the start at which the simulation diverged [s]; below zero: it did
                            ///< not
  int limit_joint = -1;     ///< the first joint whose simulated position leaves its limits; -1: none
  double limit_at = -1.0;   ///< when, after the start [s]
};

/// Measured and simulated positions of a window, for plots.
struct MotionExample {
  std::size_t window = 0;               ///< index in MotionValidation::windows
  std::vector<double> time;             ///< on the clock of the log [s]
  Eigen::MatrixXd measured, simulated;  ///< times x n [rad, m]
};

struct MotionValidation {
  ValidationThresholds thresholds;
  CommandKind kind = CommandKind::kTorque;
  std::vector<double> horizons;     ///< H, from 0 in steps of 0.02 s to the longest window [s]
  std::vector<long> count;          ///< H, windows whose simulation reaches the horizon
  std::vector<HorizonCurve> joint;  ///< n
  std::vector<MotionWindow> windows;
  long failed = 0;      ///< windows whose simulation diverged
  long at_limit = 0;    ///< windows in which a simulated joint leaves its position limits
  double judged = 0.0;  ///< the horizon by which the motion is judged [s]
  /// n; RMS error over the largest error that matches, at the judged horizon. At most 1 for joints that
  /// match.
  std::vector<double> excess;
  /// The windows with the largest error, a median one and the smallest one over all joints; at most three.
  std::vector<MotionExample> examples;

  /// True if every joint matches, and at most the share `failed_windows` of the windows failed.
  bool model_matches() const;
  /// Returns the joint with the largest excess.
  int worst_joint() const;
  /// Returns the index of the last horizon up to this time [s].
  std::size_t index_of(double horizon) const;
};

/// Simulates the unfitted model from the states of the log. The log may have no torques. Throws InputError if
/// the log or the commands are malformed, or if the two have no common time of at least 0.1 s.
MotionValidation validate_motion(const RobotModel& model, const JointLog& log, const MotionCommands& commands,
                                 const ValidationThresholds& thresholds = {});

/// Returns one sentence without a full stop for each joint, the worst one first, and one about windows that
/// failed or reached a limit, if there are any.
std::vector<std::string> sentences(const MotionValidation& found, const RobotModel& model);

}  // namespace armtune::internal
