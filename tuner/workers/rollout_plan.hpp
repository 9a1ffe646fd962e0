#pragma once
// What all workers of a run know before it begins, and the unit of work: one rollout.

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

/// Arms drawn at random in place of the scenarios' own.
struct Draw {
  Perturbation perturbation;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> own = {};  ///< the number that stands for the scenario's own arm, if one does
};

struct RolloutPlan {
  std::vector<Scenario> scenarios;
  Stepper stepper = Stepper::kMidpoint;
  std::optional<Draw> draw;
  /// How many of the scenarios, from the first on, are drawn; the others keep their own arm.
  std::size_t drawn = std::numeric_limits<std::size_t>::max();
  double deadline = 0.0;  ///< of one rollout, wall clock [s]; 0: by its simulated duration
  /// What beside the scenarios has to be the same in every process, such as hashes of files: what, value.
  std::vector<std::pair<std::string, std::string>> facts;
};

struct RolloutJob {
  std::size_t scenario = 0;  ///< index into the plan's
  std::uint64_t sample = 0;  ///< number of the arm; 0 without a draw
  Gains gains;
  EndLimits limits = {};  ///< where the rollout ends before its time
  Engine engine = Engine::kSimbody;
};

/// How long a rollout of the scenario may take [s of wall clock]: what is asked for, or, where that is 0, 20
/// s and twice the simulated duration. Many times what any processor needs: it ends what would never end.
double deadline_of(double asked, const Scenario& scenario);

/// The scenario as the sample's arm meets it.
Scenario arm_of(const RolloutPlan& plan, std::size_t scenario, std::uint64_t sample);

/// Everything two processes must agree on to be workers of one run: what, value. Reads the input files, for
/// their hashes.
std::vector<std::pair<std::string, std::string>> facts_of(const RolloutPlan& plan);

}  // namespace armtune::internal
