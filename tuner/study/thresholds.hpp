#pragma once
// The thresholds of the checks that the tuned gains must pass in simulation, such as the smallest allowed
// delay margin. A study may change them. A loosened threshold is printed with the verdict.

#include <array>
#include <string>
#include <vector>

namespace armtune::internal {

struct VerdictThresholds {
  double delay_periods = 1.0;  ///< extra torque delay that every loop must tolerate [control periods]
  double gain = 1.2;           ///< common factor on the loop's gains that it must tolerate
  double noise = 2.0;          ///< factor on the sensors' noise that it must tolerate
  double rate = 0.8;           ///< share of the control rate at which it must still be stable
  double yield = 0.95;         ///< share of the random arms that must keep velocity and position limits
  double arms = 200.0;         ///< number of random arms
  double minutes = 30.0;       ///< simulated time that every scenario is extended to
  double rms_growth = 1.2;     ///< largest RMS error of the last minutes over that of the first ones
  double peak_growth = 1.5;    ///< the same of the peaks
};

/// One threshold: its key in a study's `verdict`, its unit, its meaning, its bounds and its strict side.
struct ThresholdField {
  const char* name;
  const char* unit;
  const char* meaning;
  double VerdictThresholds::*value;
  bool larger_is_stricter;
  double least, most;
  bool whole = false;  ///< true if it is a count: only whole numbers are accepted
};

/// Returns every threshold, in the order of the structure.
const std::array<ThresholdField, 9>& threshold_fields();

/// Returns one sentence for each threshold that is looser than its default.
std::vector<std::string> loosened(const VerdictThresholds& thresholds);

}  // namespace armtune::internal
