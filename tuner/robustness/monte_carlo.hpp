#pragma once
// Simulates gains on many arms that differ at random from the arm they were made for.

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
  std::vector<std::string> broken;     ///< one per scenario, empty if every limit is kept

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
  /// Engine that simulates the arms. An arm that breaks a limit in another engine than Simbody is simulated
  /// again in Simbody.
  Engine engine = Engine::kSimbody;
  std::function<void(std::size_t done, std::size_t all)> progress;  ///< rollouts; one call at a time
  /// Returns the results per scenario of a sample that an earlier session finished, or none; may be empty.
  std::function<std::optional<std::vector<RolloutResult>>(std::uint64_t number)> known;
  /// Called with each sample that was not known, as soon as all its scenarios are simulated, in any order.
  /// One call at a time.
  std::function<void(const MonteCarloSample&)> whole;
  /// Called with each complete sample in the order of their numbers, as soon as all before it are complete
  /// too. One call at a time.
  std::function<void(const MonteCarloSample&)> finished;
};

/// Returns the plan for the workers of these options. Throws InputError if the perturbation is not valid.
RolloutPlan monte_carlo_plan(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options);

/// Returns the samples in the order of their numbers. Samples that were not done when `stop` became true are
/// missing. A sample depends on scenarios, gains, perturbation, seed and its number alone.
std::vector<MonteCarloSample> monte_carlo(const std::vector<Scenario>& scenarios, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop);
/// Does the same with the workers of a pool that was made for monte_carlo_plan; options.workers is not used.
std::vector<MonteCarloSample> monte_carlo(RolloutPool& pool, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop);

/// Returns texts of samples.csv: its header, the rows of a sample, and the whole file. The columns are
/// sample, scenario, status, broken limit, joint of the largest velocity ratio, every metric, and what was
/// drawn (drawn_arm.hpp). Numbers read back to the same bits. options: those that the samples were drawn
/// with.
std::string samples_header(const std::vector<Scenario>& scenarios);
std::string sample_rows(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const MonteCarloSample& sample);
std::string samples_csv(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const std::vector<MonteCarloSample>& samples);

/// The spread of a metric over the samples that completed a scenario. The worst value is the largest, or the
/// smallest for a metric that should be large.
struct MetricSpread {
  Metric metric = Metric::kPositionMax;
  std::size_t count = 0;      ///< samples with a value
  std::size_t not_given = 0;  ///< samples without, or that did not complete: worse than the worst here
  double median = 0.0, p95 = 0.0, p99 = 0.0, worst = 0.0;
  std::uint64_t worst_sample = 0;
};

/// Returns the spreads of all metrics that have a value in scenario s.
std::vector<MetricSpread> spreads(const std::vector<MonteCarloSample>& samples, std::size_t s);

/// Returns the text of summary.csv: scenario,metric,unit,samples,not_given,median,p95,p99,worst,worst_sample.
std::string summary_csv(const std::vector<Scenario>& scenarios, const std::vector<MonteCarloSample>& samples);

}  // namespace armtune::internal
