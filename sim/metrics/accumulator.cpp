#include "sim/metrics/accumulator.hpp"

#include <limits>
#include <type_traits>

#include "core/control/axis_error.hpp"
#include "core/trajectory/gaze.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// Time after the start of the state followTrajectory from which tracking errors count [s].
constexpr double kSettlingTime = 1.0;

/// Returns the difference between the angular velocities of the tool's z axis and of the line to the target
/// [rad/s]. If the task gives an orientation, returns the difference between the angular velocities of the
/// tool and of that orientation.
double gaze_rate_error(const Observation& o) {
  const Vec3 z = o.poses->R_0T.col(2);
  const Vec3 w = o.twist.tail<3>();
  if (o.orientation != nullptr) {
    const Vec3 error = w - o.orientation->angular_velocity;
    return (o.aim().axis_only ? axis_rate(o.poses->R_0T, error) : error).norm();
  }
  const Vec3 turn = w - w.dot(z) * z;
  return (turn - gaze_line_rate(o.poses->p_0T, o.twist.head<3>(), o.target_motion.position,
                                o.target_motion.velocity))
      .norm();
}

/// Calls run(i, size) for each pair of n elements, with its first index, and for the last element if n is
/// odd. size: a std::integral_constant. Every processor computes with pairs as fast as with single elements.
template <typename Run>
void for_pairs(Eigen::Index n, const Run& run) {
  Eigen::Index i = 0;
  for (; i + 1 < n; i += 2) run(i, std::integral_constant<int, 2>());
  if (i < n) run(i, std::integral_constant<int, 1>());
}

/// Returns the largest a_i b_i. The product of zero and an infinite number does not count.
double largest_product(const JointVector& a, const JointVector& b) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < a.size(); ++i) largest = std::max(largest, a[i] * b[i]);
  return largest;
}

/// Returns x, or NaN if it is infinite: the minimum of no values, or the ratio to an effort limit of zero.
double finite_or_nan(double x) {
  return x < kInfinity ? x : NAN;
}

}  // namespace

void Reacquisition::start(double t) {
  close(t);
  open_ = true;
  start_ = t;
  settled_ = t;
  outside_ = false;
}

void Reacquisition::add(double t, bool outside) {
  if (!open_) return;
  if (outside_ && !outside) settled_ = t;
  outside_ = outside;
}

void Reacquisition::close(double end) {
  if (!open_) return;
  const double time = (outside_ ? end : settled_) - start_;
  longest_ = std::isnan(longest_) ? time : std::max(longest_, time);
  open_ = false;
}

double Reacquisition::longest(double end) {
  close(end);
  return longest_;
}

MetricAccumulator::MetricAccumulator(const RobotModel& model, double threshold, double period)
    : model_(model),
      per_velocity_limit_(model.velocity_limits().cwiseInverse()),
      per_effort_limit_(model.effort_limits().cwiseInverse()),
      per_acceleration_limit_(model.acceleration_limits().cwiseInverse()),
      lower_limits_(model.lower_limits()),
      upper_limits_(model.upper_limits()),
      threshold_(threshold),
      period_(period),
      step_(period),
      lowest_(JointVector::Constant(model.n(), kInfinity)),
      highest_(JointVector::Constant(model.n(), -kInfinity)),
      max_commanded_(JointVector::Zero(model.n())),
      max_acceleration_(JointVector::Zero(model.n())),
      max_acceleration_change_(JointVector::Zero(model.n())),
      min_clearance_(kInfinity),
      last_torque_(JointVector::Zero(model.n())),
      last_velocity_(JointVector::Zero(model.n())),
      last_acceleration_(JointVector::Zero(model.n())) {}

void MetricAccumulator::add(const Observation& o) {
  if (o.control->state != state_) {
    state_ = o.control->state;
    entered_ = o.time;
  }
  add_limits(o);
  const bool switched = (!first_ || from_before_) && o.target != target_;
  target_ = o.target;
  first_ = false;
  if (state_ == ControlState::kLeaveSingularity) return;

  if (state_ == ControlState::kFollowPlan && o.time < plan_end_) {
    const JointVector& planned = o.control->planned.position;
    for (int i = 0; i < model_.n(); ++i) joint_error_.add((*o.q)[i] - planned[i]);
    forward_kinematics(model_.chain, planned, planned_poses_);
    tool_error_.add((o.poses->p_0T - planned_poses_.p_0T).norm());
  }
  compensation_.add(o.compensation_error);
  if (aims_) add_gaze(o, switched);
  // The tolerance of half a period allows for the rounding of k * dt.
  if (state_ == ControlState::kFollowTrajectory && !o.control->slerping &&
      o.time - entered_ >= kSettlingTime - 0.5 * period_) {
    add_tracking(o);
  }
}

void MetricAccumulator::add_gaze(const Observation& o, bool switched) {
  gaze_.add(o.gaze_angle);
  gaze_rate_.add(gaze_rate_error(o));
  const bool outside = o.gaze_angle >= threshold_;
  if (outside) ++periods_outside_;
  if (switched) reacquisition_.start(o.time);
  reacquisition_.add(o.time, outside);
}

