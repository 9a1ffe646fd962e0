#pragma once
// The thresholds of the checks that the tuned gains must pass in simulation, such as the smallest allowed
// delay margin. A study may change them. A threshold that is less strict than the default is printed with the
// verdict.

#include <array>
#include <string>
#include <vector>

namespace armtune::internal {

struct VerdictThresholds {
  double delay_periods = 1.0;  ///< additional torque delay that the loop must tolerate [control periods]
  double gain = 1.2;           ///< common factor on the gains that the loop must tolerate
  double noise = 2.0;          ///< factor on the sensor noise that the loop must tolerate
  double rate = 0.8;           ///< factor on the control rate that the loop must tolerate
  double yield = 0.95;         ///< share of the random arms that must keep their limits
  double arms = 200.0;         ///< number of random arms
  double minutes = 30.0;       ///< simulated time to which every scenario is extended [min]
  double rms_growth = 1.2;     ///< largest ratio of the RMS errors in the last and in the first minutes
  double peak_growth = 1.5;    ///< largest ratio of the peak errors in the last and in the first minutes
};

/// One threshold: its key in a study's `verdict`, its unit, its meaning, its bounds, and the direction in
/// which it is stricter.
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

/// Returns one sentence for each threshold that is less strict than its default.
std::vector<std::string> loosened(const VerdictThresholds& thresholds);

}  // namespace armtune::internal
