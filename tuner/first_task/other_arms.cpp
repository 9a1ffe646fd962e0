#include "tuner/first_task/other_arms.hpp"

#include <atomic>
#include <cstdint>

#include "sim/scenario/perturbation.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/study/thresholds.hpp"

namespace armtune::internal {
namespace {

constexpr std::uint64_t kSeed = 4004;  // gives other arms than those of the study and of its verdict

}  // namespace

int most_lost_arms() {
  return static_cast<int>(0.5 * (1.0 - VerdictThresholds().yield) * kOtherArms);
}

bool nearly_all_hold(const Scenario& scenario, const Gains& gains, int workers) {
  MonteCarloOptions options;
  options.perturbation = default_perturbation({&scenario, 1});
  options.seed = kSeed;
  options.samples = kOtherArms;
  options.engine = Engine::kNative;
  options.workers = workers;
  int lost = 0;
  std::atomic<bool> stop = false;
  options.whole = [&](const MonteCarloSample& sample) {
    if (!sample.keeps_all() && ++lost > most_lost_arms()) stop = true;
  };
  monte_carlo({scenario}, gains, options, stop);
  return lost <= most_lost_arms();
}

}  // namespace armtune::internal
