#pragma once
// Converts a log to rows of the regression tau = Y_base theta_base.
//
// Two zero-phase low-pass filters are applied. The first has a wide band. It turns positions into q, q', q''
// and torques into tau at a lower rate, and the regressor Y is computed from these. The second has the cutoff
// of RowOptions and filters every column of Y and tau alike. Both sides of the equation thereby pass the same
// filter, so that sharp edges, such as those of friction, do no harm (parallel filtering: Gautier, Dynamic
// identification of robots with power model, 1997).

#include <memory>

#include "core/robot/slotine_li.hpp"
#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/log_file.hpp"
#include "tuner/identification/log_instants.hpp"
#include "tuner/identification/low_pass.hpp"
#include "tuner/identification/moving_window.hpp"

namespace armtune::internal {

struct RowOptions {
  double cutoff = 5.0;  ///< [Hz] of the second filter: above what the trajectory excites, below the noise
  double torque_delay = 0.0;  ///< [s] by which a logged torque acts later than its time stamp
};

class RowStream {
 public:
  /// All arguments but `options` must outlive the stream. `instants` receives samples of the motion and of
  /// the torques after both filters. Throws InputError if the cutoff is not above zero, if the log has too
  /// few samples per second for it, or if the torque delay is too long for it. A log that is too short has no
  /// rows.
  RowStream(const RobotModel& model, const BaseParameters& base, LogFile& log, const RowOptions& options,
            LogInstants& instants);

  /// Computes the next instant's rows: n x (rank + 1), columns (Y_base, tau). False at the end of the log.
  bool next(Eigen::MatrixXd& rows);

  /// Throws InputError if the log has velocities that are not the derivatives of its positions, which happens
  /// with a wrong unit, sign or column. To be called after the last row. The velocities are used for nothing
  /// else: they carry the noise of one more sensor, or were differentiated from the positions with a lag.
  void check_velocities() const;

  /// Returns the number of samples of the log read so far.
  long samples() const { return samples_; }
  /// Returns the time between rows [s].
  double row_period() const { return period_ * motion_step_ * row_step_; }

 private:
  /// Returns the newest instant's rows, each with its joint's motion, one column after the other.
  Eigen::VectorXd regressor_rows();
  void compare_velocities(const JointVector& qd);

  const RobotModel& model_;
  const BaseParameters& base_;
  LogFile& log_;
  LogInstants& instants_;
  double period_;
  LowPass motion_filter_;
  LowPass torque_filter_;
  int motion_step_;
  LowPass row_filter_;
  int row_step_;
  MovingWindow motion_;
  MovingWindow rows_;
  Poses poses_;
  SlotineLi slotine_li_;
  Regressor Y_;
  JointVector velocity_products_;  ///< sums of logged times differentiated velocity
  JointVector velocity_squares_;   ///< sums of differentiated velocity squared
  long compared_ = 0;
  long samples_ = 0;
};

}  // namespace armtune::internal
