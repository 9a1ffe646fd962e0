#pragma once
// Converts a log to rows of the regression tau = Y_base * theta_base, where tau are the joint torques, Y_base
// is the regressor and theta_base are the base parameters (base_parameters.hpp). The logged signals pass the
// two filters of parallel_filter.hpp. The regressor Y is computed between them.

#include <memory>

#include "core/robot/slotine_li.hpp"
#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/log_file.hpp"
#include "tuner/identification/log_instants.hpp"
#include "tuner/identification/parallel_filter.hpp"

namespace armtune::internal {

struct RowOptions {
  double cutoff = 5.0;  ///< of the second filter [Hz]; above the motion's frequencies, below the noise's
  double torque_delay = 0.0;  ///< time from a logged torque's time stamp until it acts [s]
};

class RowStream {
 public:
  /// All arguments except `options` must outlive the stream. `instants` receives samples of the motion and
  /// of the torques after both filters. Throws InputError if the cutoff is not above zero, if the log has
  /// too few samples per second for this cutoff, or if the torque delay is too long for this cutoff. A log
  /// that is too short gives no rows.
  RowStream(const RobotModel& model, const BaseParameters& base, LogFile& log, const RowOptions& options,
            LogInstants& instants);

  /// Computes the next instant's rows: n x (rank + 1), columns (Y_base, tau). Returns false at the end of the
  /// log.
  bool next(Eigen::MatrixXd& rows);

  /// Throws InputError if the log has velocities that are not the derivatives of its positions, which happens
  /// with a wrong unit, sign or column. Must be called after the last row. The logged velocities are used for
  /// nothing else, because they have the noise of one more sensor, or were differentiated from the positions
  /// with a lag.
  void check_velocities() const;

  /// Returns the number of samples of the log read so far.
  long samples() const { return samples_; }
  /// Returns the time between rows [s].
  double row_period() const { return filter_.row_period(); }

 private:
  /// Returns the matrix (Y_base, tau, q, q', q'') of the newest instant, which has one row per joint, as one
  /// vector, column by column.
  Eigen::VectorXd regressor_rows();
  void compare_velocities(const FilteredMotion& motion);

  const RobotModel& model_;
  const BaseParameters& base_;
  LogFile& log_;
  LogInstants& instants_;
  ParallelFilter filter_;
  Poses poses_;
  SlotineLi slotine_li_;
  Regressor Y_;
  JointVector velocity_products_;  ///< sums of (logged velocity x differentiated velocity)
  JointVector velocity_squares_;   ///< sums of (differentiated velocity)^2
  long compared_ = 0;
  long samples_ = 0;
};

}  // namespace armtune::internal
