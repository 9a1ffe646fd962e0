#include "tuner/verdict/rollout_checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace armtune::internal {
namespace {

CheckKind check_of(JointLimit limit) {
  switch (limit) {
    case JointLimit::kVelocity:
      return CheckKind::kVelocityLimit;
    case JointLimit::kPosition:
      return CheckKind::kPositionLimit;
    case JointLimit::kEffort:
      return CheckKind::kEffortLimit;
    case JointLimit::kAcceleration:
      break;
  }
  return CheckKind::kAccelerationLimit;
}

std::string named(const std::string& scenario, const std::string& set) {
  return set.empty() ? scenario : fmt::format("{} under {}", scenario, set);
}

void describe(const BrokenLimit& broken, Check& check) {
  check.joint = broken.joint;
  check.time = broken.time;
  check.value = std::abs(broken.value);
  check.threshold = std::abs(broken.bound);
  check.unit = broken.unit;
  if (broken.limit == JointLimit::kPosition) {  // the sign shows which of the two limits
    check.value = broken.value;
    check.threshold = broken.bound;
  }
}

/// The checks that belong to kContactMetrics, in the same order. All except the first follow the order of the
/// kinds of clearance.
constexpr std::array kContactKinds = {CheckKind::kContact, CheckKind::kSelf, CheckKind::kCell,
                                      CheckKind::kFloor};
static_assert(kContactKinds.size() == kContactMetrics.size() && kContactKinds.size() == kClearances + 1);

bool is_point(const MovingObstacle& obstacle) {
  return obstacle.radius == 0.0;
}

/// True if the scenario has no cell, although the arm's file has shapes.
bool has_unused_shapes(const Scenario& scenario) {
  return !scenario.clearance && !scenario.robot->shapes.empty();
}

}  // namespace

void add_rollout_checks(const std::vector<ScenarioResult>& results, const std::string& set,
                        SimulationVerdict& verdict) {
  Check completed{CheckKind::kCompleted};
  for (const ScenarioResult& r : results) {
    if (r.result.status == RolloutStatus::kCompleted || !completed.passed) continue;
    completed.passed = false;
    completed.scenario = named(r.scenario, set);
    completed.time = r.result.end_time;
    completed.detail = r.result.reason;
  }
  verdict.checks.push_back(std::move(completed));
  const bool accelerations = std::any_of(results.begin(), results.end(), [](const ScenarioResult& r) {
    return !std::isnan(r.result.metrics[Metric::kJointAccelerationMaxRatio]);
  });
  for (const JointLimit limit : kJointLimits) {
    if (limit == JointLimit::kAcceleration && !accelerations) continue;  // the arm has no such limit
    Check check{check_of(limit)};
    for (const ScenarioResult& r : results) {
      for (const BrokenLimit& broken : r.broken) {
        if (broken.limit != limit || (!check.passed && check.time <= broken.time)) continue;
        check.passed = false;
        check.scenario = named(r.scenario, set);
        describe(broken, check);
      }
    }
    verdict.checks.push_back(std::move(check));
  }
  Check oscillation{CheckKind::kOscillation};
  for (const ScenarioResult& r : results) {
    if (!r.shake || (!oscillation.passed && oscillation.time <= r.shake->time)) continue;
    oscillation.passed = false;
    oscillation.scenario = named(r.scenario, set);
    oscillation.joint = r.shake->joint;
    oscillation.time = r.shake->time;
    oscillation.detail = swing_text(*r.shake);
  }
  verdict.checks.push_back(std::move(oscillation));
}

void add_contact_checks(const std::vector<Scenario>& scenarios, const std::vector<ScenarioResult>& results,
                        const std::string& set, SimulationVerdict& verdict) {
  for (std::size_t i = 0; i < kContactMetrics.size(); ++i) {
    const Metric metric = kContactMetrics[i];
    Check contact{kContactKinds[i]};
    contact.threshold = 0.0;
    contact.unit = "m";
    for (std::size_t s = 0; s < results.size(); ++s) {
      // An obstacle without a radius is a point, which nothing touches.
      if (metric == Metric::kObstacleMinClearance &&
          std::all_of(scenarios[s].obstacles.begin(), scenarios[s].obstacles.end(), is_point))
        continue;
      const double clearance = results[s].result.metrics[metric];
      if (std::isnan(clearance) || clearance >= contact.value) continue;
      contact.value = clearance;
      contact.passed = clearance >= 0.0;
      contact.scenario = named(results[s].scenario, set);
      if (metric == Metric::kObstacleMinClearance) continue;
      const LeastClearance& least = results[s].nearest[i - 1];
      if (least.pair == nullptr) continue;
      contact.detail = scenarios[s].clearance->name(*least.pair);
      contact.time = least.time;
    }
    if (!std::isnan(contact.value)) verdict.checks.push_back(std::move(contact));
  }
}

void add_shake_notes(const std::vector<ScenarioResult>& results, const std::string& set,
                     SimulationVerdict& verdict) {
  for (const ScenarioResult& r : results) {
    if (r.shake)
      verdict.notes.push_back(fmt::format("in {}, {}", named(r.scenario, set), to_string(*r.shake)));
  }
}

