#include "tuner/workers/rollout_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "core/control/laws/joint_drives.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {

double deadline_of(double asked, const Scenario& scenario) {
  constexpr double kAnyhow = 20.0;
  constexpr double kPerSecond = 2.0;
  const int steps =
      steps_in(scenario.control_period, std::max(scenario.plant.rate, scenario.robot->drive_rate));
  return asked > 0.0 ? asked : kAnyhow + kPerSecond * scenario.duration * steps;
}

Scenario arm_of(const RolloutPlan& plan, std::size_t scenario, std::uint64_t sample) {
  const Scenario& own = plan.scenarios[scenario];
  const bool as_it_is = !plan.draw || scenario >= plan.drawn || plan.draw->own == sample;
  return as_it_is ? own : perturbed(own, plan.draw->perturbation, plan.draw->seed, sample);
}

std::vector<std::pair<std::string, std::string>> facts_of(const RolloutPlan& plan) {
  auto facts = plan.facts;
  facts.emplace_back("number of scenarios", fmt::format("{}", plan.scenarios.size()));
  for (const Scenario& scenario : plan.scenarios) {
    facts.emplace_back(fmt::format("duration and control period of {}", scenario.name),
                       fmt::format("{} s, {} s", scenario.duration, scenario.control_period));
    const std::set<std::string> files(scenario.inputs.begin(), scenario.inputs.end());
    for (const std::string& file : files) {
      // Folders may differ from machine to machine, contents may not.
      facts.emplace_back(
          fmt::format("{} of {}", std::filesystem::path(file).filename().string(), scenario.name),
          hash_of_input(file));
    }
  }
  facts.emplace_back("program", hash_of_file("/proc/self/exe"));
  facts.emplace_back("stepper", name(plan.stepper));
  facts.emplace_back("rollout deadline", fmt::format("{}", plan.deadline));
  facts.emplace_back("seed of the random arms",
                     plan.draw ? fmt::format("{}", plan.draw->seed) : "no random arms");
  if (plan.draw) {
    for (const PerturbationField& field : perturbation_fields()) {
      facts.emplace_back(field.name, fmt::format("{}", plan.draw->perturbation.*field.width));
    }
    facts.emplace_back("phases", plan.draw->perturbation.phases ? "random" : "fixed");
    if (const auto& distribution = plan.draw->perturbation.distribution)
      facts.emplace_back("distribution of the random arms", hash_of_input(distribution->file));
  }
  return facts;
}

}  // namespace armtune::internal
