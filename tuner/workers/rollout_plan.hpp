#pragma once
// The plan of a run and the job of a worker. The plan contains the data that all workers get before the run
// begins: the scenarios, the integrator and the random arms. A job is one rollout with given gains.

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

/// The random arms that replace the scenarios' own arms.
struct Draw {
  Perturbation perturbation;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> own = {};  ///< sample number of the scenario's own arm, if it is used too
};

struct RolloutPlan {
  std::vector<Scenario> scenarios;
  Stepper stepper = Stepper::kMidpoint;
  std::optional<Draw> draw;  ///< none: all scenarios keep their own arms
  /// The first `drawn` scenarios are simulated with the arms of `draw`. The others keep their own arms.
  std::size_t drawn = std::numeric_limits<std::size_t>::max();
  double deadline = 0.0;  ///< for one rollout, wall clock [s]; 0: derived from its duration
  /// Names and values of further facts that must be the same in all processes, such as hashes of files.
  std::vector<std::pair<std::string, std::string>> facts;
};

struct RolloutJob {
  std::size_t scenario = 0;  ///< index in the plan
  std::uint64_t sample = 0;  ///< number of the arm; 0 without a draw
  Gains gains;
  EndLimits limits = {};  ///< limits at which the rollout ends early
  Engine engine = Engine::kSimbody;
  std::vector<Metric> series = {};  ///< metrics whose series the result shall have (rollout_series.hpp)
};

/// Returns the deadline of a rollout, wall clock [s]. This is `asked` or, if `asked` is 0, the sum of 20 s
/// and twice the simulated duration. The sum is many times the time that any processor needs. It ends only
/// rollouts that would never end.
double deadline_of(double asked, const Scenario& scenario);

/// Returns the scenario with the arm of the sample.
Scenario arm_of(const RolloutPlan& plan, std::size_t scenario, std::uint64_t sample);

/// Returns names and values of all facts that must be the same in all processes of a run. They include the
/// hashes of the input files.
std::vector<std::pair<std::string, std::string>> facts_of(const RolloutPlan& plan);

}  // namespace armtune::internal
