#include "tuner/session/task_notes.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/path_walk.hpp"

namespace armtune::internal {

void warn_of_task(const Scenario& scenario, const Gains& gains, SessionObserver& observer) {
  const auto [trouble, winds] = find_task_trouble(scenario, gains);
  if (winds) throw InputError(fmt::format("{}: {}", scenario.name, trouble));
  if (!trouble.empty()) observer.warned(fmt::format("{}: {}", scenario.name, trouble));
  if (!controller_kind(gains.controller).learns && start_theta(scenario).isZero(0.0)) {
    observer.warned(fmt::format(
        "{}: the controller {} learns nothing, and the scenario tells it nothing of the arm, not even its "
        "weight; give it 'theta_start: {{model_scale: 1}}', or a theta from armtune identify",
        scenario.name, gains.controller));
  }
}

void refuse_winding(const Scenario& scenario, const Gains& gains) {
  const auto [trouble, winds] = find_task_trouble(scenario, gains);
  if (winds) throw InputError(fmt::format("{}: {}", scenario.name, trouble));
}

}  // namespace armtune::internal
