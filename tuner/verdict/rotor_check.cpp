#include "tuner/verdict/rotor_check.hpp"

#include <fmt/format.h>

#include <mutex>
#include <optional>
#include <vector>

#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tuner/robustness/margins.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {

bool add_rotor_check(const Study& study, const Gains& gains, const DeepCheckOptions& options,
                     const std::atomic<bool>& stop, SimulationVerdict& verdict) {
  struct Corner {
    const Scenario* scenario = nullptr;
    double factor = 1.0;
    std::optional<LoopFailure> why;
  };
  std::vector<Corner> corners;
  for (const Scenario& scenario : study.scenarios) {
    if (scenario.robot->estimated_rotors.empty()) continue;
    corners.push_back({&scenario, 1.0 / kRotorFactor, {}});
    corners.push_back({&scenario, kRotorFactor, {}});
  }
  if (corners.empty()) return true;
  MarginOptions how;
  how.stepper = study.stepper;
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(corners.size(), options.workers, stop, [&](std::size_t, std::size_t job) {
    Corner& corner = corners[job];
    corner.why = loop_failure(with_rotors_scaled(*corner.scenario, corner.factor), gains, how, stop);
    const std::lock_guard lock(mutex);
    if (options.progress) options.progress("rotor inertia changes", ++done, corners.size());
  });
  if (stop) return false;
  Check check{CheckKind::kRotorEstimate};
  check.threshold = kRotorFactor;
  for (const Corner& corner : corners) {
    if (!check.passed || corner.why->holds()) continue;
    check.passed = false;
    check.joint = corner.why->joint;
    check.time = corner.why->time;
    check.scenario = corner.scenario->name;
    check.detail = fmt::format("with {:.3g} times the estimated rotor inertia, the closed loop fails ({})",
                               corner.factor, corner.why->text);
  }
  verdict.checks.push_back(std::move(check));
  return true;
}

}  // namespace armtune::internal
