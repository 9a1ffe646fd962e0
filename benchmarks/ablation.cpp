// Measures the effect of each option of the controller. The variants are the published law, each option
// alone, all options together, all tuned, and all tuned without each option. They run in the ideal and the
// realistic scenarios, and in one with a noisy camera. Every comparison is of two gain sets in the same
// scenario, with the same noise and the same initial theta: once theta of the scenario, once the identified
// theta. The effect of the identified theta alone is printed separately. The required factors of the tuned
// law follow.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "armtune/error.hpp"
#include "benchmarks/ablation_runs.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"

namespace {

using namespace armtune::internal;

/// A required improvement. A factor below 1 bounds how much worse the metric may become.
struct Demand {
  std::size_t first_scenario, last_scenario;
  Metric metric;
  double factor;  ///< lowest allowed published / now
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

/// Returns the geometric mean over scenarios first .. last of published / variant at the same theta; NaN if a
/// rollout did not complete.
double mean_factor(const Results& results, std::size_t v, Theta theta, Metric m, std::size_t first,
                   std::size_t last) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t s = first; s <= last; ++s) {
    if (results[v][theta][s].status != RolloutStatus::kCompleted) return NAN;
    const double ratio = factor(results[0][theta][s], results[v][theta][s], m);
    if (std::isnan(ratio)) continue;
    sum += std::log(ratio);
    ++count;
  }
  return count > 0 ? std::exp(sum / count) : NAN;
}

double largest_velocity(const std::vector<RolloutResult>& results, std::size_t first, std::size_t last) {
  double largest = 0.0;
  for (std::size_t s = first; s <= last; ++s) {
    largest = std::max(largest, results[s].metrics[Metric::kJointVelocityMaxRatio]);
  }
  return largest;
}

std::string cell(double factor) {
  return std::isfinite(factor) ? fmt::format("{:.2f}", factor) : "diverged";
}

void print_ablation(const std::vector<Variant>& all, const Results& results, Theta theta) {
  fmt::print(
      "Theta of every row: {}.\n"
      "Published error over error (geometric mean over four scenarios), published effort rate over effort "
      "rate,\n"
      "reacquisition time as a share of the published one, largest |q'| over its limit.\n\n",
      theta == kIdentified ? "identified in logs"
                           : "as the scenario says, 0 (ideal arm) or 0.8 of the model");
  fmt::print("{:<36}{:^50}{:^50}\n{:<36}", "", "ideal arm", "realistic arm", "");
  for (int i = 0; i < 2; ++i) {
    fmt::print("{:>10}{:>10}{:>10}{:>10}{:>10}", "position", "gaze", "effort", "reacq.", "velocity");
  }
  fmt::print("\n");
  for (std::size_t v = 0; v < all.size(); ++v) {
    fmt::print("{:<36}", all[v].name);
    for (const std::size_t first : {std::size_t{0}, std::size_t{4}}) {
      const auto mean = [&](Metric m) { return mean_factor(results, v, theta, m, first, first + 3); };
      fmt::print("{:>10}{:>10}{:>10}{:>10}{:>10.2f}", cell(mean(Metric::kPositionMax)),
                 cell(mean(Metric::kOrientationMax)), cell(mean(Metric::kEffortRateRms)),
                 cell(1.0 / mean_factor(results, v, theta, Metric::kReacquisitionTime, first + 2, first + 2)),
                 largest_velocity(results[v][theta], first, first + 3));
    }
    fmt::print("\n");
  }
}

constexpr std::array kTableMetrics = {Metric::kOrientationMax, Metric::kPositionMax};

/// Returns the tables of docs/comparisons.md: the effect of the law for either theta, and that of theta.
std::string table(const Results& results, std::size_t tuned) {
  std::string text =
      "| scenario | theta of both | error | published | extended, tuned | times smaller "
      "|\n|---|---|---|---|---|---|\n";
  for (std::size_t s = 0; s < kScenarios.size(); ++s) {
    for (const Theta theta : kThetas) {
      for (const Metric m : kTableMetrics) {
        const RolloutResult& before = results[0][theta][s];
        const RolloutResult& now = results[tuned][theta][s];
        text += fmt::format("| `{}` | {} | {} [{}] | {:.3g} | {:.3g} | {:.3g} |\n", kScenarios[s],
                            kThetaNames[theta], name(m), field(m).unit, before.metrics[m], now.metrics[m],
                            factor(before, now, m));
      }
    }
  }
  text +=
      "\n| scenario | gains | error | theta of the scenario | identified theta | times smaller |\n"
      "|---|---|---|---|---|---|\n";
  for (std::size_t s = 0; s < kScenarios.size(); ++s) {
    for (const auto& [gains, v] :
         {std::pair("published", std::size_t{0}), std::pair("extended, tuned", tuned)}) {
      for (const Metric m : kTableMetrics) {
        const RolloutResult& before = results[v][kOfScenario][s];
        const RolloutResult& now = results[v][kIdentified][s];
        text +=
            fmt::format("| `{}` | {} | {} [{}] | {:.3g} | {:.3g} | {:.3g} |\n", kScenarios[s], gains, name(m),
                        field(m).unit, before.metrics[m], now.metrics[m], factor(before, now, m));
      }
    }
  }
  return text;
}

