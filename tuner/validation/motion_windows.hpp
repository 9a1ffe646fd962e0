#pragma once
// Divides a log into windows that are simulated one by one. A window lies in one part of the log without gaps
// and jumps, in which commands are known. Windows begin every second, so that they overlap by half.

#include <vector>

#include "tuner/validation/joint_motion.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

inline constexpr double kLongestWindow = 2.0;   ///< [s]
inline constexpr double kShortestWindow = 0.1;  ///< [s]
inline constexpr std::size_t kMostWindows = 200;

/// Where a window lies.
struct WindowPlace {
  std::size_t stretch = 0;  ///< index in LoggedMotion::stretches
  std::size_t first = 0;    ///< index of its first instant
  double duration = 0.0;    ///< [s]
};

/// Returns the windows in the order of time. If there are more than kMostWindows, those are left out that
/// make the rest lie evenly over the log. Parts of the log of less than kLongestWindow have one window as
/// long as the part, or none if that is shorter than kShortestWindow. Commands end at their gaps, which are
/// as long as those of samples (ValidationThresholds::gap).
std::vector<WindowPlace> place_windows(const LoggedMotion& motion, const MotionCommands& commands,
                                       const ValidationThresholds& thresholds);

/// Returns the median step between increasing times, at least two [s].
double median_step(const std::vector<double>& time);

/// Returns the positions (n) of a stretch at `time` since its first instant [s], by cubic interpolation. The
/// stretch has at least four instants.
JointVector position_at(const MotionStretch& stretch, double time);

}  // namespace armtune::internal
