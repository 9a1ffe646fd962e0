#pragma once
// Records the series behind metrics (rollout_series.hpp) while a rollout (one simulated scenario) runs.

#include "sim/metrics/accumulator.hpp"
#include "sim/metrics/rollout_series.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

class SeriesRecorder {
 public:
  /// Reserves the memory for the whole rollout. metrics: those without a series are left out. threshold: gaze
  /// error below which a target counts as reached [rad]. accumulator: computes the metrics of the same
  /// rollout. Scenario and accumulator must outlive this object, which must stay where it is.
  SeriesRecorder(const std::vector<Metric>& metrics, const Scenario& scenario, double threshold,
                 MetricAccumulator& accumulator);
  SeriesRecorder(const SeriesRecorder&) = delete;
  SeriesRecorder& operator=(const SeriesRecorder&) = delete;

  /// Records a control period, after it was added to the accumulator. step: time between two instants of the
  /// observation [s]. Allocates nothing.
  void add(const Observation& o, double step);
  RolloutSeries take() && { return std::move(series_); }

 private:
  /// The values of each joint in one control period; NaN: none.
  struct JointRow {
    JointVector velocity, margin, effort, acceleration, jerk;
  };
  void add_instant(const JointVector& q, const JointVector& velocity, const JointVector& commanded,
                   double step);
  /// Appends the values of all channels in this period.
  void append(MetricSeries& series, const PeriodSpread& spread, const Observation& o) const;
  double distance_from_goal(const Observation& o) const;

  const Scenario& scenario_;
  double threshold_;
  JointVector goal_;  ///< end of the planned motion; empty without one
  JointVector per_velocity_limit_, per_effort_limit_, per_acceleration_limit_;
  JointVector lower_limits_, upper_limits_;
  RolloutSeries series_;
  std::vector<Spread*> spreads_;  ///< [series]: of the accumulator; null for series of other values
  JointRow row_;
  JointVector last_velocity_, last_acceleration_;
  long instants_ = 0;
};

/// Returns the discrete part of a period.
PeriodMode mode_of(const Observation& o);

}  // namespace armtune::internal