void print_demand(std::size_t s, const char* what, double before, double now, const std::string& ratio,
                  double asked, bool met) {
  fmt::print("{:<28}{:<28}{:>12.4g}{:>12.4g}{:>10}{:>10.3g}{}\n", kScenarios[s], what, before, now, ratio,
             asked, met ? "" : "  missed");
}

/// Prints one line per demand and scenario, for the identified theta. Returns the number of missed demands.
int print_demands(const std::vector<RolloutResult>& published, const std::vector<RolloutResult>& tuned) {
  int missed = 0;
  const auto completed = [&](std::size_t s) { return tuned[s].status == RolloutStatus::kCompleted; };
  fmt::print(
      "\nAll tuned, one gain set for all scenarios, against published, both from identified theta:\n\n"
      "{:<28}{:<28}{:>12}{:>12}{:>10}{:>10}\n",
      "scenario", "metric", "published", "now", "factor", "asked");
  for (const Demand& demand : demands()) {
    for (std::size_t s = demand.first_scenario; s <= demand.last_scenario; ++s) {
      const double ratio = factor(published[s], tuned[s], demand.metric);
      const bool met = ratio >= demand.factor;
      missed += met ? 0 : 1;
      print_demand(s, name(demand.metric), published[s].metrics[demand.metric],
                   tuned[s].metrics[demand.metric], fmt::format("{:.2f}", ratio), demand.factor, met);
    }
  }
  for (std::size_t s = 0; s < kCamera; ++s) {
    const double ratio = tuned[s].metrics[Metric::kJointVelocityMaxRatio];
    const bool met = completed(s) && ratio <= kLargestVelocityRatio;
    missed += met ? 0 : 1;
    print_demand(s, name(Metric::kJointVelocityMaxRatio),
                 published[s].metrics[Metric::kJointVelocityMaxRatio], ratio, "at most",
                 kLargestVelocityRatio, met);
  }
  for (std::size_t s = 0; s < kCamera; ++s) {
    const double before = published[s].metrics[Metric::kObstacleMinClearance];
    const double now = tuned[s].metrics[Metric::kObstacleMinClearance];
    if (!std::isfinite(before)) continue;
    const bool met = completed(s) && now >= before;
    missed += met ? 0 : 1;
    print_demand(s, name(Metric::kObstacleMinClearance), before, now, "at least", before, met);
  }
  fmt::print("\n{} missed\n", missed);
  return missed;
}

std::string csv(const std::vector<Variant>& all, const Results& results) {
  std::string text = "variant,theta,scenario,status,metric,unit,value,published_over_value\n";
  for (std::size_t v = 0; v < all.size(); ++v) {
    for (const Theta theta : kThetas) {
      for (std::size_t s = 0; s < kScenarios.size(); ++s) {
        const RolloutResult& now = results[v][theta][s];
        for (const Metric m : all_metrics()) {
          if (std::isnan(now.metrics[m])) continue;
          const double ratio = factor(results[0][theta][s], now, m);
          text += fmt::format("\"{}\",{},{},{},{},{},{},{}\n", all[v].name, kThetaNames[theta], kScenarios[s],
                              name(now.status), name(m), field(m).unit, now.metrics[m],
                              std::isfinite(ratio) ? fmt::format("{:.6g}", ratio) : "");
        }
      }
    }
  }
  return text;
}

int run(int argc, char** argv) {
  CLI::App app{
      "Published law, each option alone, all together, all tuned, from the same theta, over nine scenarios"};
  std::string folder;
  std::string tuned_gains = "extended_tuned";
  int workers = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  app.add_option("--out", folder, "new folder for ablation.csv and run.json");
  app.add_option("--gains", tuned_gains, "the tuned gains")->capture_default_str();
  app.add_option("--workers", workers, "threads")->check(CLI::Range(1, 1024))->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const FolderLock lock = make_run_folder(folder);
  const auto began = std::chrono::steady_clock::now();

  const auto joints = joint_names(*load_scenario("moving_target").robot);
  const std::vector<Variant> all = ablation_variants(joints, tuned_gains);
  const Results results = simulate_all(all, workers);
  for (const Theta theta : kThetas) {
    print_ablation(all, results, theta);
    fmt::print("\n");
  }
  const auto tuned = static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [](const Variant& v) { return v.name == kTuned; }) - all.begin());
  fmt::print("{}", table(results, tuned));
  print_demands(results[0][kIdentified], results[tuned][kIdentified]);
  if (folder.empty()) return 0;
  write_text_file(folder + "/ablation.csv", csv(all, results));
  RunRecord record;
  record.kind = RunKind::kBenchmark;
  FilesRead files;
  record.command = fmt::format("benchmark_ablation --gains {}", tuned_gains);
  record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  record.workers = workers;
  for (std::size_t s = 0; s < kScenarios.size(); ++s) {
    for (const Theta theta : kThetas) add_inputs({scenario_at(s, theta)}, files.inputs);
  }
  write_text_file(folder + "/" + kRunRecord, run_record_json(with_circumstances(record, files)));
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
