#pragma once
// Declares all metrics of a rollout (one simulated scenario) in one place: name, unit, meaning, and a short
// phrase for messages. Studies, result files and reports take their metrics from this list.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armtune::internal {

enum class Metric : std::size_t {
  kPositionXMax,
  kPositionYMax,
  kPositionZMax,
  kPositionRms,
  kPositionMax,
  kOrientationXMax,
  kOrientationYMax,
  kOrientationZMax,
  kOrientationRms,
  kOrientationMax,
  kLinearVelocityRms,
  kLinearVelocityMax,
  kAngularVelocityRms,
  kAngularVelocityMax,
  kSamples,
  kGazeRms,
  kGazeMax,
  kGazeRateErrorRms,
  kGazeRateErrorMax,
  kGazeTimeOutside,
  kReacquisitionTime,
  kJointVelocityMaxRatio,
  kJointVelocityMaxRatioTime,
  kJointPositionMinMargin,
  kJointEffortRms,
  kJointEffortMaxRatio,
  kJointEffortSaturatedPeriods,
  kJointAccelerationMax,
  kJointAccelerationMaxRatio,
  kJointJerkMax,
  kJointErrorRms,
  kJointErrorMax,
  kToolErrorRms,
  kToolErrorMax,
  kGoalSettlingTime,
  kGoalOvershoot,
  kEffortRateRms,
  kObstacleMinClearance,
  kClearanceSelf,
  kClearanceCell,
  kClearanceFloor,
  kCompensationErrorRms,
  kResponseRiseTime,
  kResponseOvershoot,
  kResponseSettlingTime,
  kResponseSteadyStateError,
  kResponseBandwidth,
  kCount
};

inline constexpr std::size_t kMetricCount = static_cast<std::size_t>(Metric::kCount);

/// The metrics that are distances from things that the arm must not touch. A negative value means contact.
inline constexpr std::array kContactMetrics = {Metric::kObstacleMinClearance, Metric::kClearanceSelf,
                                               Metric::kClearanceCell, Metric::kClearanceFloor};

/// The direction in which a metric improves.
enum class Better {
  kLess,
  kMore,
  kNeither  ///< the metric tells where or when something happened, and is not a goal
};

/// The way in which further periods of a rollout can change a metric.
enum class Course {
  kOnlyWorsens,  ///< an extreme or a count over the periods, which never recovers
  kEitherWay
};

struct MetricField {
  const char* name;
  const char* unit;
  Better better;
  Course course;
  const char* words;  ///< a phrase for use in a sentence: "largest position error"
  const char* meaning;
};

/// Returns the fields of all metrics in the order of the enumeration, which is the order of errors.csv.
const std::array<MetricField, kMetricCount>& metric_fields();
inline const MetricField& field(Metric m) {
  return metric_fields()[static_cast<std::size_t>(m)];
}
inline const char* name(Metric m) {
  return field(m).name;
}
/// Returns every metric, in order.
std::vector<Metric> all_metrics();
std::optional<Metric> metric_from_name(std::string_view name);
/// True if larger values are better. False if smaller values are better, or if the metric is not a goal.
inline bool larger_is_better(Metric m) {
  return field(m).better == Better::kMore;
}
/// True for the metrics that further periods only make worse. They can be judged while a rollout runs.
inline bool only_worsens(Metric m) {
  return field(m).course == Course::kOnlyWorsens;
}

/// The metrics of one rollout. A metric for which there was nothing to measure is NaN in memory and an empty
/// cell in files.
struct Metrics {
  std::array<double, kMetricCount> value = filled();
  std::string max_ratio_joint;  ///< name of the joint with the largest velocity ratio

  double operator[](Metric m) const { return value[static_cast<std::size_t>(m)]; }
  double& operator[](Metric m) { return value[static_cast<std::size_t>(m)]; }

 private:
  static constexpr std::array<double, kMetricCount> filled() {
    std::array<double, kMetricCount> a{};
    a.fill(std::numeric_limits<double>::quiet_NaN());
    return a;
  }
};

/// Returns a clause that describes what the arm touched, such as "reaches at least 0.02 m into the floor".
/// Returns an empty text if the arm touched nothing.
std::string contact_text(const Metrics& metrics);

}  // namespace armtune::internal
