#pragma once
// Delays the torque commands by a whole number of control periods, to simulate the delay in a real arm.

#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

class TorqueDelay {
 public:
  /// n: number of joints; periods >= 0. The torque is zero until the first command arrives.
  TorqueDelay(int n, int periods) : line_(static_cast<std::size_t>(periods) + 1, JointVector::Zero(n)) {}

  /// Takes this period's command and returns the command of `periods` control periods ago.
  const JointVector& pass(const JointVector& command) {
    line_[next_] = command;
    next_ = (next_ + 1) % line_.size();
    return line_[next_];
  }

 private:
  std::vector<JointVector> line_;  ///< ring buffer; the slot next_ holds the oldest command
  std::size_t next_ = 0;
};

}  // namespace armtune::internal
