#include "tuner/cli/yardstick_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "sim/csv/text_file.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/yardstick_measures.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"

namespace armtune::internal::cli {
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

YardstickFiles write_yardstick(const std::string& folder, const std::vector<Scenario>& scenarios,
                               const std::function<Gains(const Scenario&)>& gains) {
  YardstickFiles files;
  try {
    say(fmt::format("comparison of {} with optimal motions within the arm's limits:\n", folder));
    const std::vector<Measure> measures = measure_rollouts(folder, scenarios, gains, {}).measures;
    write_text_file(folder + "/yardstick.csv", yardstick_csv(measures));
    files.written = {"yardstick.csv"};
    files.columns = {{"yardstick.csv", yardstick_columns()}};
    if (!stop_requested()) files.errors = {reacquisition_column(scenarios, measures)};
  } catch (const std::exception& error) {
    fmt::print(stderr,
               "armtune: warning: the run is finished, but the comparison with optimal motions (--yardstick) "
               "failed: {}\n",
               error.what());
  }
  return files;
}

}  // namespace

void add_yardstick_option(CLI::App& command, bool& wanted) {
  command.add_flag(
      "--yardstick", wanted,
      "also compare every target switch, every return to the path and every lap with an optimal motion "
      "within the arm's limits; writes yardstick.csv, and the column 'reacquisition/limit' in errors.csv "
      "(see armtune yardstick)");
}

Yardstick yardstick_if(bool wanted) {
  return wanted ? Yardstick(write_yardstick) : Yardstick();
}

}  // namespace armtune::internal::cli
