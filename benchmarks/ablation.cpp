// What each option of the controller is worth: published, each option alone, all together, all tuned, and all
// tuned with each option taken away, over the ideal and the realistic scenarios, against the published gains
// and law under the same conditions. Then the factors asked of the tuned law, one by one.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "core/common/error.hpp"
#include "core/control/gain_fields.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/workers/parallel.hpp"

namespace {

using namespace armtune;

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

/// `to` with one option's fields as they are in `from`.
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

struct Variant {
  std::string name;
  Gains gains;
  bool identified;  ///< theta starts from identification instead of from where the published runs start it
};

std::vector<Variant> variants(const std::vector<std::string>& joints, const std::string& tuned_gains) {
  const Gains published = load_gains("published", joints);
  const Gains extended = load_gains("extended", joints);
  const Gains tuned = load_gains(tuned_gains, joints);
  std::vector<Variant> all = {{"published", published, false}, {"identified theta", published, true}};
  for (const Option& option : options()) {
    all.push_back({option.name, with_option(published, extended, option), false});
  }
  all.push_back({"all together", extended, true});
  all.push_back({"all tuned", tuned, true});
  all.push_back({"all tuned, published theta", tuned, false});
  for (const Option& option : options()) {
    all.push_back(
        {fmt::format("all tuned, no {}", option.name), with_option(tuned, published, option), true});
  }
  return all;
}

const std::vector<std::string>& scenario_names() {
  static const std::vector<std::string> names = {"fixed_target",
                                                 "moving_target",
                                                 "target_switch",
                                                 "obstacle_pass",
                                                 "realistic_fixed_target",
                                                 "realistic_moving_target",
                                                 "realistic_target_switch",
                                                 "realistic_obstacle_pass"};
  return names;
}

/// At least, or for a bound at most.
struct Demand {
  std::size_t first_scenario, last_scenario;
  Metric metric;
  double factor;  ///< published / now must reach it
};

const std::vector<Demand>& demands() {
  using enum Metric;
  static const std::vector<Demand> all = {
      {0, 1, kPositionMax, 30.0},          {0, 1, kOrientationMax, 30.0},
      {0, 1, kLinearVelocityRms, 10.0},    {0, 1, kGazeRateErrorRms, 10.0},
      {2, 3, kPositionMax, 5.0},           {2, 3, kOrientationMax, 5.0},
      {4, 7, kPositionMax, 2.0},           {4, 7, kOrientationMax, 7.0},
      {4, 7, kLinearVelocityRms, 1 / 1.1}, {4, 7, kAngularVelocityRms, 1 / 1.1},
      {4, 7, kEffortRateRms, 1 / 1.1},     {2, 2, kReacquisitionTime, 1 / 0.35},
      {6, 6, kReacquisitionTime, 1 / 0.35}};
  return all;
}
constexpr double kLargestVelocityRatio = 0.9;

using Results = std::vector<std::vector<RolloutResult>>;  ///< [variant][scenario]

Results simulate_all(const std::vector<Variant>& all, int workers) {
  const auto& names = scenario_names();
  Results results(all.size(), std::vector<RolloutResult>(names.size()));
  const std::atomic<bool> never{false};
  std::atomic<std::size_t> done{0};
  const std::size_t jobs = all.size() * names.size();
  parallel_for(jobs, workers, never, [&](std::size_t, std::size_t job) {
    const Variant& variant = all[job / names.size()];
    const std::size_t s = job % names.size();
    Rollout rollout(load_scenario((variant.identified ? "identified_" : "") + names[s]), Stepper::kMidpoint);
    results[job / names.size()][s] = rollout.run(variant.gains);
    fmt::print(stderr, "\r{} of {} rollouts", ++done, jobs);
  });
  fmt::print(stderr, "\n");
  return results;
}

/// Geometric mean over scenarios first .. last of published / variant; NaN where a rollout did not complete.
double mean_factor(const Results& results, std::size_t v, Metric m, std::size_t first, std::size_t last) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t s = first; s <= last; ++s) {
    if (results[v][s].status != RolloutStatus::kCompleted) return NAN;
    const double factor = results[0][s].metrics[m] / results[v][s].metrics[m];
    if (!std::isfinite(factor) || factor <= 0.0) continue;
    sum += std::log(factor);
    ++count;
  }
  return count > 0 ? std::exp(sum / count) : NAN;
}

double largest_velocity(const Results& results, std::size_t v, std::size_t first, std::size_t last) {
  double largest = 0.0;
  for (std::size_t s = first; s <= last; ++s) {
    largest = std::max(largest, results[v][s].metrics[Metric::kJointVelocityMaxRatio]);
  }
  return largest;
}

std::string cell(double factor) {
  return std::isfinite(factor) ? fmt::format("{:.2f}", factor) : "diverged";
}

