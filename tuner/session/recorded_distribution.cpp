#include "tuner/session/recorded_distribution.hpp"

#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal {

std::optional<DistributionFacts> distribution_facts(const Perturbation& perturbation) {
  if (!perturbation.distribution) return std::nullopt;
  DistributionFacts facts;
  facts.file = shown_path(perturbation.distribution->file);
  for (const ArmParameter& p : perturbation.distribution->parameters) {
    (p.is_drawn() ? facts.drawn : facts.not_drawn).push_back(p.name);
    if (!p.told) facts.not_told.push_back(p.name);
  }
  return facts;
}

void add_distribution(const Perturbation& perturbation, std::vector<std::string>& inputs) {
  if (perturbation.distribution) inputs.push_back(perturbation.distribution->file);
}

}  // namespace armtune::internal
