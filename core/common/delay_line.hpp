#pragma once
// Delays vectors by a whole number of control periods, to simulate the time that commands take to reach an
// arm.

#include <algorithm>
#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

class DelayLine {
 public:
  /// n: number of joints; periods >= 0. The delayed vector is zero until the first one arrives.
  DelayLine(int n, int periods) : line_(static_cast<std::size_t>(periods) + 1, JointVector::Zero(n)) {}

  /// Sets the vector (n) that pass() returns until the first delayed vector arrives.
  void fill(const JointVector& value) { std::fill(line_.begin(), line_.end(), value); }

  /// Takes this period's vector and returns the vector that was passed `periods` control periods ago.
  const JointVector& pass(const JointVector& now) {
    line_[next_] = now;
    next_ = (next_ + 1) % line_.size();
    return line_[next_];
  }

 private:
  std::vector<JointVector> line_;  ///< ring buffer; the slot next_ holds the oldest vector
  std::size_t next_ = 0;
};

}  // namespace armtune::internal
