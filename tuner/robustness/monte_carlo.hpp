#pragma once
// Simulates a gain set on many random arms. Each of them differs at random from the arm of the scenarios.

#include <atomic>
#include <functional>
#include <optional>
#include <vector>

#include "sim/scenario/perturbation.hpp"
#include "tuner/robustness/limits.hpp"
#include "tuner/workers/rollout_pool.hpp"

namespace armtune::internal {

/// The results of one random arm in every scenario.
struct MonteCarloSample {
  std::uint64_t number = 0;
  std::vector<RolloutResult> results;  ///< one per scenario
  std::vector<RolloutFailure> broken;  ///< result of broken_limit() (limits.hpp), one per scenario

  /// True if the arm keeps every limit in every scenario.
  bool keeps_all() const;
};

struct MonteCarloOptions {
  Perturbation perturbation;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;  ///< number of the first sample
  std::uint64_t samples = 1000;
  std::vector<MetricLimit> limits = arm_limits();
  Stepper stepper = Stepper::kMidpoint;
  int workers = 1;
  /// Engine that simulates the arms. If it is not Simbody, and an arm breaks a limit in a scenario, Simbody
  /// simulates this arm again in this scenario. The result of Simbody then counts.
  Engine engine = Engine::kSimbody;
  /// Called with the number of finished rollouts and the number of all rollouts. One call at a time. This
  /// function and the next three may be empty.
  std::function<void(std::size_t done, std::size_t all)> progress;
  /// Returns the results of a sample that an earlier session finished, one per scenario, or nothing.
  std::function<std::optional<std::vector<RolloutResult>>(std::uint64_t number)> known;
  /// Called with each sample for which `known` returned nothing, as soon as all its scenarios are simulated.
  /// The samples come in any order. One call at a time.
  std::function<void(const MonteCarloSample&)> whole;
  /// Called with every complete sample, in the order of the sample numbers. A sample waits until all samples
  /// before it are complete. One call at a time.
  std::function<void(const MonteCarloSample&)> finished;
};

/// Returns the plan that workers need for these options. Throws InputError if the perturbation is not valid.
RolloutPlan monte_carlo_plan(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options);

/// Simulates the gains on all samples. Returns the samples in the order of their numbers. Samples that were
/// not done when `stop` became true are missing. With the same stepper and engine, a sample depends only on
/// its number, the scenarios, the gains, the perturbation, the seed and the limits.
std::vector<MonteCarloSample> monte_carlo(const std::vector<Scenario>& scenarios, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop);
/// Does the same as the function above, with the workers of a pool that was made for the plan of
/// monte_carlo_plan. options.workers is not used.
std::vector<MonteCarloSample> monte_carlo(RolloutPool& pool, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop);

/// These functions return texts of samples.csv: its header line, the rows of one sample, and the whole file.
/// The columns are the sample, the scenario, the status, the broken limit, the joint with the largest
/// velocity ratio, every metric, and the properties of the random arm (drawn_arm.hpp). Numbers have all
/// digits that are needed to read back the same value. options: must be the options with which the samples
/// were simulated.
std::string samples_header(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options);
std::string sample_rows(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const MonteCarloSample& sample);
std::string samples_csv(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const std::vector<MonteCarloSample>& samples);

/// The spread of a metric over the samples that completed a scenario. Worse values are larger, or smaller for
/// a metric that should be large. p95 and p99 are the values that 95 % and 99 % of the samples do not exceed
/// in the direction of worse values.
struct MetricSpread {
  Metric metric = Metric::kPositionMax;
  std::size_t count = 0;      ///< number of samples with a value
  std::size_t not_given = 0;  ///< number of other samples: not completed, or without a value
  double median = 0.0, p95 = 0.0, p99 = 0.0, worst = 0.0;
  std::uint64_t worst_sample = 0;
};

/// Returns the spreads of all metrics that have a value in scenario s.
std::vector<MetricSpread> spreads(const std::vector<MonteCarloSample>& samples, std::size_t s);

/// Returns the text of summary.csv: scenario,metric,unit,samples,not_given,median,p95,p99,worst,worst_sample.
std::string summary_csv(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples);

}  // namespace armtune::internal
