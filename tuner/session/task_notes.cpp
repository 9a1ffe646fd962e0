#include "tuner/session/task_notes.hpp"

#include <fmt/format.h>

#include <set>
#include <string>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/plausibility.hpp"
#include "sim/scenario/task_trouble.hpp"

namespace armtune::internal {

std::vector<std::string> warn_of_task(const Scenario& scenario, const Gains& gains,
                                      SessionObserver& observer) {
  std::vector<std::string> warnings;
  const auto [trouble, winds] = find_task_trouble(scenario, gains);
  if (winds) throw InputError(fmt::format("{}: {}", scenario.name, trouble));
  if (!trouble.empty()) warnings.push_back(fmt::format("{}: {}", scenario.name, trouble));
  const double end = scenario.start_time + scenario.duration;
  if (scenario.path.spline && scenario.path.spline->begin() >= end) {
    warnings.push_back(fmt::format(
        "{}: the path's waypoints begin at {:.4g} s, but the scenario ends at {:.4g} s; if their times are "
        "not in seconds, give the unit, as in 'units: {{time: ms}}'",
        scenario.name, scenario.path.spline->begin(), end));
  }
  if (!controller_kind(gains.controller).learns && start_theta(scenario).isZero(0.0)) {
    warnings.push_back(fmt::format(
        "{}: the controller {} does not adapt, and the scenario gives it no model of the arm, not even its "
        "weight; add 'theta_start: {{model_scale: 1}}', or 'file' under 'theta_start', with the "
        "theta.yaml that armtune identify wrote",
        scenario.name, gains.controller));
  }
  for (const std::string& warning : warnings) observer.warned(warning);
  return warnings;
}

void warn_of_doubts(const std::vector<Scenario>& scenarios, SessionObserver& observer) {
  std::set<std::string> told;
  for (const Scenario& scenario : scenarios) {
    const RobotModel& robot = *scenario.robot;
    if (!told.insert(robot.source + "\n" + robot.name).second) continue;
    for (const std::string& doubt : doubts(robot)) observer.warned(fmt::format("{}: {}", robot.name, doubt));
  }
}

void refuse_winding(const Scenario& scenario, const Gains& gains) {
  const auto [trouble, winds] = find_task_trouble(scenario, gains);
  if (winds) throw InputError(fmt::format("{}: {}", scenario.name, trouble));
}

}  // namespace armtune::internal
