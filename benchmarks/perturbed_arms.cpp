// Whether gains keep the limits on arms other than the one they were tuned on: every sample draws masses,
// inertias, payload, friction, phases of targets and obstacles, and runs every scenario given.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "sim/csv/text_file.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tuner/run/parallel.hpp"
#include "tuner/run/run_folder.hpp"

namespace {

using namespace armtune;

struct Arguments {
  /// The two that come near velocity limits: gaze jumps between targets, repulsion by obstacles.
  std::vector<std::string> scenarios = {"identified_realistic_target_switch",
                                        "identified_realistic_obstacle_pass"};
  std::string gains = "extended_tuned";
  std::string folder;
  std::uint64_t samples = 1000;
  std::uint64_t seed = 1;
  std::int64_t only = -1;
  int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
};

constexpr Metric kShown[] = {Metric::kJointVelocityMaxRatio, Metric::kOrientationMax, Metric::kPositionMax,
                             Metric::kReacquisitionTime, Metric::kObstacleMinClearance};

/// Value below which a share of the sorted values lies.
double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1) + 0.5)];
}

struct Sample {
  std::uint64_t number = 0;
  RolloutResult result;
};

void report(const std::string& scenario, const std::vector<Sample>& samples) {
  std::size_t completed = 0;
  std::size_t over = 0;
  for (const Sample& sample : samples) {
    if (sample.result.status == RolloutStatus::kCompleted) ++completed;
    if (!(sample.result.metrics[Metric::kJointVelocityMaxRatio] <= 0.9)) ++over;
  }
  fmt::print("\n{}: {} of {} completed; {} above 0.9 of a velocity limit\n", scenario, completed,
             samples.size(), over);
  fmt::print("  {:<32}{:>12}{:>12}{:>12}{:>12}{:>10}\n", "", "median", "95 %", "99 %", "worst", "sample");
  for (const Metric metric : kShown) {
    const bool least = metric == Metric::kObstacleMinClearance;
    std::vector<double> values;
    std::uint64_t worst = 0;
    double worst_value = least ? HUGE_VAL : -HUGE_VAL;
    for (const Sample& sample : samples) {
      const double value = sample.result.metrics[metric];
      if (std::isnan(value)) continue;
      values.push_back(least ? -value : value);
      if (least ? value < worst_value : value > worst_value) {
        worst_value = value;
        worst = sample.number;
      }
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    const double sign = least ? -1.0 : 1.0;
    fmt::print("  {:<32}{:>12.4g}{:>12.4g}{:>12.4g}{:>12.4g}{:>10}\n", name(metric),
               sign * quantile(values, 0.5), sign * quantile(values, 0.95), sign * quantile(values, 0.99),
               sign * values.back(), worst);
  }
}

std::string csv(const Arguments& args, const std::vector<std::vector<Sample>>& all) {
  std::string text = "scenario,sample,status,joint";
  for (const Metric metric : kShown) text += fmt::format(",{}", name(metric));
  text += '\n';
  for (std::size_t s = 0; s < all.size(); ++s) {
    for (const Sample& sample : all[s]) {
      text += fmt::format("{},{},{},{}", args.scenarios[s], sample.number, name(sample.result.status),
                          sample.result.metrics.max_ratio_joint);
      for (const Metric metric : kShown) {
        const double value = sample.result.metrics[metric];
        text += std::isnan(value) ? "," : fmt::format(",{:.6g}", value);
      }
      text += '\n';
    }
  }
  return text;
}

int run(int argc, char** argv) {
  Arguments args;
  CLI::App app{
      "Gains over randomly perturbed arms: masses and inertias +-20 %, payload 0 to 3 kg, friction +-50 %, "
      "phases"};
  app.add_option("SCENARIO", args.scenarios, "scenarios every sample runs")->capture_default_str();
  app.add_option("--gains", args.gains, "bundled gains or a file")->capture_default_str();
  app.add_option("--samples", args.samples, "how many arms")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  app.add_option("--seed", args.seed, "of the draws")->capture_default_str();
  app.add_option("--sample", args.only, "only this one");
  app.add_option("--workers", args.workers, "threads")->check(CLI::Range(1, 1024))->capture_default_str();
  app.add_option("--out", args.folder, "new folder for perturbed_arms.csv and run.yaml");
  CLI11_PARSE(app, argc, argv);
  if (!args.folder.empty()) make_run_folder(args.folder);
  const auto began = std::chrono::steady_clock::now();

  std::vector<Scenario> scenarios;
  for (const std::string& name : args.scenarios) scenarios.push_back(load_scenario(name));
  const Gains gains = load_gains(args.gains, joint_names(*scenarios.front().robot));
  const std::size_t count = args.only >= 0 ? 1 : args.samples;
  std::vector<std::vector<Sample>> all(scenarios.size(), std::vector<Sample>(count));
  const std::atomic<bool> never{false};
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(count * scenarios.size(), args.workers, never, [&](std::size_t, std::size_t job) {
    const std::size_t s = job % scenarios.size();
    Sample& sample = all[s][job / scenarios.size()];
    sample.number = args.only >= 0 ? static_cast<std::uint64_t>(args.only) : job / scenarios.size();
    const Scenario arm = perturbed(scenarios[s], Perturbation{}, args.seed, sample.number);
    sample.result = Rollout(arm, Stepper::kMidpoint).run(gains);
    const std::lock_guard lock(mutex);
    if (++done % 20 == 0) fmt::print(stderr, "\r{} of {} rollouts", done, count * scenarios.size());
  });
  fmt::print(stderr, "\n");
  fmt::print("{} under {} arms drawn from seed {}\n", args.gains, count, args.seed);
  for (std::size_t s = 0; s < scenarios.size(); ++s) report(args.scenarios[s], all[s]);
  if (args.folder.empty()) return 0;
  write_text_file(args.folder + "/perturbed_arms.csv", csv(args, all));
  Provenance p;
  p.command = fmt::format("benchmark_perturbed_arms {} --gains {} --samples {}",
                          fmt::join(args.scenarios, " "), args.gains, args.samples);
  p.seed = args.seed;
  p.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  p.workers = args.workers;
  add_inputs(scenarios, p.inputs);
  write_text_file(args.folder + "/run.yaml", run_yaml(p));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "benchmark_perturbed_arms: {}\n", e.what());
    return 2;
  }
}
