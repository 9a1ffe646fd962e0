#pragma once
// The one declaration of every metric of a rollout: name, unit, short words for it, meaning.

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
  kJointEffortMaxRatio,
  kJointEffortSaturatedPeriods,
  kJointErrorRms,
  kJointErrorMax,
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

/// Distances from what an arm must not touch: below zero it does.
inline constexpr std::array kContactMetrics = {Metric::kObstacleMinClearance, Metric::kClearanceSelf,
                                               Metric::kClearanceCell, Metric::kClearanceFloor};

/// Which values of a metric are the better ones.
enum class Better {
  kLess,
  kMore,
  kNeither  ///< the metric says where or when something was, and is no goal
};

/// What further periods of a rollout can do to a metric.
enum class Course {
  kOnlyWorsens,  ///< an extreme over the periods: a value that it has passed once stays passed
  kEitherWay
};

struct MetricField {
  const char* name;
  const char* unit;
  Better better;
  Course course;
  const char* words;  ///< as a sentence has them: "largest position error"
  const char* meaning;
};

/// In the order of the enumeration, which is the order of errors.csv.
const std::array<MetricField, kMetricCount>& metric_fields();
inline const MetricField& field(Metric m) {
  return metric_fields()[static_cast<std::size_t>(m)];
}
inline const char* name(Metric m) {
  return field(m).name;
}
/// Every metric, in order.
std::vector<Metric> all_metrics();
std::optional<Metric> metric_from_name(std::string_view name);
/// True if larger values are better; false if smaller ones are, or if the metric is no goal.
inline bool larger_is_better(Metric m) {
  return field(m).better == Better::kMore;
}
/// True for the metrics that can be asked for while a rollout runs: further periods only make them worse.
inline bool only_worsens(Metric m) {
  return field(m).course == Course::kOnlyWorsens;
}

/// Values of one rollout. A metric that had nothing to judge is NaN in memory and an empty cell in files.
struct Metrics {
  std::array<double, kMetricCount> value = filled();
  std::string max_ratio_joint;  ///< joint of joint_velocity/max_ratio

  double operator[](Metric m) const { return value[static_cast<std::size_t>(m)]; }
  double& operator[](Metric m) { return value[static_cast<std::size_t>(m)]; }

 private:
  static constexpr std::array<double, kMetricCount> filled() {
    std::array<double, kMetricCount> a{};
    a.fill(std::numeric_limits<double>::quiet_NaN());
    return a;
  }
};

/// Returns what the arm touched, as a clause: "comes at least 0.02 m into the floor"; empty where it touched
/// nothing.
std::string contact_text(const Metrics& metrics);

}  // namespace armtune::internal
