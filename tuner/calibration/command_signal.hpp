#pragma once
// The commands of a log as a signal that is held between samples, and its mean over short steps. With means,
// the effect of a delay is continuous, although a delay shifts steps of the signal.

#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

struct CommandedLog {
  JointLog log;             ///< its torques and velocities are not used
  MotionCommands commands;  ///< of a kind other than CommandKind::kReference
};

class CommandSignal {
 public:
  /// Commands that were lost are interpolated linearly, if no more than kMostLost in a row are missing.
  explicit CommandSignal(const MotionCommands& commands);

  double period() const { return period_; }  ///< median time between commands [s]

  /// Returns the means (steps x n) over steps of `step` [s] from `begin` on, of the signal that is late by
  /// `delay` [s]. Before the first command, the first one acts.
  Eigen::MatrixXd means(double begin, double step, Eigen::Index steps, double delay) const;

  /// Returns the linear interpolation of the commands (steps x n) at begin - delay, begin + step - delay, ...
  Eigen::MatrixXd interpolated(double begin, double step, Eigen::Index steps, double delay) const;

  static constexpr int kMostLost = 10;

 private:
  std::size_t index_at(double t) const;

  double period_;
  std::vector<double> time_;
  Eigen::MatrixXd command_;   ///< rows are held until the next time
  Eigen::MatrixXd integral_;  ///< of the signal, from the first time on
};

}  // namespace armtune::internal
