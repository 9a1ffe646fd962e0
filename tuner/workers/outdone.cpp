#include "tuner/workers/outdone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune {
namespace {

bool ended(const RolloutResult& result) {
  return result.status == RolloutStatus::kOutdone;
}

/// What stands for the results of a candidate above its bar.
RolloutResult above(double bar) {
  RolloutResult result;
  result.status = RolloutStatus::kOutdone;
  result.reason = fmt::format("objective and penalties above {:.6g}: of no use to the search", bar);
  return result;
}

}  // namespace

UnderBars::UnderBars(const std::optional<Outdone>& outdone, const std::vector<double>& bars,
                     std::size_t scenarios)
    : outdone_(outdone), bars_(bars) {
  if (!outdone) return;
  finished_.resize(bars.size());
  for (std::size_t c = 0; c < bars.size(); ++c) {
    if (std::isfinite(bars[c])) finished_[c].resize(scenarios);
  }
}

EndCost UnderBars::cost(std::size_t candidate, std::size_t scenario) const {
  if (!has_bar(candidate)) return {};
  const std::lock_guard lock(mutex_);
  const auto& finished = finished_[candidate];
  const bool shown =
      std::any_of(finished.begin(), finished.end(), [](const auto& r) { return r && ended(*r); });
  if (shown) return {{}, -HUGE_VAL};
  return outdone_->end(scenario, finished, bars_[candidate]);
}

void UnderBars::note(std::size_t candidate, std::size_t scenario, const RolloutResult& result) {
  if (!has_bar(candidate)) return;
  const std::lock_guard lock(mutex_);
  finished_[candidate][scenario] = result;
}

void UnderBars::settle(std::size_t candidate, std::vector<RolloutResult>& results) {
  if (!has_bar(candidate)) return;
  {
    const std::lock_guard lock(mutex_);
    finished_[candidate].assign(1, std::nullopt);  // no rollout of it comes any more
  }
  const double bar = bars_[candidate];
  if (std::any_of(results.begin(), results.end(), ended) || outdone_->above(results, bar)) {
    std::fill(results.begin(), results.end(), above(bar));
  }
}

}  // namespace armtune
