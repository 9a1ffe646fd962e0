#include "tuner/workers/candidate_runner.hpp"

#include <algorithm>
#include <numeric>

namespace armtune::internal {

RolloutPlan plan_of(const std::vector<Scenario>& scenarios, Stepper stepper,
                    const std::optional<SampleSet>& samples) {
  RolloutPlan plan;
  plan.scenarios = scenarios;
  plan.stepper = stepper;
  if (samples) plan.draw = Draw{samples->perturbation, samples->seed, samples->samples};
  plan.drawn = static_cast<std::size_t>(
      std::find_if(scenarios.begin(), scenarios.end(), [](const Scenario& s) { return s.pushed; }) -
      scenarios.begin());
  return plan;
}

CandidateRunner::CandidateRunner(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                                 std::optional<SampleSet> samples)
    // Braces, because these arguments are evaluated in order.
    : CandidateRunner{std::make_unique<RolloutPool>(plan_of(scenarios, stepper, samples), count),
                      std::move(samples)} {}

CandidateRunner::CandidateRunner(std::unique_ptr<RolloutPool> pool, std::optional<SampleSet> samples)
    : pool_(std::move(pool)), samples_(std::move(samples)) {
  const auto& all = pool_->plan().scenarios;
  std::size_t place = 0;
  std::vector<std::size_t> longest_first(all.size());
  std::iota(longest_first.begin(), longest_first.end(), std::size_t{0});
  std::stable_sort(longest_first.begin(), longest_first.end(),
                   [&all](std::size_t a, std::size_t b) { return all[a].periods() > all[b].periods(); });
  for (std::size_t s = 0; s < all.size(); ++s) {
    place_.push_back(place);
    place += arms_of(s);
  }
  for (const std::size_t s : longest_first) {
    for (std::size_t k = 0; k < arms_of(s); ++k) units_.push_back({s, k});
  }
}

std::vector<RolloutResult> CandidateRunner::fold(std::vector<RolloutResult> results) const {
  if (!samples_) return results;
  std::vector<RolloutResult> one_each;
  for (std::size_t s = 0; s < scenarios(); ++s) {
    if (s >= pool_->plan().drawn) {
      one_each.push_back(std::move(results[place_[s]]));
    } else {
      one_each.push_back(folded(*samples_, std::span(results).subspan(place_[s], arms_of(s))));
    }
  }
  return one_each;
}

std::optional<std::vector<std::vector<RolloutResult>>> CandidateRunner::run(std::span<const Gains> candidates,
                                                                            const std::atomic<bool>& stop,
                                                                            const Finished& finished,
                                                                            const Conditions& conditions) {
  const std::vector<EndLimits>& limits = conditions.limits;
  const std::size_t each = units_.size();
  std::vector<std::vector<RolloutResult>> results(candidates.size(), std::vector<RolloutResult>(each));
  std::vector<std::size_t> left(candidates.size(), each);
  // The jobs of one candidate come before those of the next one, so that each candidate is finished, and on
  // disk, as early as possible. Its longest scenario comes first, so that short rollouts fill the gaps at the
  // end.
  const auto candidate_of = [&](std::size_t i) { return i / each; };
  const auto scenario_of = [&](std::size_t i) { return units_[i % each].scenario; };
  const auto sample_of = [&](std::size_t i) { return units_[i % each].sample; };
  pool_->run(
      candidates.size() * each,
      [&](std::size_t i) {
        return RolloutJob{scenario_of(i), sample_of(i), candidates[candidate_of(i)],
                          limits.empty() ? EndLimits() : limits[scenario_of(i)], conditions.engine};
      },
      stop,
      [&](std::size_t i, RolloutResult&& result) {
        const std::size_t candidate = candidate_of(i);
        results[candidate][place_[scenario_of(i)] + sample_of(i)] = std::move(result);
        if (--left[candidate] > 0) return;
        results[candidate] = fold(std::move(results[candidate]));
        if (finished) finished(candidate, results[candidate]);
      });
  if (stop) return std::nullopt;
  return results;
}

}  // namespace armtune::internal
