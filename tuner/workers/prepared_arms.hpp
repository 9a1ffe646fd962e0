#pragma once
// A cache of arms that are ready for simulation, one for each scenario and random sample. It keeps the 64
// arms used last, so that memory does not grow with the number of samples.

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim/rollout/prepared_scenario.hpp"
#include "tuner/workers/rollout_plan.hpp"

namespace armtune::internal {

class PreparedArms {
 public:
  /// The plan must outlive the object.
  explicit PreparedArms(const RolloutPlan& plan) : plan_(plan) {}

  std::shared_ptr<const PreparedScenario> at(std::size_t scenario, std::uint64_t sample) {
    constexpr std::size_t kKept = 64;
    ++uses_;
    for (Kept& kept : kept_) {
      if (kept.scenario != scenario || kept.sample != sample) continue;
      kept.used = uses_;
      return kept.arm;
    }
    if (kept_.size() == kKept) {
      kept_.erase(std::min_element(kept_.begin(), kept_.end(),
                                   [](const Kept& a, const Kept& b) { return a.used < b.used; }));
    }
    kept_.push_back(
        {scenario, sample, uses_, std::make_shared<const PreparedScenario>(arm_of(plan_, scenario, sample))});
    return kept_.back().arm;
  }

 private:
  struct Kept {
    std::size_t scenario;
    std::uint64_t sample;
    std::uint64_t used;
    std::shared_ptr<const PreparedScenario> arm;
  };

  const RolloutPlan& plan_;
  std::vector<Kept> kept_;
  std::uint64_t uses_ = 0;
};

}  // namespace armtune::internal
