#include "tuner/robustness/monte_carlo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/csv/cell.hpp"
#include "tuner/samples/statistics.hpp"

namespace armtune {
bool MonteCarloSample::keeps_all() const {
  return std::all_of(broken.begin(), broken.end(), [](const std::string& b) { return b.empty(); });
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
  const std::vector<Scenario>& scenarios = pool.plan().scenarios;
  std::vector<MonteCarloSample> samples(options.samples);
  std::vector<std::size_t> done(samples.size(), 0);
  std::vector<std::size_t> missing;
  const auto judge = [&](std::size_t k, std::size_t s) {
    samples[k].broken[s] = broken_limit(samples[k].results[s], options.limits, scenarios[s]);
  };
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].number = options.first + k;
    samples[k].results.resize(scenarios.size());
    samples[k].broken.resize(scenarios.size());
    if (auto known = options.known ? options.known(samples[k].number) : std::nullopt) {
      samples[k].results = std::move(*known);
      for (std::size_t s = 0; s < scenarios.size(); ++s) judge(k, s);
      done[k] = scenarios.size();
    } else {
      missing.push_back(k);
    }
  }
  std::size_t reported = 0;
  const auto report = [&] {
    for (; options.finished && reported < samples.size() && done[reported] == scenarios.size(); ++reported) {
      options.finished(samples[reported]);
    }
  };
  report();
  std::size_t rollouts = 0;
  const std::size_t jobs = missing.size() * scenarios.size();
  const auto job_of = [&](std::size_t job, Engine engine) {
    RolloutJob one{job % scenarios.size(), samples[missing[job / scenarios.size()]].number, gains};
    one.engine = engine;
    return one;
  };
  // Keeps the result of a job. Returns false where another engine than Simbody saw a limit break: Simbody has
  // the last word.
  const auto keep = [&](std::size_t job, Engine engine, RolloutResult&& result) {
    const std::size_t k = missing[job / scenarios.size()];
    const std::size_t s = job % scenarios.size();
    samples[k].results[s] = std::move(result);
    judge(k, s);
    if (engine != Engine::kSimbody && !samples[k].broken[s].empty()) return false;
    if (++done[k] == scenarios.size() && options.whole) options.whole(samples[k]);
    report();
    if (options.progress) options.progress(++rollouts, jobs);
    return true;
  };
  std::vector<std::size_t> doubtful;
  pool.run(
      jobs, [&](std::size_t job) { return job_of(job, options.engine); }, stop,
      [&](std::size_t job, RolloutResult&& result) {
        if (!keep(job, options.engine, std::move(result))) doubtful.push_back(job);
      });
  pool.run(
      doubtful.size(), [&](std::size_t i) { return job_of(doubtful[i], Engine::kSimbody); }, stop,
      [&](std::size_t i, RolloutResult&& result) { keep(doubtful[i], Engine::kSimbody, std::move(result)); });
  std::vector<MonteCarloSample> whole;
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (done[k] == scenarios.size()) whole.push_back(std::move(samples[k]));
  }
  return whole;
}

std::string samples_header() {
  std::string text = "sample,scenario,status,broken_limit,joint_velocity/max_ratio_joint";
  for (const Metric metric : all_metrics()) text += fmt::format(",{}", name(metric));
  return text + '\n';
}

std::string sample_rows(const std::vector<Scenario>& scenarios, const MonteCarloSample& sample) {
  std::string text;
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    const RolloutResult& result = sample.results[s];
    text += fmt::format("{},{},{},{},{}", sample.number, cell(scenarios[s].name), name(result.status),
                        cell(sample.broken[s]), cell(result.metrics.max_ratio_joint));
    for (const Metric metric : all_metrics()) text += "," + cell(result.metrics[metric]);
    text += '\n';
  }
  return text;
}

std::string samples_csv(const std::vector<Scenario>& scenarios,
                        const std::vector<MonteCarloSample>& samples) {
  std::string text = samples_header();
  for (const MonteCarloSample& sample : samples) text += sample_rows(scenarios, sample);
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

}  // namespace armtune
