#include "benchmarks/ablation_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/control/gain_fields.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {
namespace {

constexpr double kCameraNoise = 0.002;  // m

/// An option of the controller: the fields of a gains file that switch it on and set it.
struct Option {
  const char* name;
  std::vector<std::string> fields;
};

const std::vector<Option>& options() {
  static const std::vector<Option> all = {
      {"gaze feed-forward", {"gaze_feedforward", "slerp_start_angle"}},
      {"moving joint goal", {"joint_goal_follows_task", "joint_trajectory_duration"}},
      {"governor and barrier", {"velocity_margin", "velocity_barrier_start", "velocity_barrier_gain"}},
      {"variable damping", {"variable_damping"}},
      {"adaptation",
       {"adaptation_gain", "adaptation_leakage", "adaptation_inertia_leakage", "adaptation_filter",
        "adaptation_projection", "adapt_while_avoiding"}},
  };
  return all;
}

/// Returns `to` with the fields of one option copied from `from`.
Gains with_option(Gains to, const Gains& from, const Option& option) {
  for (const GainField& field : gain_fields()) {
    if (std::find(option.fields.begin(), option.fields.end(), field.name) == option.fields.end()) continue;
    std::visit(
        [&](auto member) {
          if constexpr (!std::is_same_v<decltype(member), OwnGain>) to.*member = from.*member;
        },
        field.member);
  }
  return to;
}

}  // namespace

std::vector<Variant> ablation_variants(const std::vector<std::string>& joints,
                                       const std::string& tuned_gains) {
  const Gains published = load_gains("published", joints);
  const Gains extended = load_gains("extended", joints);
  const Gains tuned = load_gains(tuned_gains, joints);
  std::vector<Variant> all = {{"published", published}};
  for (const Option& option : options()) {
    all.push_back({option.name, with_option(published, extended, option)});
  }
  all.push_back({"all together", extended});
  all.push_back({kTuned, tuned});
  for (const Option& option : options()) {
    all.push_back({fmt::format("{}, no {}", kTuned, option.name), with_option(tuned, published, option)});
  }
  return all;
}

Scenario scenario_at(std::size_t s, Theta theta) {
  if (s != kCamera)
    return load_scenario((theta == kIdentified ? "identified_" : "") + std::string(kScenarios[s]));
  Scenario scenario = load_scenario("realistic_camera_target");
  scenario.camera->noise = kCameraNoise;
  if (theta == kIdentified) scenario.theta = load_scenario("identified_realistic_moving_target").theta;
  return scenario;
}

Results simulate_all(const std::vector<Variant>& all, int workers) {
  Results results(all.size());
  for (auto& of_variant : results) of_variant.fill(std::vector<RolloutResult>(kScenarios.size()));
  const std::atomic<bool> never{false};
  std::atomic<std::size_t> done{0};
  const std::size_t jobs = all.size() * kThetas.size() * kScenarios.size();
  parallel_for(jobs, workers, never, [&](std::size_t, std::size_t job) {
    const std::size_t s = job % kScenarios.size();
    const Theta theta = kThetas[job / kScenarios.size() % kThetas.size()];
    const std::size_t v = job / kScenarios.size() / kThetas.size();
    Rollout rollout(scenario_at(s, theta), Stepper::kMidpoint);
    results[v][theta][s] = rollout.run(all[v].gains);
    fmt::print(stderr, "\r{} of {} rollouts", ++done, jobs);
  });
  fmt::print(stderr, "\n");
  return results;
}

double factor(const RolloutResult& before, const RolloutResult& now, Metric m) {
  if (before.status != RolloutStatus::kCompleted || now.status != RolloutStatus::kCompleted) return NAN;
  const double ratio = before.metrics[m] / now.metrics[m];
  return ratio > 0.0 && std::isfinite(ratio) ? ratio : NAN;
}

}  // namespace armtune::internal
