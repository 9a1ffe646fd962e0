#pragma once
// The data that all workers of a run have before it begins: the scenarios, the integrator and the random
// arms. Also the job of a worker, which is one rollout with given gains.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/plant/engine.hpp"
#include "sim/plant/stepper.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/scenario/perturbation.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// A random draw of arms that replace the scenarios' own arms.
struct Draw {
  Perturbation perturbation;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> own = {};  ///< number that stands for the scenario's own arm, if one does
};

struct RolloutPlan {
  std::vector<Scenario> scenarios;
  Stepper stepper = Stepper::kMidpoint;
  std::optional<Draw> draw;
  /// Number of scenarios, from the first on, whose arm is drawn. The others keep their own arm.
  std::size_t drawn = std::numeric_limits<std::size_t>::max();
  double deadline = 0.0;  ///< for one rollout, wall clock [s]; 0: derived from its duration
  /// Names and values of further facts that must agree in all processes, such as hashes of files.
  std::vector<std::pair<std::string, std::string>> facts;
};

struct RolloutJob {
  std::size_t scenario = 0;  ///< index in the plan
  std::uint64_t sample = 0;  ///< number of the arm; 0 without a draw
  Gains gains;
  EndLimits limits = {};  ///< limits at which the rollout ends early
  Engine engine = Engine::kSimbody;
};

/// Returns the deadline of a rollout [s of wall clock]: `asked`, or, if that is 0, 20 s and twice the
/// simulated duration. The latter is many times what any processor needs. It ends rollouts that would never
/// end.
double deadline_of(double asked, const Scenario& scenario);

/// Returns the scenario with the arm of the sample.
Scenario arm_of(const RolloutPlan& plan, std::size_t scenario, std::uint64_t sample);

/// Returns names and values of all facts on which two processes must agree to work on one run. Reads the
/// input files for their hashes.
std::vector<std::pair<std::string, std::string>> facts_of(const RolloutPlan& plan);

}  // namespace armtune::internal