void MetricAccumulator::add_tracking(const Observation& o) {
  for (int axis = 0; axis < 3; ++axis) {
    position_axis_[axis].add(o.error[axis]);
    orientation_axis_[axis].add(o.error[3 + axis]);
  }
  position_.add(o.error.head<3>().norm());
  orientation_.add(o.error.tail<3>().norm());
  linear_velocity_.add(o.error_rate.head<3>().norm());
  angular_velocity_.add(o.error_rate.tail<3>().norm());
}

void MetricAccumulator::add_limits(const Observation& o) {
  o.each_instant([this](double time, const JointVector& q, const JointVector& velocity,
                        const JointVector& commanded,
                        const JointVector& torque) { add_instant(time, q, velocity, commanded, torque); });
  if (o.saturated()) ++saturated_periods_;
  min_clearance_ = std::min(min_clearance_, o.clearance);
  if (o.cell != nullptr) least_ = o.cell->least();
}

void MetricAccumulator::add_instant(double time, const JointVector& q, const JointVector& velocity,
                                    const JointVector& commanded, const JointVector& torque) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    const double ratio = std::abs(velocity[i]) * per_velocity_limit_[i];
    if (ratio > max_ratio_) {
      max_ratio_ = ratio;
      max_ratio_time_ = time;
      max_ratio_joint_ = i;
    }
  }
  for_pairs(q.size(), [&](Eigen::Index i, auto size) {
    const auto part = [i](auto& v) { return v.template segment<decltype(size)::value>(i); };
    part(lowest_) = part(lowest_).cwiseMin(part(q));
    part(highest_) = part(highest_).cwiseMax(part(q));
    part(max_commanded_) = part(max_commanded_).cwiseMax(part(commanded).cwiseAbs());
  });
  effort_.add(torque.norm());
  if (instants_ > 0) effort_rate_.add((torque - last_torque_).norm() / step_);
  last_torque_ = torque;
  add_acceleration(velocity);
}

void MetricAccumulator::add_acceleration(const JointVector& velocity) {
  const double rate = 1.0 / step_;
  for_pairs(velocity.size(), [&](Eigen::Index i, auto size) {
    const auto part = [i](auto& v) { return v.template segment<decltype(size)::value>(i); };
    const Eigen::Matrix<double, decltype(size)::value, 1> acceleration =
        (part(velocity) - part(last_velocity_)) * rate;
    // The second instant gives the first acceleration, and the third one the first jerk.
    if (instants_ > 0) part(max_acceleration_) = part(max_acceleration_).cwiseMax(acceleration.cwiseAbs());
    if (instants_ > 1)
      part(max_acceleration_change_) =
          part(max_acceleration_change_).cwiseMax((acceleration - part(last_acceleration_)).cwiseAbs());
    part(last_acceleration_) = acceleration;
    part(last_velocity_) = part(velocity);
  });
  ++instants_;
}

double MetricAccumulator::so_far(Metric m) const {
  switch (m) {
    case Metric::kGazeTimeOutside:
      return gaze_.count() > 0 ? static_cast<double>(periods_outside_) * period_ : NAN;
    case Metric::kJointVelocityMaxRatio:
      return first_ ? NAN : max_ratio_;
    case Metric::kJointPositionMinMargin:
      return finite_or_nan((lowest_ - lower_limits_).cwiseMin(upper_limits_ - highest_).minCoeff());
    case Metric::kJointEffortMaxRatio:
      return first_ ? NAN : finite_or_nan(largest_product(max_commanded_, per_effort_limit_));
    case Metric::kJointEffortSaturatedPeriods:
      return first_ ? NAN : static_cast<double>(saturated_periods_);
    case Metric::kJointAccelerationMax:
      return instants_ > 1 ? max_acceleration_.maxCoeff() : NAN;
    case Metric::kJointAccelerationMaxRatio:
      return instants_ > 1 && (per_acceleration_limit_.array() > 0.0).any()
                 ? largest_product(max_acceleration_, per_acceleration_limit_)
                 : NAN;
    case Metric::kJointJerkMax:
      return instants_ > 2 ? max_acceleration_change_.maxCoeff() * (1.0 / step_) : NAN;
    case Metric::kObstacleMinClearance:
      return finite_or_nan(min_clearance_);
    case Metric::kClearanceSelf:
      return finite_or_nan(least_of(Clearance::kSelf, least_).distance);
    case Metric::kClearanceCell:
      return finite_or_nan(least_of(Clearance::kCell, least_).distance);
    case Metric::kClearanceFloor:
      return finite_or_nan(least_of(Clearance::kFloor, least_).distance);
    default: {
      const Spread* spread = only_worsens(m) ? spread_in(*this, m) : nullptr;
      return spread != nullptr ? spread->max() : NAN;
    }
  }
}

Metrics MetricAccumulator::result(double end) {
  Metrics m;
  for (std::size_t i = 0; i < kMetricCount; ++i) {
    const auto metric = static_cast<Metric>(i);
    if (only_worsens(metric)) {
      m[metric] = so_far(metric);
    } else if (const Spread* spread = spread_of(metric)) {
      m[metric] = spread->rms();
    }
  }
  m[Metric::kSamples] = static_cast<double>(position_.count());
  m[Metric::kReacquisitionTime] = reacquisition_.longest(end);
  m[Metric::kJointVelocityMaxRatioTime] = first_ ? NAN : max_ratio_time_;
  if (!first_) m.max_ratio_joint = model_.joints[static_cast<std::size_t>(max_ratio_joint_)].name;
  return m;
}

}  // namespace armtune::internal
