#pragma once
// Bundled scenarios and gains as tests use them.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal::test {

inline Gains published_gains(const Scenario& scenario) {
  return load_gains("published", joint_names(*scenario.robot));
}

/// The bundled scenario, cut to `duration` [s].
inline Scenario scenario_of(const std::string& name, double duration = 0.0) {
  Scenario scenario = load_scenario(name);
  if (duration > 0.0) scenario.duration = duration;
  return scenario;
}

/// Published gains that leave the singularity in 2 s instead of 6: short scenarios come to track sooner.
inline Gains quick_gains(const Scenario& scenario) {
  Gains gains = published_gains(scenario);
  gains.joint_trajectory_duration = 2.0;
  return gains;
}

/// All metrics bit by bit, so that NaN compares as well.
inline std::vector<std::uint64_t> bits(const Metrics& metrics) {
  std::vector<std::uint64_t> all;
  for (const double value : metrics.value) all.push_back(std::bit_cast<std::uint64_t>(value));
  return all;
}

/// True joint positions of every period of a rollout.
inline std::vector<JointVector> joint_path(const Scenario& scenario, const Gains& gains, Stepper stepper,
                                           Engine engine = Engine::kSimbody) {
  std::vector<JointVector> path;
  Rollout(scenario, stepper, engine).run(gains, [&](const Observation& o) {
    path.push_back(*o.q);
    return true;
  });
  return path;
}

/// Largest difference of any joint in any period.
inline double largest_difference(const std::vector<JointVector>& a, const std::vector<JointVector>& b) {
  double difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, (a[i] - b[i]).lpNorm<Eigen::Infinity>());
  }
  return difference;
}

}  // namespace armtune::internal::test
