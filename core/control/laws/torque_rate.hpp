#pragma once
// Limits how fast commanded torques change, as the example controllers for Franka's arms do.

#include "core/common/types.hpp"

namespace armtune::internal {

class TorqueRate {
 public:
  /// n: number of joints; rate: largest change per second [N m/s, N/s], 0: no limit; period: control period
  /// [s]. The first command is limited as if the one before had been 0.
  TorqueRate(int n, double rate, double period) : step_(rate * period), last_(JointVector::Zero(n)) {}

  /// Changes the command (n) so that no entry differs from that of the last command by more than rate times
  /// period.
  void limit(JointVector& command) {
    if (step_ > 0.0) command = last_ + (command - last_).cwiseMax(-step_).cwiseMin(step_);
    last_ = command;
  }

  /// Sets the last command (n). Call it in periods in which the joints were commanded without this limit.
  void follow(const JointVector& command) { last_ = command; }

 private:
  double step_;
  JointVector last_;
};

}  // namespace armtune::internal
