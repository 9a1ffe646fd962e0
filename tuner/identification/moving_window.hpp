#pragma once
// Stores the last samples of a stream of vectors as one matrix, to which the weights of an FIR filter are
// applied.

#include <Eigen/Core>

namespace armtune::internal {

class MovingWindow {
 public:
  /// length: number of samples in the window. step: once the window is full, a result is due at every step-th
  /// sample.
  MovingWindow(Eigen::Index channels, int length, int step)
      : length_(length), step_(step), samples_(channels, 4 * length) {}

  /// Adds a sample (channels). Returns true if a result is due.
  bool push(const Eigen::VectorXd& sample) {
    if (end_ == samples_.cols()) {
      samples_.leftCols(length_) = samples_.rightCols(length_).eval();
      end_ = length_;
    }
    samples_.col(end_++) = sample;
    const long past = ++seen_ - length_;
    return past >= 0 && past % step_ == 0;
  }

  /// Returns the weighted sum of the window's samples, for `count` channels from `first` on.
  Eigen::VectorXd sum(const Eigen::VectorXd& weights, Eigen::Index first, Eigen::Index count) const {
    return samples_.block(first, end_ - length_, count, length_) * weights;
  }

 private:
  Eigen::Index length_;
  long step_;
  Eigen::MatrixXd samples_;
  Eigen::Index end_ = 0;
  long seen_ = 0;
};

}  // namespace armtune::internal
