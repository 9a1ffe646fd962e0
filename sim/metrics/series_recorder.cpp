#include "sim/metrics/series_recorder.hpp"

#include <cmath>

namespace armtune::internal {
namespace {

double finite_or_none(double x) {
  return std::isfinite(x) ? x : NAN;
}

void append_joints(std::vector<double>& values, const JointVector& joints) {
  for (const double x : joints) values.push_back(finite_or_none(x));
}

/// Returns 1 / limit for each joint, NaN for joints without a limit.
JointVector per_limit(const JointVector& limits) {
  return limits.unaryExpr([](double limit) { return std::isfinite(limit) ? 1.0 / limit : NAN; });
}

bool has_channel_per_joint(Metric metric) {
  switch (metric) {
    case Metric::kJointVelocityMaxRatio:
    case Metric::kJointPositionMinMargin:
    case Metric::kJointEffortMaxRatio:
    case Metric::kJointAccelerationMax:
    case Metric::kJointAccelerationMaxRatio:
    case Metric::kJointJerkMax:
      return true;
    default:
      return false;
  }
}

}  // namespace

PeriodMode mode_of(const Observation& o) {
  const ControlOutput& control = *o.control;
  PeriodMode mode = static_cast<PeriodMode>(control.state) | PeriodMode{o.target} << kFirstTargetBit;
  if (control.slerping) mode |= kModeSlerping;
  if (control.damped) mode |= kModeDamped;
  if (control.pace < 1.0) mode |= kModeSlowed;
  o.each_instant([&mode](double, const JointVector&, const JointVector&, const JointVector& commanded,
                         const JointVector& torque) {
    for (Eigen::Index i = 0; i < torque.size(); ++i) {
      if (torque[i] != commanded[i]) mode |= PeriodMode{1} << (kFirstSaturatedBit + i);
    }
  });
  return mode;
}

SeriesRecorder::SeriesRecorder(const std::vector<Metric>& metrics, const Scenario& scenario, double threshold,
                               MetricAccumulator& accumulator)
    : scenario_(scenario),
      threshold_(threshold),
      per_velocity_limit_(scenario.robot->velocity_limits().cwiseInverse()),
      per_effort_limit_(scenario.robot->effort_limits().cwiseInverse()),
      per_acceleration_limit_(per_limit(scenario.robot->acceleration_limits())),
      lower_limits_(scenario.robot->lower_limits()),
      upper_limits_(scenario.robot->upper_limits()),
      last_velocity_(JointVector::Zero(scenario.robot->n())),
      last_acceleration_(JointVector::Zero(scenario.robot->n())) {
  if (scenario.planned) goal_ = scenario.planned->at(scenario.planned->end()).position;
  const auto periods = static_cast<std::size_t>(scenario.periods());
  series_.start = scenario.start_time;
  series_.period = scenario.control_period;
  series_.modes.reserve(periods);
  for (const Metric metric : metrics) {
    if (!series_kind(metric)) continue;
    MetricSeries& series = series_.metrics.emplace_back();
    series.metric = metric;
    if (has_channel_per_joint(metric)) series.channels = static_cast<std::size_t>(scenario.robot->n());
    series.values.reserve(periods * series.channels);
  }
  for (const MetricSeries& series : series_.metrics) {
    spreads_.push_back(accumulator.spread_of(series.metric));
    if (spreads_.back() != nullptr) spreads_.back()->begin_period();
  }
}

void SeriesRecorder::add_instant(const JointVector& q, const JointVector& velocity,
                                 const JointVector& commanded, double step) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    row_.velocity[i] = std::fmax(row_.velocity[i], std::abs(velocity[i]) * per_velocity_limit_[i]);
    row_.margin[i] = std::fmin(row_.margin[i], std::min(q[i] - lower_limits_[i], upper_limits_[i] - q[i]));
    row_.effort[i] = std::fmax(row_.effort[i], std::abs(commanded[i]) * per_effort_limit_[i]);
    const double acceleration = (velocity[i] - last_velocity_[i]) / step;
    // The second instant gives the first acceleration, and the third one the first jerk.
    if (instants_ > 0) row_.acceleration[i] = std::fmax(row_.acceleration[i], std::abs(acceleration));
    if (instants_ > 1)
      row_.jerk[i] = std::fmax(row_.jerk[i], std::abs(acceleration - last_acceleration_[i]) / step);
    last_acceleration_[i] = acceleration;
    last_velocity_[i] = velocity[i];
  }
  ++instants_;
}

double SeriesRecorder::distance_from_goal(const Observation& o) const {
  if (goal_.size() == 0 || o.time < scenario_.planned->end()) return NAN;
  return (*o.q - goal_).cwiseAbs().maxCoeff() - scenario_.goal_tolerance;
}

void SeriesRecorder::append(MetricSeries& series, const PeriodSpread& spread, const Observation& o) const {
  std::vector<double>& values = series.values;
  switch (series.metric) {
    case Metric::kJointVelocityMaxRatio:
      return append_joints(values, row_.velocity);
    case Metric::kJointPositionMinMargin:
      return append_joints(values, row_.margin);
    case Metric::kJointEffortMaxRatio:
      return append_joints(values, row_.effort);
    case Metric::kJointAccelerationMax:
      return append_joints(values, row_.acceleration);
    case Metric::kJointAccelerationMaxRatio:
      return append_joints(values, row_.acceleration.cwiseProduct(per_acceleration_limit_));
    case Metric::kJointJerkMax:
      return append_joints(values, row_.jerk);
    case Metric::kObstacleMinClearance:
      return values.push_back(finite_or_none(o.clearance));
    case Metric::kReacquisitionTime:
      return values.push_back(spread.largest - threshold_);
    case Metric::kGoalSettlingTime:
      return values.push_back(distance_from_goal(o));
    default:
      values.push_back(series_kind(series.metric) == SeriesKind::kRms && spread.count > 0
                           ? std::sqrt(spread.squares)
                           : spread.largest);
  }
}

void SeriesRecorder::add(const Observation& o, double step) {
  const JointVector none = JointVector::Constant(last_velocity_.size(), NAN);
  row_ = {none, none, none, none, none};
  o.each_instant([this, step](double, const JointVector& q, const JointVector& velocity,
                              const JointVector& commanded,
                              const JointVector&) { add_instant(q, velocity, commanded, step); });
  for (std::size_t i = 0; i < spreads_.size(); ++i) {
    append(series_.metrics[i], spreads_[i] != nullptr ? spreads_[i]->now() : PeriodSpread(), o);
  }
  // Only now, because several metrics may have the same spread.
  for (Spread* spread : spreads_) {
    if (spread != nullptr) spread->begin_period();
  }
  series_.modes.push_back(mode_of(o));
}

}  // namespace armtune::internal
