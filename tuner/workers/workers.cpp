#include "tuner/workers/workers.hpp"

#include <algorithm>
#include <numeric>

namespace armtune {

RolloutPlan plan_of(const std::vector<Scenario>& scenarios, Stepper stepper,
                    const std::optional<SampleSet>& samples) {
  RolloutPlan plan;
  plan.scenarios = scenarios;
  plan.stepper = stepper;
  if (samples) plan.draw = Draw{samples->perturbation, samples->seed};
  return plan;
}

Workers::Workers(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                 std::optional<SampleSet> samples)
    : Workers(std::make_unique<Crew>(plan_of(scenarios, stepper, samples), count), samples) {}

Workers::Workers(std::unique_ptr<Crew> crew, std::optional<SampleSet> samples)
    : crew_(std::move(crew)), samples_(std::move(samples)), longest_first_(crew_->plan().scenarios.size()) {
  const auto& scenarios = crew_->plan().scenarios;
  std::iota(longest_first_.begin(), longest_first_.end(), std::size_t{0});
  std::stable_sort(longest_first_.begin(), longest_first_.end(), [&scenarios](std::size_t a, std::size_t b) {
    return scenarios[a].periods() > scenarios[b].periods();
  });
}

std::vector<RolloutResult> Workers::fold(std::vector<RolloutResult> results) const {
  if (!samples_) return results;
  std::vector<RolloutResult> scenarios;
  for (std::size_t first = 0; first < results.size(); first += samples_->samples) {
    scenarios.push_back(folded(*samples_, std::span(results).subspan(first, samples_->samples)));
  }
  return scenarios;
}

std::optional<std::vector<std::vector<RolloutResult>>> Workers::run(std::span<const Gains> candidates,
                                                                    const std::atomic<bool>& stop,
                                                                    const Finished& finished,
                                                                    const Conditions& conditions) {
  const std::vector<EndLimits>& limits = conditions.limits;
  const std::size_t each = longest_first_.size() * samples();
  std::vector<std::vector<RolloutResult>> results(candidates.size(), std::vector<RolloutResult>(each));
  std::vector<std::size_t> left(candidates.size(), each);
  UnderBars under_bars(conditions.outdone, conditions.bars, longest_first_.size());
  // Candidate by candidate, so that each is finished, and on disk, as early as can be; the longest scenario
  // first: short rollouts fill the gaps at the end.
  const auto candidate_of = [&](std::size_t i) { return i / each; };
  const auto scenario_of = [&](std::size_t i) { return longest_first_[i % each / samples()]; };
  const auto sample_of = [&](std::size_t i) { return i % each % samples(); };
  crew_->run(
      candidates.size() * each,
      [&](std::size_t i) {
        return RolloutJob{scenario_of(i),
                          sample_of(i),
                          candidates[candidate_of(i)],
                          limits.empty() ? EndLimits() : limits[scenario_of(i)],
                          conditions.engine,
                          under_bars.cost(candidate_of(i), scenario_of(i))};
      },
      stop,
      [&](std::size_t i, RolloutResult&& result) {
        const std::size_t candidate = candidate_of(i);
        under_bars.note(candidate, scenario_of(i), result);
        results[candidate][scenario_of(i) * samples() + sample_of(i)] = std::move(result);
        if (--left[candidate] > 0) return;
        results[candidate] = fold(std::move(results[candidate]));
        under_bars.settle(candidate, results[candidate]);
        if (finished) finished(candidate, results[candidate]);
      });
  if (stop) return std::nullopt;
  return results;
}

}  // namespace armtune
