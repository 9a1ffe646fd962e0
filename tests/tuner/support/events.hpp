#pragma once
// Events of rollouts.

#include "tests/tuner/report/support/recorded.hpp"
#include "tuner/planning/yardstick/events.hpp"

namespace armtune::internal::test {

/// Those of one kind.
inline std::vector<Event> of_kind(std::vector<Event> events, EventKind kind) {
  std::erase_if(events, [kind](const Event& e) { return e.kind != kind; });
  return events;
}

/// Events of a rollout of the scenario, a row every `stride` periods.
inline std::vector<Event> simulated(const Scenario& scenario, const Gains& gains, int stride) {
  return events_of(recording_of(scenario, gains, stride), scenario, gains.slerpAngularErrorThreshold);
}

}  // namespace armtune::internal::test
