#include "tuner/study/thresholds.hpp"

#include <fmt/format.h>

namespace armtune::internal {

const std::array<ThresholdField, 9>& threshold_fields() {
  static constexpr std::array<ThresholdField, 9> fields{{
      {"delay_periods", "control periods",
       "extra delay of torques, or of commands to drives, that the loop must tolerate",
       &VerdictThresholds::delay_periods, true, 0.0, 1000.0, true},
      {"gain", "1", "common factor on the gains that the loop must tolerate", &VerdictThresholds::gain, true,
       1.0, 100.0},
      {"noise", "1", "factor on the sensor noise that the loop must tolerate", &VerdictThresholds::noise,
       true, 1.0, 1000.0},
      {"rate", "1", "lowest control rate that the loop must tolerate, as a share of the scenario's rate",
       &VerdictThresholds::rate, false, 0.01, 1.0},
      {"yield", "1", "share of the random arms that must keep their limits", &VerdictThresholds::yield, true,
       0.0, 1.0},
      {"arms", "1", "number of random arms", &VerdictThresholds::arms, true, 1.0, 100000.0, true},
      {"minutes", "min", "simulated time to which every scenario is extended", &VerdictThresholds::minutes,
       true, 0.0, 1440.0},
      {"rms_growth", "1",
       "largest allowed RMS error of the last minutes, divided by that of the first minutes",
       &VerdictThresholds::rms_growth, false, 1.0, 1000.0},
      {"peak_growth", "1",
       "largest allowed peak error of the last minutes, divided by that of the first minutes",
       &VerdictThresholds::peak_growth, false, 1.0, 1000.0},
  }};
  return fields;
}

std::vector<std::string> loosened(const VerdictThresholds& thresholds) {
  std::vector<std::string> sentences;
  const VerdictThresholds usual;
  for (const ThresholdField& field : threshold_fields()) {
    const double now = thresholds.*field.value;
    const double before = usual.*field.value;
    const bool looser = field.larger_is_stricter ? now < before : now > before;
    if (!looser) continue;
    sentences.push_back(fmt::format("the threshold '{}' is loosened from {} to {}", field.name, before, now));
  }
  return sentences;
}

}  // namespace armtune::internal
