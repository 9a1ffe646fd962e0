#pragma once
// A study that takes seconds: the UR10 over two scenarios of 8 s, two free gains.

#include <string>

#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal::test {

inline const std::string kShortParameters =
    "parameters:\n"
    "  - {name: task_space_gains_p/rx, lower: 10, upper: 60}\n"
    "  - {name: slerpDurationErrorGain, lower: 1, upper: 4, scale: linear}\n";
inline const std::string kShortObjective =
    "objective:\n"
    "  - {metric: error/orientation/rms, weight: 2}\n"
    "  - {metric: error/position/max, weight: 1, scenarios: [short]}\n";
inline const std::string kShortConstraints =
    "constraints:\n"
    "  - {metric: joint_velocity/max_ratio, at_most: 0.9}\n"
    "  - {metric: joint_effort/max_ratio, at_most: 1}\n";
inline const std::string kShortSearch = "search: {algorithm: COBYLA, max_evaluations: 12, seed: 1}\n";
/// Eight seconds of a search that takes seconds pass no check of hours and arms, and need not.
inline const std::string kShortVerdict =
    "verdict: {delay_periods: 0, gain: 1, noise: 1, rate: 1, yield: 0, arms: 2, minutes: 0}\n";
inline const std::string kShortNativeSearch =
    "sweep: [{parameters: [task_space_gains_p/rx], factors: [0.8, 2]}]\n"
    "search: {algorithm: COBYLA, max_evaluations: 24, seed: 1, engine: native, verify_share: 0.4}\n";

/// Files of the study in a folder of their own: study.yaml, gains.yaml, short.yaml, short_realistic.yaml.
class ShortStudy {
 public:
  explicit ShortStudy(const std::string& parameters = kShortParameters,
                      const std::string& objective = kShortObjective,
                      const std::string& constraints = kShortConstraints,
                      const std::string& search = kShortSearch) {
    write("short.yaml", "base: moving_target\nduration: 8\n");
    write("short_realistic.yaml", "base: realistic_moving_target\nduration: 8\n");
    const Scenario scenario = scenario_of("moving_target");
    write("gains.yaml", gains_yaml(quick_gains(scenario), {}));
    write("study.yaml",
          "description: two gains in seconds\ngains: gains.yaml\n"
          "scenarios: [short.yaml, short_realistic.yaml]\n" +
              parameters + objective + constraints + search + kShortVerdict);
  }

  std::string write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  std::string path() const { return folder_ / "study.yaml"; }
  std::string operator/(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryFolder folder_;
};

}  // namespace armtune::internal::test
