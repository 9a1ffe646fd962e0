#include "tuner/robustness/monte_carlo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/csv/cell.hpp"
#include "tuner/robustness/drawn_arm.hpp"
#include "tuner/samples/statistics.hpp"

namespace armtune::internal {
namespace {

/// The samples of one call of monte_carlo, with their results so far.
class Drawing {
 public:
  Drawing(RolloutPool& pool, const Gains& gains, const MonteCarloOptions& options)
      : pool_(pool),
        gains_(gains),
        options_(options),
        scenarios_(pool.plan().scenarios),
        samples_(options.samples),
        done_(options.samples, 0) {
    for (std::size_t k = 0; k < samples_.size(); ++k) recall(k);
    report();
  }

  std::vector<MonteCarloSample> run(const std::atomic<bool>& stop) {
    std::vector<std::size_t> doubtful;
    pool_.run(
        jobs(), [&](std::size_t job) { return rollout(job, options_.engine); }, stop,
        [&](std::size_t job, RolloutResult&& result) {
          if (!keep(job, options_.engine, std::move(result))) doubtful.push_back(job);
        });
    pool_.run(
        doubtful.size(), [&](std::size_t i) { return rollout(doubtful[i], Engine::kSimbody); }, stop,
        [&](std::size_t i, RolloutResult&& result) {
          keep(doubtful[i], Engine::kSimbody, std::move(result));
        });
    std::vector<MonteCarloSample> whole;
    for (std::size_t k = 0; k < samples_.size(); ++k) {
      if (done_[k] == scenarios_.size()) whole.push_back(std::move(samples_[k]));
    }
    return whole;
  }

 private:
  std::size_t jobs() const { return missing_.size() * scenarios_.size(); }

  void judge(std::size_t k, std::size_t s) {
    samples_[k].broken[s] = broken_limit(samples_[k].results[s], options_.limits, scenarios_[s]);
  }

  void recall(std::size_t k) {
    MonteCarloSample& sample = samples_[k];
    sample.number = options_.first + k;
    sample.results.resize(scenarios_.size());
    sample.broken.resize(scenarios_.size());
    auto known = options_.known ? options_.known(sample.number) : std::nullopt;
    if (!known) {
      missing_.push_back(k);
      return;
    }
    sample.results = std::move(*known);
    for (std::size_t s = 0; s < scenarios_.size(); ++s) judge(k, s);
    done_[k] = scenarios_.size();
  }

  RolloutJob rollout(std::size_t job, Engine engine) const {
    RolloutJob one{job % scenarios_.size(), samples_[missing_[job / scenarios_.size()]].number, gains_};
    one.engine = engine;
    return one;
  }

  /// Keeps the result of a job. Returns false if a limit is broken in another engine than Simbody, because
  /// Simbody must then simulate the job again.
  bool keep(std::size_t job, Engine engine, RolloutResult&& result) {
    const std::size_t k = missing_[job / scenarios_.size()];
    const std::size_t s = job % scenarios_.size();
    samples_[k].results[s] = std::move(result);
    judge(k, s);
    if (engine != Engine::kSimbody && !samples_[k].broken[s].text.empty()) return false;
    if (++done_[k] == scenarios_.size() && options_.whole) options_.whole(samples_[k]);
    report();
    if (options_.progress) options_.progress(++rollouts_, jobs());
    return true;
  }

  /// Reports the complete samples, up to the first one that is not complete.
  void report() {
    for (; options_.finished && reported_ < samples_.size() && done_[reported_] == scenarios_.size();
         ++reported_) {
      options_.finished(samples_[reported_]);
    }
  }