void print_ablation(const std::vector<Variant>& all, const Results& results) {
  fmt::print(
      "Published error over error (geometric mean over four scenarios), published effort rate over effort "
      "rate,\n"
      "reacquisition time as a share of the published one, largest |q'| over its limit.\n\n");
  fmt::print("{:<36}{:^50}{:^50}\n", "", "ideal arm", "realistic arm");
  fmt::print("{:<36}", "");
  for (int i = 0; i < 2; ++i) {
    fmt::print("{:>10}{:>10}{:>10}{:>10}{:>10}", "position", "gaze", "effort", "reacq.", "velocity");
  }
  fmt::print("\n");
  for (std::size_t v = 0; v < all.size(); ++v) {
    fmt::print("{:<36}", all[v].name);
    for (const std::size_t first : {std::size_t{0}, std::size_t{4}}) {
      fmt::print("{:>10}{:>10}{:>10}{:>10}{:>10.2f}",
                 cell(mean_factor(results, v, Metric::kPositionMax, first, first + 3)),
                 cell(mean_factor(results, v, Metric::kOrientationMax, first, first + 3)),
                 cell(mean_factor(results, v, Metric::kEffortRateRms, first, first + 3)),
                 cell(1.0 / mean_factor(results, v, Metric::kReacquisitionTime, first + 2, first + 2)),
                 largest_velocity(results, v, first, first + 3));
    }
    fmt::print("\n");
  }
}

/// One line per demand and scenario; how many are missed.
int print_demands(const Results& results, std::size_t tuned) {
  int missed = 0;
  const auto completed = [&](std::size_t s) { return results[tuned][s].status == RolloutStatus::kCompleted; };
  fmt::print(
      "\nAll tuned, one gain set for all scenarios, against "
      "published:\n\n{:<28}{:<28}{:>12}{:>12}{:>10}{:>10}\n",
      "scenario", "metric", "published", "now", "factor", "asked");
  for (const Demand& demand : demands()) {
    for (std::size_t s = demand.first_scenario; s <= demand.last_scenario; ++s) {
      const double before = results[0][s].metrics[demand.metric];
      const double now = results[tuned][s].metrics[demand.metric];
      const bool met = completed(s) && before / now >= demand.factor;
      missed += met ? 0 : 1;
      fmt::print("{:<28}{:<28}{:>12.4g}{:>12.4g}{:>10.2f}{:>10.2f}{}\n", scenario_names()[s],
                 name(demand.metric), before, now, before / now, demand.factor, met ? "" : "  missed");
    }
  }
  for (std::size_t s = 0; s < scenario_names().size(); ++s) {
    const double ratio = results[tuned][s].metrics[Metric::kJointVelocityMaxRatio];
    const bool met = completed(s) && ratio <= kLargestVelocityRatio;
    missed += met ? 0 : 1;
    fmt::print("{:<28}{:<28}{:>12.4g}{:>12.4g}{:>10}{:>10.2f}{}\n", scenario_names()[s],
               "joint_velocity/max_ratio", results[0][s].metrics[Metric::kJointVelocityMaxRatio], ratio,
               "at most", kLargestVelocityRatio, met ? "" : "  missed");
  }
  for (std::size_t s = 0; s < scenario_names().size(); ++s) {
    const double before = results[0][s].metrics[Metric::kObstacleMinClearance];
    const double now = results[tuned][s].metrics[Metric::kObstacleMinClearance];
    if (!std::isfinite(before)) continue;
    const bool met = completed(s) && now >= before;
    missed += met ? 0 : 1;
    fmt::print("{:<28}{:<28}{:>12.4g}{:>12.4g}{:>10}{:>10.3g}{}\n", scenario_names()[s],
               "obstacle/min_clearance", before, now, "at least", before, met ? "" : "  missed");
  }
  fmt::print("\n{} missed\n", missed);
  return missed;
}

std::string csv(const std::vector<Variant>& all, const Results& results) {
  std::string text = "variant,scenario,status,metric,unit,value,published_over_value\n";
  for (std::size_t v = 0; v < all.size(); ++v) {
    for (std::size_t s = 0; s < scenario_names().size(); ++s) {
      for (const Metric m : all_metrics()) {
        const double value = results[v][s].metrics[m];
        if (std::isnan(value)) continue;
        const double factor = results[0][s].metrics[m] / value;
        text += fmt::format("\"{}\",{},{},{},{},{},{}\n", all[v].name, scenario_names()[s],
                            name(results[v][s].status), name(m), field(m).unit, value,
                            std::isfinite(factor) ? fmt::format("{:.6g}", factor) : "");
      }
    }
  }
  return text;
}

int run(int argc, char** argv) {
  CLI::App app{"Published law, each option alone, all together, all tuned, over the eight bundled scenarios"};
  std::string folder;
  std::string tuned_gains = "extended_tuned";
  int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  app.add_option("--out", folder, "new folder for ablation.csv and run.yaml");
  app.add_option("--gains", tuned_gains, "the tuned gains")->capture_default_str();
  app.add_option("--workers", workers, "threads")->check(CLI::Range(1, 1024))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const FolderLock lock = make_run_folder(folder);
  const auto began = std::chrono::steady_clock::now();

  const auto joints = joint_names(*load_scenario("moving_target").robot);
  const std::vector<Variant> all = variants(joints, tuned_gains);
  const Results results = simulate_all(all, workers);
  print_ablation(all, results);
  const auto tuned =
      std::find_if(all.begin(), all.end(), [](const Variant& v) { return v.name == "all tuned"; });
  print_demands(results, static_cast<std::size_t>(tuned - all.begin()));
  if (folder.empty()) return 0;
  write_text_file(folder + "/ablation.csv", csv(all, results));
  Provenance p;
  p.command = fmt::format("benchmark_ablation --gains {}", tuned_gains);
  p.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  p.workers = workers;
  for (const std::string& scenario : scenario_names()) {
    add_inputs({load_scenario("identified_" + scenario)}, p.inputs);
  }
  write_text_file(folder + "/run.yaml", run_yaml(p));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "benchmark_ablation: {}\n", e.what());
    return 2;
  }
}
