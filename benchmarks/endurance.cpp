// Measures the endurance of the bundled tuned gains. It simulates hours of every bundled realistic scenario
// on its own arm, and half an hour on random arms. For each it prints the first limit that is broken, and
// compares the errors of the last ten minutes with those of minutes 1 to 11. Failures in the native engine
// are simulated again in Simbody.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "armtune/error.hpp"
#include "sim/csv/cell.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tuner/endurance/endurance.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/workers/parallel.hpp"

namespace {

using namespace armtune::internal;

struct Case {
  std::string gains;
  std::string scenario;
};

/// Returns pairs of an arm's tuned gains and a realistic scenario of that arm, for UR10, Panda and youBot.
std::vector<Case> bundled_cases() {
  static const std::map<std::string, std::string> tuned = {
      {"ur10", "extended_tuned"}, {"panda", "panda_tuned"}, {"youbot", "youbot_tuned"}};
  std::vector<Case> all;
  for (const auto& [robot, gains] : tuned) {
    for (const std::string& scenario : bundled_names("scenarios")) {
      if (scenario.find("realistic") == std::string::npos) continue;
      if (load_scenario(scenario).robot->name == robot) all.push_back({gains, scenario});
    }
  }
  return all;
}

/// One long rollout of a case, with its own arm or a random one.
struct Job {
  std::size_t number;
  int sample;  ///< below zero: the scenario's own arm
};

constexpr double kMostRmsGrowth = 1.2;
constexpr double kMostPeakGrowth = 1.5;

bool passes(const EnduranceResult& r) {
  return r.held() && !(r.rms_growth > kMostRmsGrowth) && !(r.peak_growth > kMostPeakGrowth);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs the bundled tuned gains for hours, and on random arms");
  double minutes = 120.0;
  double arm_minutes = 30.0;
  int arms = 20;
  std::uint64_t seed = 7;
  std::string folder;
  std::string only;
  int workers = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  app.add_option("--minutes", minutes, "of every scenario on its own arm")->capture_default_str();
  app.add_option("--arms", arms, "random arms of every scenario")->capture_default_str();
  app.add_option("--arm-minutes", arm_minutes, "of each of them")->capture_default_str();
  app.add_option("--seed", seed, "of the random arms")->capture_default_str();
  app.add_option("--only", only, "a part of the gain set's or the scenario's name");
  app.add_option("--out", folder, "folder for endurance.csv and run.json");
  app.add_option("--workers", workers, "threads")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const auto began = std::chrono::steady_clock::now();
  try {
    std::vector<Case> cases;
    std::vector<Scenario> scenarios;
    for (const Case& c : bundled_cases()) {
      if ((c.gains + " " + c.scenario).find(only) == std::string::npos) continue;
      cases.push_back(c);
      scenarios.push_back(load_scenario(c.scenario));
    }
    std::vector<Job> jobs;
    for (std::size_t i = 0; i < cases.size(); ++i) jobs.push_back({i, -1});
    for (int sample = 0; sample < arms; ++sample) {
      for (std::size_t i = 0; i < cases.size(); ++i) jobs.push_back({i, sample});
    }
    std::vector<EnduranceResult> results(jobs.size());
    const std::atomic<bool> never{false};
    parallel_for(jobs.size(), workers, never, [&](std::size_t, std::size_t j) {
      const Job& job = jobs[j];
      Scenario scenario = scenarios[job.number];
      if (job.sample >= 0) {
        scenario = perturbed(scenario, default_perturbation({&scenario, 1}), seed,
                             static_cast<std::uint64_t>(job.sample));
      }
      const Gains gains = load_gains(cases[job.number].gains, joint_names(*scenario.robot));
      EnduranceOptions options;
      options.minutes = job.sample < 0 ? minutes : arm_minutes;
      results[j] = endure(
                       {scenario}, [&gains](const Scenario&) { return gains; }, options, never)
                       .front();
    });
    std::string csv = "gains,scenario,arm,minutes,passed,limit,joint,time,rms_growth,peak_growth,engine\n";
    std::size_t failed = 0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      std::size_t held = 0;
      double rms = 0.0;
      double peak = 0.0;
      std::string first;
      for (std::size_t j = 0; j < jobs.size(); ++j) {
        if (jobs[j].number != i) continue;
        const EnduranceResult& r = results[j];
        const bool own = jobs[j].sample < 0;
        csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", cases[i].gains, cases[i].scenario,
                           own ? "own" : fmt::format("{}", jobs[j].sample), own ? minutes : arm_minutes,
                           passes(r) ? 1 : 0,
                           r.broken ? name(r.broken->limit) : (r.ended.empty() ? "" : "ended"),
                           r.broken ? r.broken->joint : "", cell(r.broken ? r.broken->time : NAN),
                           cell(r.rms_growth), cell(r.peak_growth), name(r.engine));
        if (!passes(r)) ++failed;
        const std::string what =
            r.broken ? to_string(*r.broken)
            : !r.ended.empty()
                ? r.ended
                : fmt::format("errors grow: RMS {:.2f}, peak {:.2f} times", r.rms_growth, r.peak_growth);
        if (own) {
          fmt::print("{} {}, {:.0f} minutes: {}\n", cases[i].gains, cases[i].scenario, minutes,
                     passes(r) ? fmt::format(
                                     "passed; at the end RMS {:.2f}, peak {:.2f} times that at the beginning",
                                     r.rms_growth, r.peak_growth)
                               : "FAILED: " + what);
          continue;
        }
        if (passes(r)) ++held;
        if (r.held()) {
          rms = std::max(rms, r.rms_growth);
          peak = std::max(peak, r.peak_growth);
        }
        if (!passes(r) && first.empty()) first = fmt::format("; arm {}: {}", jobs[j].sample, what);
      }
      if (arms > 0) {
        fmt::print(
            "  on {} random arms, {:.0f} minutes each: {} passed; largest growth RMS {:.2f}, peak {:.2f}{}\n",
            arms, arm_minutes, held, rms, peak, first);
      }
    }
    if (!folder.empty()) {
      make_folder(folder);
      write_text_file(folder + "/endurance.csv", csv);
      RunRecord record;
      record.kind = RunKind::kBenchmark;
      FilesRead files;
      record.command = fmt::format("benchmark_endurance{} --minutes {} --arms {} --arm-minutes {} --seed {}",
                                   only.empty() ? "" : " --only " + only, minutes, arms, arm_minutes, seed);
      add_inputs(scenarios, files.inputs);
      record.seed = seed;
      record.workers = workers;
      record.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
      write_text_file(folder + "/" + kRunRecord, run_record_json(with_circumstances(record, files)));
    }
    fmt::print("{} of {} long runs failed\n", failed, jobs.size());
    return failed == 0 ? 0 : 3;
  } catch (const armtune::InputError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
