#pragma once
// Divides a log into windows: those that are fitted, and those of the held-out part, on which the result is
// judged.

#include "tuner/calibration/command_signal.hpp"

namespace armtune::internal {

/// Samples first .. first + count - 1 of a log.
struct LogWindow {
  Eigen::Index first = 0;
  Eigen::Index count = 0;
};

struct WindowPlan {
  double period = 0.0;  ///< median time between samples [s]
  std::vector<LogWindow> fitted;
  std::vector<LogWindow> held_out;
};

/// How a log is divided [s].
struct WindowLengths {
  double fitted = 1.0;  ///< of a fitted window
  double block = 2.5;   ///< of a held-out window; at most a fifth of the log
};

/// A part of the time of a log [s].
struct TimeSpan {
  double from = 0.0, to = 0.0;
};

/// Time before a window over which a servo runs, so that its state at the window's start is known [s].
inline constexpr double kServoWarmUp = 1.0;

/// Returns the time in which commands are known, and with them the state of a servo. Commands of the first
/// moments are left out, because later ones act before them if there is a delay.
TimeSpan known_commands(const MotionCommands& commands);

/// Divides the log into blocks. Of five blocks in a row, the third is held out and the others are fitted.
/// Windows lie in the span. No window contains a gap of more than CommandSignal::kMostLost samples. Throws
/// InputError if the log is too short for one window of each kind. It must have passed check_joint_log().
WindowPlan window_plan(const JointLog& log, const TimeSpan& span, const WindowLengths& lengths = {});

/// Returns the standard deviation of the noise of each encoder (n) [rad, m]. Third differences of the
/// positions hardly contain the motion; the median of their size is robust. It is at least 1e-7.
Eigen::VectorXd encoder_noise(const JointLog& log, double period);

}  // namespace armtune::internal
