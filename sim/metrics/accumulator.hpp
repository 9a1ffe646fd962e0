#pragma once
// Computes the metrics of a rollout (one simulated scenario), such as tracking errors and distances from
// limits. They are updated in every control period while the rollout runs.

#include <algorithm>
#include <cmath>

#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"

namespace armtune::internal {

/// The values that a series got in one control period.
struct PeriodSpread {
  double squares = 0.0;  ///< sum of their squares
  double largest = NAN;  ///< largest absolute value; NaN if there is none
  long count = 0;
};

/// The RMS and the largest absolute value of a series. Both are NaN while it is empty.
class Spread {
 public:
  void add(double x) {
    squares_ += x * x;
    max_ = std::max(max_, std::abs(x));
    ++count_;
    if (!watched_) return;
    now_.squares += x * x;
    now_.largest = std::fmax(now_.largest, std::abs(x));
    ++now_.count;
  }
  double rms() const { return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : NAN; }
  double max() const { return count_ > 0 ? max_ : NAN; }
  long count() const { return count_; }
  /// Keeps the values from now on in now() too, until the next call.
  void begin_period() {
    watched_ = true;
    now_ = {};
  }
  /// Returns the values since the last call of begin_period().
  const PeriodSpread& now() const { return now_; }

 private:
  double squares_ = 0.0;
  double max_ = 0.0;
  long count_ = 0;
  bool watched_ = false;
  PeriodSpread now_;
};

/// Measures the time from each event until a value stays below a threshold, and keeps the longest of these
/// times. Here an event is a switch of the tool's aim to another target. The value is the gaze error, that
/// is, the angle from the tool's z axis to the line to the target.
class Reacquisition {
 public:
  /// Records a new event at t [s], and ends the measurement for the previous event.
  void start(double t);
  /// Adds a sample at t [s]. outside: true if the value is not below the threshold.
  void add(double t, bool outside);
  /// Ends the measurement for the last event at `end` [s]. Returns the longest time of all events [s]; NaN if
  /// there was no event.
  double longest(double end);

 private:
  void close(double end);
  bool open_ = false;
  double start_ = 0.0;
  double settled_ = 0.0;  ///< first time inside after the last time outside
  bool outside_ = false;
  double longest_ = NAN;
};

class MetricAccumulator {
 public:
  /// threshold: gaze error below which a target counts as reached, the gain slerpAngularErrorThreshold [rad].
  /// period: control period [s].
  MetricAccumulator(const RobotModel& model, double threshold, double period);

  /// Sets the target that was active before the first period, so that a target switch in the first period
  /// counts. This is needed if the rollout may begin at such a switch.
  void look_from(std::size_t target) {
    target_ = target;
    from_before_ = true;
  }

  /// Sets the time between two instants of an observation [s] (Observation::each_instant), if it is not the
  /// control period.
  void sample_every(double step) { step_ = step; }
  /// Sets the end of the planned trajectory [s]. Joint errors count only before this time.
  void end_plan(double time) { plan_end_ = time; }

  /// Leaves out the metrics of the gaze. Call it for tasks in which the tool does not aim at a target.
  void aim_at_nothing() { aims_ = false; }

  void add(const Observation& o);
  /// Returns the series of a metric that is an RMS or a largest absolute value, and for the reacquisition
  /// time that of the gaze angle; null for all other metrics.
  Spread* spread_of(Metric m) { return spread_in(*this, m); }
  /// Returns the value so far of a metric that only worsens. It is NaN before the metric has a value, and for
  /// all other metrics.
  double so_far(Metric m) const;
  /// Returns all metrics. end: time at which the last period ends [s].
  Metrics result(double end);

 private:
  template <typename Self>
  static auto spread_in(Self& self, Metric m) -> decltype(&self.position_) {
    switch (m) {
      case Metric::kPositionXMax:
        return &self.position_axis_[0];
      case Metric::kPositionYMax:
        return &self.position_axis_[1];
      case Metric::kPositionZMax:
        return &self.position_axis_[2];
      case Metric::kPositionRms:
      case Metric::kPositionMax:
        return &self.position_;
      case Metric::kOrientationXMax:
        return &self.orientation_axis_[0];
      case Metric::kOrientationYMax:
        return &self.orientation_axis_[1];
      case Metric::kOrientationZMax:
        return &self.orientation_axis_[2];
      case Metric::kOrientationRms:
      case Metric::kOrientationMax:
        return &self.orientation_;
      case Metric::kLinearVelocityRms:
      case Metric::kLinearVelocityMax:
        return &self.linear_velocity_;
      case Metric::kAngularVelocityRms:
      case Metric::kAngularVelocityMax:
        return &self.angular_velocity_;
      case Metric::kGazeRms:
      case Metric::kGazeMax:
      case Metric::kReacquisitionTime:
        return &self.gaze_;
      case Metric::kGazeRateErrorRms:
      case Metric::kGazeRateErrorMax:
        return &self.gaze_rate_;
      case Metric::kJointErrorRms:
      case Metric::kJointErrorMax:
        return &self.joint_error_;
      case Metric::kToolErrorRms:
      case Metric::kToolErrorMax:
        return &self.tool_error_;
      case Metric::kJointEffortRms:
        return &self.effort_;
      case Metric::kEffortRateRms:
        return &self.effort_rate_;
      case Metric::kCompensationErrorRms:
        return &self.compensation_;
      default:
        return nullptr;
    }
  }
  void add_gaze(const Observation& o, bool switched);
  void add_tracking(const Observation& o);
  void add_limits(const Observation& o);
  void add_instant(double time, const JointVector& q, const JointVector& velocity,
                   const JointVector& commanded, const JointVector& torque);
  void add_acceleration(const JointVector& velocity);

  const RobotModel& model_;
  JointVector per_velocity_limit_;
  JointVector per_effort_limit_;
  JointVector per_acceleration_limit_;  ///< 0 for joints without a limit
  JointVector lower_limits_;
  JointVector upper_limits_;
  double threshold_;
  double period_;
  double step_;  ///< time between two instants [s]

  ControlState state_ = ControlState::kLeaveSingularity;
  double entered_ = 0.0;
  bool first_ = true;
  long instants_ = 0;
  double plan_end_ = INFINITY;
  bool aims_ = true;          ///< the tool aims at a target
  bool from_before_ = false;  ///< target_ is known before the first period
  std::size_t target_ = 0;

  Spread position_axis_[3], orientation_axis_[3];
  Spread position_, orientation_, linear_velocity_, angular_velocity_;
  Spread joint_error_, tool_error_;
  Poses planned_poses_;  ///< of the planned joint positions
  Spread gaze_, gaze_rate_, effort_, effort_rate_, compensation_;
  Reacquisition reacquisition_;
  long periods_outside_ = 0;
  double max_ratio_ = 0.0;
  double max_ratio_time_ = 0.0;
  Eigen::Index max_ratio_joint_ = 0;
  // For each joint the largest of its magnitudes, or the ends of its motion, in all instants. Rounding keeps
  // the order of numbers. So each is multiplied by its factor, or compared with its limit, only once at the
  // end.
  JointVector lowest_, highest_;
  JointVector max_commanded_;
  JointVector max_acceleration_;
  JointVector max_acceleration_change_;  ///< between two instants
  long saturated_periods_ = 0;
  double min_clearance_;
  LeastClearances least_;
  JointVector last_torque_;
  JointVector last_velocity_;
  JointVector last_acceleration_;
};

}  // namespace armtune::internal
