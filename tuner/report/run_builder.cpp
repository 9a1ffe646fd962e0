#include "tuner/report/run_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "armtune/error.hpp"
#include "core/common/input_place.hpp"
#include "tuner/report/replay.hpp"

namespace armtune::internal::report {
namespace {

struct GroupOf {
  const char* prefix;
  const char* group;
  const char* unit;
};

/// Plots and units of columns, by the beginning of the name.
constexpr GroupOf kGroups[] = {{"tool/position/", "position", "m"},
                               {"desired/position/", "position", "m"},
                               {"error/position/", "position_error", "m"},
                               {"error/orientation/", "orientation_error", "rad"},
                               {"error/linear_velocity/", "linear_velocity_error", "m/s"},
                               {"error/angular_velocity/", "angular_velocity_error", "rad/s"},
                               {"gaze/angle", "gaze", "rad"},
                               {"compensation_error", "theta", "N m"},
                               {"obstacle/distance", "clearance", "m"},
                               {"clearance/", "clearance", "m"},
                               {"manipulability", "manipulability", "m^3"}};

/// Returns the times of the rows [s]. Throws InputError naming file and line.
std::vector<double> rising_times(const NumberTable& table) {
  constexpr double kMost = 1e9;  // [s]
  const std::vector<double>& times = table.numbers(table.column("time"));
  for (std::size_t r = 0; r < times.size(); ++r) {
    if (!(std::abs(times[r]) <= kMost)) {
      throw InputError(at_line(table.name(), r + 2, "time"),
                       fmt::format("{} in the column 'time' is not a time between -{:g} and {:g} s",
                                   shown_cell(times[r]), kMost, kMost));
    }
    if (r > 0 && times[r] < times[r - 1]) {
      throw InputError(
          at_line(table.name(), r + 2, "time"),
          fmt::format("time {} comes after {}; times must not decrease", times[r], times[r - 1]));
    }
  }
  return times;
}

}  // namespace

std::string shown_cell(double number) {
  return std::isnan(number) ? "an empty cell" : fmt::format("{}", number);
}

bool is_task_column(std::string_view name) {
  return std::any_of(std::begin(kGroups), std::end(kGroups),
                     [name](const GroupOf& g) { return name.starts_with(g.prefix); });
}

RunBuilder::RunBuilder(const NumberTable& table, const Resolution& resolution)
    : table_(table),
      time_(rising_times(table)),
      since_(time_),
      buckets_(time_.size(), resolution.buckets),
      replay_rate_(resolution.replay_rate) {
  for (double& t : since_) t -= began();
  if (!since_.empty()) run.end = since_.back();
  run.time = quantize(buckets_.times(since_));
}

void RunBuilder::add(const std::string& name, const std::string& group, const char* unit,
                     const std::vector<double>& values) {
  run.columns.push_back({name, group, unit, quantize(buckets_.extremes(values))});
}

void RunBuilder::add_task_columns() {
  for (const GroupOf& g : kGroups) {
    for (std::size_t c = 0; c < table_.header().size(); ++c) {
      const std::string& name = table_.header()[c];
      if (!name.starts_with(g.prefix)) continue;
      const bool error = name.starts_with("error/");
      add(name, g.group, g.unit,
          error ? tracked(table_, c, name.starts_with("error/position/")) : table_.numbers(c));
    }
  }
}

void RunBuilder::add_replay(const SceneScenario* scenario, const Arm* arm) {
  if (scenario != nullptr && arm != nullptr && !time_.empty())
    run.replay = replay_of(table_, *scenario, *arm, time_, replay_rate_);
}

}  // namespace armtune::internal::report
