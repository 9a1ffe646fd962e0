#include "tuner/planning/session/add_yardstick.hpp"

#include <fmt/format.h>

#include <exception>

#include "sim/csv/text_file.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"

namespace armtune::internal {
namespace {

FurtherColumn reacquisition_column(const std::vector<Scenario>& scenarios,
                                   const std::vector<Measure>& measures) {
  FurtherColumn limit;
  limit.column = {
      "reacquisition/limit",
      "s",
      "least possible reacquisition/time of the slowest target switch in the rollout, from the same state of "
      "the arm and within its limits; empty if no plan was found",
      {}};
  limit.values.reserve(scenarios.size());
  for (const Scenario& scenario : scenarios)
    limit.values.push_back(reacquisition_limit(measures, scenario.name));
  return limit;
}

}  // namespace

YardstickFiles add_yardstick(const std::string& folder, const std::vector<Scenario>& scenarios,
                             const GainsOf& gains, const std::atomic<bool>& stop,
                             YardstickObserver& observer) {
  YardstickFiles files;
  try {
    const std::vector<Measure> measures =
        measure_rollouts(folder, scenarios, gains, {}, stop, observer).measures;
    write_text_file(folder + "/yardstick.csv", yardstick_csv(measures));
    files.written = {"yardstick.csv"};
    files.columns = {{"yardstick.csv", yardstick_columns()}};
    if (!stop) files.errors = {reacquisition_column(scenarios, measures)};
  } catch (const std::exception& error) {
    observer.part_is_over();
    observer.warned(
        fmt::format("the run is finished, but the comparison with optimal motions (--yardstick) failed: {}",
                    error.what()));
  }
  return files;
}

}  // namespace armtune::internal
