#pragma once
// How far gains hold away from the arm and the conditions that they were made for.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "armtune/rollout.hpp"
#include "armtune/verdict.hpp"

namespace armtune {

struct RobustnessOptions {
  std::string folder = {};  ///< new, for all files of the run; empty: nothing is written
  bool resume = false;      ///< continue the run in that folder
  std::uint64_t samples = 1000;
  std::uint64_t seed = 1;
  /// Widths of what differs at random; the rest as it is by default. Names: mass, center, inertia, rotor,
  /// friction, payload, delay, noise, theta, target_speed; `armtune robustness --help` says what they mean.
  std::map<std::string, double> perturbation = {};
  Engine engine = Engine::kSimbody;
  int workers = 1;        ///< threads; results do not depend on it
  double deadline = 0.0;  ///< of one rollout, wall clock [s]; 0: 20 s and twice the simulated duration
  Watch watch = {};
};

/// One random arm in every scenario.
struct RobustnessSample {
  std::uint64_t number = 0;
  std::vector<Rollout> rollouts = {};  ///< one for each scenario, without recordings
  std::vector<std::string> broken =
      {};  ///< one for each scenario: the limit that was broken first; empty: none
  bool keeps_all() const;
};

struct Robustness {
  std::vector<RobustnessSample> samples = {};  ///< in the order of their numbers
  Verdict verdict = {};                        ///< of the yield; without checks if interrupted
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of those in the folder
  /// The share of the samples that keep every limit in every scenario; NaN without samples.
  double yield() const;
};

/// Simulates the gains on random arms. Throws InputError if a width is not valid or the folder is used;
/// FailedError if a file cannot be written.
Robustness robustness(const std::vector<Scenario>& scenarios, const Gains& gains,
                      const RobustnessOptions& options = {});

struct MarginsOptions {
  Engine engine = Engine::kSimbody;  ///< where edges are looked for; Simbody has the last word
  int workers = 1;                   ///< threads; results do not depend on it
  Watch watch = {};
};

/// How far one quantity can be pushed in one scenario until the closed loop no longer stands.
struct Margin {
  std::string kind = {};  ///< such as "torque_delay"
  std::string unit = {};
  std::string scenario = {};
  double nominal = 0.0;               ///< [unit]
  std::optional<double> stands = {};  ///< last value that stood; none: not even the nominal one
  std::optional<double> fails = {};   ///< its neighbour that did not; none: everything that was tried stood
  std::string reason = {};            ///< why it failed
};

/// Every margin in every scenario. Those that were not found before Watch::stop are missing.
std::vector<Margin> margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                            const MarginsOptions& options = {});

}  // namespace armtune
