#include "sim/scenario/scenario_times.hpp"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "armtune/error.hpp"
#include "sim/scenario/planned_motion.hpp"

namespace armtune::internal {
namespace {

constexpr double kMaxPeriods = 1e8;
constexpr double kLongestHold = 3600.0;   // s
constexpr double kLeastTolerance = 1e-6;  // rad, m
constexpr double kRounding = 1e-6;        // of a period: a smaller excess over whole periods adds no period

/// Reads the planned motion. The scenario starts at the beginning of this motion.
void read_planned(const yaml::Node& node, Scenario& scenario) {
  const PlannedFile file = read_planned_node(node);
  scenario.planned = std::make_shared<const JointSpline>(load_planned_motion(file, *scenario.robot));
  scenario.inputs.push_back(file.table.path);
  scenario.start_time = scenario.planned->begin();
  scenario.start_position = scenario.planned->knots().front().position;
  scenario.start_velocity = scenario.planned->knots().front().velocity;
}

/// Reads the duration [s]: a number, or `planned` for the length of the planned motion and `hold_end` [s],
/// rounded up to whole periods. node: null if the key is absent, which means `planned`.
double read_duration(const yaml::Node* node, double hold, const Scenario& scenario) {
  const bool as_planned = node == nullptr || node->is_word("planned");
  if (as_planned && !scenario.planned)
    node->fail("there is no planned trajectory; give the duration in seconds", "a duration in seconds");
  const double period = scenario.control_period;
  const double duration =
      as_planned
          ? std::ceil((scenario.planned->end() - scenario.planned->begin() + hold) / period - kRounding) *
                period
          : node->as_number();
  if (duration >= period && duration <= kMaxPeriods * period) return duration;
  InputFault fault{.problem = fmt::format("{} s is out of range", duration),
                   .value = fmt::to_string(duration),
                   .limit = fmt::format("1 to {:.0e} control periods of {} s", kMaxPeriods, period)};
  if (node != nullptr) node->fail(fault);
  fault.problem = fmt::format("the planned trajectory takes {} s", duration);
  throw InputError(InputPlace{scenario.source, 0, "planned"}, std::move(fault));
}

/// Reads the time for which the arm stays at the end of the planned motion [s].
double read_hold(yaml::MapReader& map, const yaml::Node* duration) {
  const double time = map.number_in("hold_end", 0.0, 0.0, kLongestHold);
  if (time == 0.0) return time;
  const yaml::Node* hold = map.optional("hold_end");
  if (duration != nullptr && !duration->is_word("planned"))
    hold->fail("it has no effect with a duration in seconds; give 'duration: planned'", "duration: planned");
  if (map.has("path") || map.has("orientation") || map.has("targets"))
    hold->fail(
        "the arm does not stay at the end of the planned motion, because the scenario also gives the tool "
        "a path, an orientation or targets; give the duration in seconds",
        "a duration in seconds");
  return time;
}

}  // namespace

void read_times(yaml::MapReader& map, Scenario& scenario) {
  const yaml::Node& period = map.required("control_period");
  scenario.control_period = period.as_number();
  if (scenario.control_period < 1e-5 || scenario.control_period > 0.1) {
    period.fail(InputFault{.problem = fmt::format("the value is {} s", scenario.control_period),
                           .limit = "1e-5 to 0.1 s"});
  }
  if (const yaml::Node* planned = map.optional("planned")) {
    read_planned(*planned, scenario);
    const yaml::Node* duration = map.optional("duration");
    scenario.duration = read_duration(duration, read_hold(map, duration), scenario);
    scenario.goal_tolerance = map.number_in("goal_tolerance", scenario.goal_tolerance, kLeastTolerance, 1.0);
  } else {
    scenario.duration = read_duration(&map.required("duration"), 0.0, scenario);
  }
}

}  // namespace armtune::internal
