#include "tuner/first_task/first_study.hpp"

#include <fmt/format.h>

#include <atomic>

#include "sim/rollout/applies.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kFirstStudy = R"(gains: gains.yaml     # start gains; their objective is 1
scenarios: [task.yaml]

parameters:           # default bounds around the start gains, or {{name: ..., lower: ..., upper: ...}}
  - {{name: task_space_gains_p}}
  - {{name: task_space_gains_d}}
  - {{name: trajectoryDurationErrorGain}}
{orientation_parameters}
objective:
  - {{metric: error/position/max, weight: 1}}
  - {{metric: error/position/rms, weight: 1}}
{orientation_terms}  - {{metric: effort_rate/rms, weight: 0.5}}

constraints:
  - {{metric: joint_velocity/max_ratio, at_most: 0.9}}
  - {{metric: joint_position/min_margin, at_least: 0}}
  - {{metric: joint_effort/max_ratio, at_most: 0.9}}
{more}
# Robust gains: every metric is the worst over the arm and six random arms. For each stability margin, one
# more rollout with extra delay, gain, noise or a lower rate must keep the limits.
robust: {{samples: 6, measure: worst}}
margins: {{delay_periods: 2, gain: 1.5, noise: 2, rate: 0.8}}

search:
  engine: native      # Simbody checks the best gains found
  max_evaluations: 200
  seed: 1
)";

/// Returns constraints on accelerations, if the robot file limits them, and on all contacts that are
/// possible.
std::string more_constraints(const Scenario& scenario) {
  std::string text;
  if (applies(Metric::kJointAccelerationMaxRatio, scenario))
    text = fmt::format("  - {{metric: {}, at_most: 0.9}}\n", name(Metric::kJointAccelerationMaxRatio));
  for (const Metric contact : kContactMetrics) {
    if (applies(contact, scenario)) text += fmt::format("  - {{metric: {}, at_least: 0}}\n", name(contact));
  }
  return text;
}

Study study_of(const Scenario& scenario, const Gains& start) {
  StudyParts parts;
  parts.scenarios = {scenario};
  parts.start = start;
  parts.joints = joint_names(*scenario.robot);
  return parse_study(first_study_yaml(scenario), parts);
}

}  // namespace

std::string first_study_yaml(const Scenario& scenario) {
  const RobotModel& robot = *scenario.robot;
  const bool looks = tracks_orientation(scenario.mask);
  return fmt::format("description: {}\n", yaml::quoted("first gains for " + robot.name)) +
         fmt::format(kFirstStudy, fmt::arg("more", more_constraints(scenario)),
                     fmt::arg("orientation_parameters", looks ? "  - {name: slerpDurationErrorGain}\n" : ""),
                     fmt::arg("orientation_terms", looks ? "  - {metric: error/orientation/max, weight: 1}\n"
                                                           "  - {metric: error/orientation/rms, weight: 1}\n"
                                                         : ""));
}

FirstDemands::FirstDemands(const Scenario& scenario, const Gains& start, int workers)
    : study_(study_of(scenario, start)),
      runner_(simulated_scenarios(study_), study_.stepper, workers, study_.robust) {}

std::string FirstDemands::broken(const Gains& gains) {
  const std::atomic<bool> stop = false;
  Conditions conditions;
  conditions.engine = Engine::kNative;
  const auto results = runner_.run(std::vector{gains}, stop, {}, conditions)->front();
  for (std::size_t s = 0; s < results.size(); ++s) {
    if (results[s].status != RolloutStatus::kCompleted)
      return fmt::format("in {}: {}", simulated_scenarios(study_)[s].name, results[s].reason);
  }
  const Objective objective(study_.terms, study_.constraints, simulated_scenarios(study_), results,
                            study_.name);
  Evaluation e;
  e.gains = gains;
  e.results = results;
  objective.judge(e);
  for (std::size_t c = 0; c < study_.constraints.size(); ++c) {
    if (e.constraints[c] > 0.0)
      return fmt::format("{} is violated with the nominal arm or with one of {} random arms",
                         objective.constraint_name(c), study_.robust->samples);
  }
  return e.feasible ? "" : e.reason;
}

}  // namespace armtune::internal
