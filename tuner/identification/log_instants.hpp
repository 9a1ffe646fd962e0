#pragma once
// Keeps instants of robot logs, evenly spaced in time, and estimates the noise of the torques. The instants
// allow a log to be compared with the robot file many times without reading the log again. The motion at
// these instants has passed the same two filters as the rows of the regression (row_stream.hpp). The second
// filter is needed: after the first alone, noise in the positions would look like acceleration of a joint at
// rest.

#include <vector>

#include "core/common/types.hpp"

namespace armtune::internal {

struct LogInstant {
  JointVector q;       ///< [rad, m]
  JointVector qd;      ///< [rad/s, m/s]
  JointVector qdd;     ///< [rad/s^2, m/s^2]
  JointVector torque;  ///< [N m, N]
};

/// Keeps every 2^k-th of the added values. k grows with their number, so that at most kMost are kept.
template <typename T>
class Sampled {
 public:
  static constexpr std::size_t kMost = 2000;

  void add(const T& value) {
    if (seen_++ % step_ != 0) return;
    kept_.push_back(value);
    if (kept_.size() <= kMost) return;
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize((kept_.size() + 1) / 2);
    step_ *= 2;
  }
  const std::vector<T>& kept() const { return kept_; }

 private:
  std::vector<T> kept_;
  std::size_t step_ = 1;
  std::size_t seen_ = 0;
};

class LogInstants {
 public:
  /// Must be called before the values of each log are added. filter_norm: Euclidean norm of the weights of
  /// the filters that are applied to the log's torques.
  void begin_log(double filter_norm) {
    filter_norm_ = filter_norm;
    last_.resize(0);
  }
  /// Takes the torques of the next sample (n), as they were logged.
  void add_logged_torque(const JointVector& torque);
  void add(const LogInstant& instant) { instants_.add(instant); }

  const std::vector<LogInstant>& kept() const { return instants_.kept(); }
  /// Returns the standard deviation of the noise in the filtered torques of the instants (n) [N m, N]. It is
  /// valid if the noise of the logged torques is white. It is computed from the median size of the second
  /// differences of the logged torques, each times the norm of its log's filters. The motion hardly changes
  /// this median, because smooth torques have small second differences, and jumps of friction are rare. The
  /// result is empty if no log has three samples.
  JointVector torque_noise() const;

 private:
  Sampled<LogInstant> instants_;
  Sampled<JointVector> second_differences_;  ///< of the logged torques, times the norm of their log's filters
  JointVector last_, before_last_;
  double filter_norm_ = 1.0;
};

}  // namespace armtune::internal
