#pragma once
// From a log to rows of the regression tau = Y_base theta_base.
//
// Two zero-phase stages. The first, wide, turns positions into q, q', q'' and torques into tau at a lower
// rate; there the regressor is formed. The second, at the cutoff, filters every column of Y and tau alike, so
// that both sides of the equation have seen the same filter and sharp edges, as friction's, do no harm
// (parallel filtering: Gautier, Dynamic identification of robots with power model, 1997).

#include <memory>

#include "core/robot/slotine_li.hpp"
#include "tuner/identification/base_parameters.hpp"
#include "tuner/identification/log_file.hpp"
#include "tuner/identification/log_instants.hpp"
#include "tuner/identification/low_pass.hpp"
#include "tuner/identification/moving_window.hpp"

namespace armtune::internal {

struct RowOptions {
  double cutoff = 5.0;  ///< [Hz] of the second stage: above what the trajectory excites, below the noise
  double torque_delay = 0.0;  ///< [s] the log's torque acts so much later than its row's time
};

class RowStream {
 public:
  /// All arguments must outlive this; `instants` takes a sample of the filtered motion. Throws InputError if
  /// the log is too short or too coarse for the cutoff.
  RowStream(const RobotModel& model, const BaseParameters& base, LogFile& log, const RowOptions& options,
            LogInstants& instants);

  /// The next instant's rows: n x (rank + 1), columns (Y_base, tau). False at the end of the log.
  bool next(Eigen::MatrixXd& rows);

  /// After the last row: throws InputError if the log has velocities that are not the positions' derivatives,
  /// which a wrong unit, sign or column makes them. Nothing else is taken from them: they carry the noise of
  /// one more sensor, or were differentiated from the positions with a lag.
  void check_velocities() const;

  /// Samples of the log read so far.
  long samples() const { return samples_; }
  /// Time between rows [s].
  double row_period() const { return period_ * motion_step_ * row_step_; }

 private:
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
