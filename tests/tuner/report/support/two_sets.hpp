#pragma once
// Tables of results that are made up.

#include <string>
#include <utility>
#include <vector>

#include "sim/rollout/error_report.hpp"
#include "tuner/report/tables.hpp"

namespace armtune::internal::test {

/// A result with these metrics alone.
inline ScenarioResult result_of(const std::string& scenario,
                                const std::vector<std::pair<Metric, double>>& values,
                                const std::string& joint = "elbow",
                                RolloutStatus status = RolloutStatus::kCompleted) {
  ScenarioResult result;
  result.scenario = scenario;
  result.result.status = status;
  result.result.metrics.max_ratio_joint = joint;
  for (const auto& [metric, value] : values) result.result.metrics[metric] = value;
  return result;
}

inline CsvTable errors_of(const std::vector<ScenarioResult>& results) {
  return CsvTable::parse(errors_csv(results), "errors.csv");
}

/// Scenarios a and b under start and tuned gains.
inline std::vector<report::Table> two_sets() {
  const auto start = errors_of({result_of("a", {{Metric::kOrientationMax, 0.4},
                                                {Metric::kPositionMax, 0.01},
                                                {Metric::kEffortRateRms, 100.0},
                                                {Metric::kObstacleMinClearance, 0.2},
                                                {Metric::kJointVelocityMaxRatio, 0.7},
                                                {Metric::kJointVelocityMaxRatioTime, 2.0}}),
                                result_of("b", {{Metric::kOrientationMax, 0.9},
                                                {Metric::kJointVelocityMaxRatio, 0.6},
                                                {Metric::kJointVelocityMaxRatioTime, 5.0}})});
  const auto tuned = errors_of({result_of("a",
                                          {{Metric::kOrientationMax, 0.1},
                                           {Metric::kPositionMax, 0.01},
                                           {Metric::kEffortRateRms, 150.0},
                                           {Metric::kObstacleMinClearance, 0.1},
                                           {Metric::kJointVelocityMaxRatio, 0.5},
                                           {Metric::kJointVelocityMaxRatioTime, 1.0}},
                                          "shoulder"),
                                result_of("b",
                                          {{Metric::kOrientationMax, 0.1},
                                           {Metric::kJointVelocityMaxRatio, 0.88},
                                           {Metric::kJointVelocityMaxRatioTime, 6.012}},
                                          "wrist")});
  return report::tables_of({start, tuned});
}

}  // namespace armtune::internal::test
