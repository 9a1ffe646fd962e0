#pragma once
// A scenario, gains and options of the public interface for searches that take little time.

#include "armtune/tune.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal::test {

/// The bundled scenario moving_target, but of 8 s.
inline armtune::Scenario short_scenario() {
  armtune::Scenario scenario = armtune::Scenario::load("moving_target");
  scenario.set_duration(8.0);
  scenario.set_name("short");
  return scenario;
}

/// Gains that move the arm to its task sooner.
inline armtune::Gains quick(const armtune::Scenario& scenario) {
  return {quick_gains(scenario.inside()), scenario.robot().joints()};
}

/// Options of a search without an analysis after it.
inline armtune::TuneOptions brief() {
  armtune::TuneOptions options;
  options.analysis = false;
  return options;
}

}  // namespace armtune::internal::test