  RolloutPool& pool_;
  const Gains& gains_;
  const MonteCarloOptions& options_;
  const std::vector<Scenario>& scenarios_;
  std::vector<MonteCarloSample> samples_;
  std::vector<std::size_t> done_;     ///< [sample]: number of rollouts done
  std::vector<std::size_t> missing_;  ///< samples to simulate
  std::size_t reported_ = 0;          ///< number of samples reported
  std::size_t rollouts_ = 0;          ///< number of rollouts done
};

}  // namespace

bool MonteCarloSample::keeps_all() const {
  return std::all_of(broken.begin(), broken.end(), [](const RolloutFailure& f) { return f.text.empty(); });
}

RolloutPlan monte_carlo_plan(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options) {
  validate(options.perturbation);
  RolloutPlan plan;
  plan.scenarios = scenarios;
  plan.stepper = options.stepper;
  plan.draw = Draw{options.perturbation, options.seed};
  return plan;
}

std::vector<MonteCarloSample> monte_carlo(const std::vector<Scenario>& scenarios, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop) {
  RolloutPool pool(monte_carlo_plan(scenarios, options), options.workers);
  return monte_carlo(pool, gains, options, stop);
}

std::vector<MonteCarloSample> monte_carlo(RolloutPool& pool, const Gains& gains,
                                          const MonteCarloOptions& options, const std::atomic<bool>& stop) {
  return Drawing(pool, gains, options).run(stop);
}

std::string samples_header(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options) {
  std::string text = "sample,scenario,status,broken_limit,joint_velocity/max_ratio_joint";
  for (const Metric metric : all_metrics()) text += fmt::format(",{}", name(metric));
  for (const std::string& column : drawn_columns(scenarios)) text += "," + cell(column);
  for (const std::string& column : distribution_columns(options.perturbation)) text += "," + cell(column);
  return text + '\n';
}

std::string sample_rows(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const MonteCarloSample& sample) {
  std::string text;
  const auto of_distribution = distribution_values(options.perturbation, options.seed, sample.number);
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    const RolloutResult& result = sample.results[s];
    text += fmt::format("{},{},{},{},{}", sample.number, cell(scenarios[s].name), name(result.status),
                        cell(sample.broken[s].text), cell(result.metrics.max_ratio_joint));
    for (const Metric metric : all_metrics()) text += "," + cell(result.metrics[metric]);
    const Scenario drawn = perturbed(scenarios[s], options.perturbation, options.seed, sample.number);
    for (const double value : drawn_values(scenarios, scenarios[s], drawn)) text += "," + cell(value);
    for (const double value : of_distribution) text += "," + cell(value);
    text += '\n';
  }
  return text;
}

std::string samples_csv(const std::vector<Scenario>& scenarios, const MonteCarloOptions& options,
                        const std::vector<MonteCarloSample>& samples) {
  std::string text = samples_header(scenarios, options);
  for (const MonteCarloSample& sample : samples) text += sample_rows(scenarios, options, sample);
  return text;
}

std::vector<MetricSpread> spreads(const std::vector<MonteCarloSample>& samples, std::size_t s) {
  std::vector<MetricSpread> found;
  for (const Metric metric : all_metrics()) {
    const double sign = larger_is_better(metric) ? -1.0 : 1.0;
    std::vector<std::pair<double, std::uint64_t>> values;
    values.reserve(samples.size());
    for (const MonteCarloSample& sample : samples) {
      const double value = sample.results[s].metrics[metric];
      const bool completed = sample.results[s].status == RolloutStatus::kCompleted;
      if (completed && std::isfinite(value)) values.emplace_back(sign * value, sample.number);
    }
    if (values.empty()) continue;
    std::sort(values.begin(), values.end());
    std::vector<double> sorted;
    sorted.reserve(values.size());
    for (const auto& [value, number] : values) sorted.push_back(value);
    found.push_back({metric, values.size(), samples.size() - values.size(), sign * quantile(sorted, 0.5),
                     sign * quantile(sorted, 0.95), sign * quantile(sorted, 0.99), sign * sorted.back(),
                     values.back().second});
  }
  return found;
}

std::string summary_csv(const std::vector<Scenario>& scenarios,
                        const std::vector<MonteCarloSample>& samples) {
  std::string text = "scenario,metric,unit,samples,not_given,median,p95,p99,worst,worst_sample\n";
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    for (const MetricSpread& spread : spreads(samples, s)) {
      text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", cell(scenarios[s].name), name(spread.metric),
                          field(spread.metric).unit, spread.count, spread.not_given, cell(spread.median),
                          cell(spread.p95), cell(spread.p99), cell(spread.worst), spread.worst_sample);
    }
  }
  return text;
}

}  // namespace armtune::internal
