#pragma once
// The rollouts of benchmark_ablation: gain sets, each with the options of the controller on or off, in every
// scenario from either theta.

#include <array>
#include <string>
#include <vector>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {

struct Variant {
  std::string name;
  Gains gains;
};

inline constexpr const char* kTuned = "all tuned";

/// The published gains and law, each option of the extended law alone, all of them, all tuned (kTuned), and
/// all tuned without each option. Throws InputError where a gains file cannot be read.
std::vector<Variant> ablation_variants(const std::vector<std::string>& joints,
                                       const std::string& tuned_gains);

/// What theta starts from: where the scenario says, or what armtune identify found.
enum Theta : std::size_t { kOfScenario, kIdentified };
inline constexpr std::array kThetas = {kOfScenario, kIdentified};
inline constexpr std::array kThetaNames = {"scenario", "identified"};

/// Four of the ideal arm, the same of the realistic one, and realistic_camera_target with twice its noise.
inline constexpr std::array kScenarios = {"fixed_target",
                                          "moving_target",
                                          "target_switch",
                                          "obstacle_pass",
                                          "realistic_fixed_target",
                                          "realistic_moving_target",
                                          "realistic_target_switch",
                                          "realistic_obstacle_pass",
                                          "realistic_camera_target_2mm"};
inline constexpr std::size_t kCamera = kScenarios.size() - 1;

/// Scenario s of kScenarios.
Scenario scenario_at(std::size_t s, Theta theta);

using Results =
    std::vector<std::array<std::vector<RolloutResult>, kThetas.size()>>;  ///< [variant][theta][scenario]

/// Simulates every variant in every scenario from either theta, on that many threads.
Results simulate_all(const std::vector<Variant>& all, int workers);

/// Returns before / now; NaN where one of them did not complete or has no such figure.
double factor(const RolloutResult& before, const RolloutResult& now, Metric m);

}  // namespace armtune::internal
