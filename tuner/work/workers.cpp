#include "tuner/work/workers.hpp"

#include <algorithm>
#include <mutex>
#include <numeric>

#include "tuner/work/parallel.hpp"

namespace armtune {

Workers::Workers(const std::vector<Scenario>& scenarios, Stepper stepper, int count,
                 std::optional<SampleSet> samples)
    : samples_(std::move(samples)),
      scenarios_(samples_ ? drawn(scenarios, *samples_) : scenarios),
      stepper_(stepper),
      longest_first_(scenarios_.size()) {
  for (int w = 0; w < count; ++w) rollouts_.emplace_back(scenarios_.size());
  std::iota(longest_first_.begin(), longest_first_.end(), std::size_t{0});
  std::stable_sort(longest_first_.begin(), longest_first_.end(), [this](std::size_t a, std::size_t b) {
    return scenarios_[a].periods() > scenarios_[b].periods();
  });
}

Workers::~Workers() = default;

Rollout& Workers::rollout(std::size_t worker, std::size_t scenario) {
  auto& slot = rollouts_[worker][scenario];
  if (!slot) slot = std::make_unique<Rollout>(scenarios_[scenario], stepper_);
  return *slot;
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
                                                                    const std::vector<EndLimits>& limits) {
  const std::size_t arms = samples_ ? samples_->samples : 1;
  const EndLimits none;
  std::vector<std::vector<RolloutResult>> results(candidates.size(),
                                                  std::vector<RolloutResult>(scenarios_.size()));
  std::vector<std::size_t> left(candidates.size(), scenarios_.size());
  std::mutex mutex;
  // All candidates of the longest scenario first: short rollouts fill the gaps at the end.
  parallel_for(
      candidates.size() * scenarios_.size(), count(), stop, [&](std::size_t worker, std::size_t job) {
        const std::size_t scenario = longest_first_[job / candidates.size()];
        const std::size_t candidate = job % candidates.size();
        RolloutResult result = rollout(worker, scenario)
                                   .run(
                                       candidates[candidate], [&stop](const Observation&) { return !stop; },
                                       limits.empty() ? none : limits[scenario / arms]);
        ++done_;
        const std::lock_guard lock(mutex);
        const bool whole = result.status != RolloutStatus::kInterrupted;
        results[candidate][scenario] = std::move(result);
        if (!whole || --left[candidate] > 0) return;
        results[candidate] = fold(std::move(results[candidate]));
        if (finished) finished(candidate, results[candidate]);
      });
  if (stop) return std::nullopt;
  return results;
}

}  // namespace armtune