void add_unchecked_contacts(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict) {
  const auto without = [&](Clearance kind) {
    std::vector<std::string> names;
    for (const Scenario& scenario : scenarios) {
      if (!scenario.clearance || !scenario.clearance->has(kind)) names.push_back(scenario.name);
    }
    return names;
  };
  const auto add = [&](const std::string& what, const std::vector<std::string>& names) {
    if (names.empty()) return;
    const bool all = names.size() == scenarios.size();
    add_once(all ? what : fmt::format("{} in {}", what, fmt::join(names, ", ")), verdict.not_checked);
  };
  double unseen = 0.0;
  for (const Scenario& scenario : scenarios) {
    if (scenario.clearance)
      unseen = std::max(unseen, scenario.clearance->most_unseen(scenario.control_period));
  }
  if (unseen > 0.0) {
    add_once(fmt::format(
                 "contact in the time between two control periods (at the velocity limits, the arm's motion "
                 "can bring bodies up to {:.2g} mm closer in this time)",
                 1e3 * unseen),
             verdict.not_checked);
  }
  std::vector<std::string> without_cell, without_shapes;
  for (const Scenario& scenario : scenarios) {
    if (scenario.clearance && scenario.clearance->has(Clearance::kSelf)) continue;
    (has_unused_shapes(scenario) ? without_cell : without_shapes).push_back(scenario.name);
  }
  add("self-collision (write 'cell: {}' in the scenario to check it)", without_cell);
  add("self-collision (no shapes of links that could touch are known)", without_shapes);
  const auto no_floor = without(Clearance::kFloor);
  const auto no_parts = without(Clearance::kCell);
  if (no_floor == no_parts) return add("collisions with floor and table", no_floor);
  add("collisions with the floor", no_floor);
  add("collisions with a table or other things around the arm", no_parts);
}

void add_endurance_checks(const std::vector<EnduranceResult>& results, const VerdictThresholds& thresholds,
                          const std::string& set, SimulationVerdict& verdict) {
  Check limits{CheckKind::kEndurance};
  Check growth{CheckKind::kErrorGrowth};
  growth.threshold = thresholds.rms_growth;
  bool compared = false;
  for (const EnduranceResult& r : results) {
    if (!r.held() && r.shake) {
      verdict.notes.push_back(
          fmt::format("in {}, when it is extended, {}", named(r.scenario, set), to_string(*r.shake)));
    }
    if (!r.held() && (limits.passed || (r.broken && r.broken->time < limits.time))) {
      limits.passed = false;
      limits.scenario = named(r.scenario, set);
      if (r.broken) {
        limits.detail = name(r.broken->limit);
        describe(*r.broken, limits);
      } else {
        limits.detail = r.ended;
        limits.time = r.simulated;
      }
    }
    if (!r.held() || std::isnan(r.rms_growth)) continue;  // there are no errors to compare
    compared = true;
    const bool rms = r.rms_growth > thresholds.rms_growth;
    const bool peak = r.peak_growth > thresholds.peak_growth;
    if (!rms && !peak) {
      if (growth.passed && !(r.rms_growth <= growth.value)) growth.value = r.rms_growth;
      continue;
    }
    if (!growth.passed) continue;
    growth.passed = false;
    growth.scenario = named(r.scenario, set);
    growth.detail = rms ? "RMS error of the last minutes divided by the RMS error of the first minutes"
                        : "peak error of the last minutes divided by the peak error of the first minutes";
    growth.value = rms ? r.rms_growth : r.peak_growth;
    growth.threshold = rms ? thresholds.rms_growth : thresholds.peak_growth;
  }
  verdict.checks.push_back(std::move(limits));
  if (compared) {
    verdict.checks.push_back(std::move(growth));
  } else {
    add_once(
        named("error growth (no completed scenario tracks its path in both its first and its last minutes)",
              set),
        verdict.not_checked);
  }
}

void add_unchecked_rotors(const std::vector<Scenario>& scenarios, SimulationVerdict& verdict) {
  const bool any = std::any_of(scenarios.begin(), scenarios.end(), [](const Scenario& scenario) {
    return !scenario.robot->estimated_rotors.empty();
  });
  if (any)
    verdict.not_checked.emplace_back("rotor inertia that differs from the estimate (armtune robustness)");
}

void add_unchecked(const std::vector<Scenario>& scenarios, bool extended, SimulationVerdict& verdict) {
  if (!extended) verdict.not_checked.emplace_back("what happens after the scenarios end (--endurance)");
  verdict.not_checked.emplace_back("stability margins (armtune margins)");
  verdict.not_checked.emplace_back("arms that differ from the model (armtune robustness)");
  add_unchecked_rotors(scenarios, verdict);
  add_unchecked_contacts(scenarios, verdict);
  verdict.not_checked.insert(verdict.not_checked.end(), never_checked().begin(), never_checked().end());
}

}  // namespace armtune::internal
