#pragma once
// The robustness of gains: how they perform on arms that differ at random from the model, and their stability
// margins.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "armtune/rollout.hpp"
#include "armtune/verdict.hpp"

namespace armtune {

struct RobustnessOptions {
  std::string folder = {};  ///< new folder for all files of the run; empty: nothing is written
  bool resume = false;      ///< resume the run in that folder
  std::uint64_t samples = 1000;
  std::uint64_t seed = 1;
  /// Widths of the random differences between an arm and the model, by name. Names that are left out have
  /// default widths. Names: mass, center, inertia, rotor, friction, payload, delay, noise, theta,
  /// target_speed. `armtune robustness --help` explains them.
  std::map<std::string, double> perturbation = {};
  /// File with a joint distribution, such as the uncertainty.yaml of a calibration, from which friction,
  /// rotor inertia, gains of drives, delay, payload, tilt and encoder offsets are drawn; empty: none. With
  /// it, mass, center, inertia and payload are zero by default, and rotor, friction and delay must not be
  /// given.
  std::string distribution = {};
  Engine engine = Engine::kSimbody;
  int workers = 1;        ///< threads; results do not depend on it
  double deadline = 0.0;  ///< wall-clock limit of a rollout [s]; 0: 20 s plus twice its simulated duration
  Watch watch = {};
};

/// One random arm, simulated in every scenario.
struct RobustnessSample {
  std::uint64_t number = 0;
  std::vector<Rollout> rollouts = {};  ///< one for each scenario, without recordings
  std::vector<std::string> broken =
      {};  ///< one for each scenario: the limit that was broken first; empty: none
  /// True if the arm kept every limit in every scenario.
  bool keeps_all() const;
};

struct Robustness {
  std::vector<RobustnessSample> samples = {};  ///< in the order of their numbers
  Verdict verdict = {};                        ///< verdict on yield(); without checks if interrupted
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
  /// Returns the share of the samples that keep every limit in every scenario; NaN without samples.
  double yield() const;
};

/// Simulates the gains on random arms. Throws InputError if a width is not valid, the distribution does not
/// fit the arm or the folder is in use; FailedError if a file cannot be written.
Robustness robustness(const std::vector<Scenario>& scenarios, const Gains& gains,
                      const RobustnessOptions& options = {});

struct MarginsOptions {
  std::string folder = {};           ///< new folder for all files of the run; empty: nothing is written
  Engine engine = Engine::kSimbody;  ///< engine that searches for margins; Simbody confirms each one
  int workers = 1;                   ///< threads; results do not depend on it
  Watch watch = {};
};

/// A stability margin: how far one quantity can change in one scenario before the closed loop fails.
struct Margin {
  std::string kind = {};  ///< such as "torque_delay"
  std::string unit = {};
  std::string scenario = {};
  double nominal = 0.0;               ///< nominal value [unit]
  std::optional<double> stands = {};  ///< last value that passed; none: the nominal value already fails
  std::optional<double> fails = {};   ///< next value, which failed; none: every value tried passed
  std::string reason = {};            ///< why it failed
};

struct Margins {
  std::vector<Margin> margins = {};  ///< each margin in each scenario; fewer if interrupted
  /// One check for each kind of margin, which passes if the loop is stable without a change. Without checks
  /// if interrupted.
  Verdict verdict = {};
  bool interrupted = false;
  std::vector<std::string> files = {};  ///< names of the files in the folder
};

/// Finds every margin in every scenario. Throws InputError if the gains are not valid for the arm of a
/// scenario or the folder is in use; FailedError if a file cannot be written.
Margins margins(const std::vector<Scenario>& scenarios, const Gains& gains,
                const MarginsOptions& options = {});

}  // namespace armtune
