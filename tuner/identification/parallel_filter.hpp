#pragma once
// Filters logged joint signals for equations of motion, in two steps. A first zero-phase low-pass filter of a
// wide band turns positions into q, q', q'' and the logged torques into tau, at a lower rate. The caller
// computes from these the columns of its equation, such as a regressor or the torque that a model predicts. A
// second filter with a narrower band then filters every column and tau alike. Both sides of the equation
// thereby pass the same filter, so that sharp edges, such as those of friction, cause no error (parallel
// filtering: Gautier, Dynamic identification of robots with power model, 1997). Near both ends of a log,
// where a filter's window is not full, there is no result.

#include "core/common/types.hpp"
#include "tuner/identification/low_pass.hpp"
#include "tuner/identification/moving_window.hpp"

namespace armtune::internal {

/// The joint signals at one instant, after the first filter. Each has n entries.
struct FilteredMotion {
  JointVector q;                  ///< [rad, m]
  JointVector qd;                 ///< q', the derivative of the logged positions [rad/s, m/s]
  JointVector qdd;                ///< q'', their second derivative [rad/s^2, m/s^2]
  JointVector torque;             ///< [N m, N]
  JointVector logged_velocity;    ///< [rad/s, m/s]; empty if no velocities were logged
  JointVector logged_velocity_d;  ///< its derivative [rad/s^2, m/s^2]; empty if no velocities were logged
};

class ParallelFilter {
 public:
  /// The second filter may have a cutoff of at most this share of the sampling rate.
  static constexpr double kHighestCutoff = 0.125;

  /// joints: n. velocities: true if samples have velocities. period: time between samples [s]. cutoff: of the
  /// second filter [Hz], above zero and at most kHighestCutoff / period. torque_delay: time from a torque's
  /// time stamp until it acts [s], at most longest_delay() in size. columns: how many values push_columns()
  /// takes.
  ParallelFilter(int joints, bool velocities, double period, double cutoff, double torque_delay,
                 Eigen::Index columns);

  /// Adds a sample as it was logged: qd (n) is not read if there are no velocities. Returns true if motion()
  /// has a new instant.
  bool push(const JointVector& q, const JointVector& qd, const JointVector& torque);
  /// Returns the newest instant after the first filter. It is centred at the sample `first_half()` before the
  /// last.
  FilteredMotion motion() const;
  /// Adds the columns of the newest instant. Returns true if columns() has a new result.
  bool push_columns(const Eigen::VectorXd& columns) { return rows_.push(columns); }
  /// Returns the newest columns after the second filter, centred `second_half()` instants before the newest.
  Eigen::VectorXd columns() const { return rows_.sum(row_filter_.value, 0, columns_); }

  int first_half() const { return motion_filter_.half; }
  int second_half() const { return row_filter_.half; }
  /// Returns the time between the instants of motion() [s].
  double motion_period() const { return period_ * motion_step_; }
  /// Returns the time between the results of columns() [s].
  double row_period() const { return period_ * motion_step_ * row_step_; }
  /// Returns the Euclidean norm of the weights that a logged torque passes. White noise of standard deviation
  /// s in the logged torques has the deviation s times this norm in the filtered torques.
  double torque_norm() const;
  /// Returns the longest torque delay that is accepted at this cutoff and sampling period [s].
  static double longest_delay(double cutoff, double period);

 private:
  int joints_;
  bool velocities_;
  double period_;
  Eigen::Index columns_;
  LowPass motion_filter_;
  LowPass torque_filter_;
  int motion_step_;
  LowPass row_filter_;
  int row_step_;
  MovingWindow motion_;
  MovingWindow rows_;
  Eigen::VectorXd sample_;
};

}  // namespace armtune::internal
