#include "tuner/workers/single_rollouts.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "tuner/ranks/patience.hpp"

namespace armtune::internal {

Rollout& SingleRollouts::rollout(const RolloutJob& job) {
  constexpr std::size_t kKept = 64;
  ++uses_;
  for (Ready& r : ready_) {
    if (r.scenario != job.scenario || r.sample != job.sample || r.engine != job.engine) continue;
    r.used = uses_;
    return *r.rollout;
  }
  if (ready_.size() == kKept) {
    ready_.erase(std::min_element(ready_.begin(), ready_.end(),
                                  [](const Ready& a, const Ready& b) { return a.used < b.used; }));
  }
  ready_.push_back(
      {job.scenario, job.sample, job.engine, uses_,
       std::make_unique<Rollout>(arms_.at(job.scenario, job.sample), plan_.stepper, job.engine)});
  return *ready_.back().rollout;
}

FailedError SingleRollouts::late(const RolloutJob& job, int arms, double simulated) const {
  const Scenario& scenario = plan_.scenarios[job.scenario];
  return FailedError(fmt::format(
      "{}{}: the rollout simulated only {:.3f} s of {} s within its deadline of {} s{}; give "
      "more time with --rollout-deadline, or find out what slows it down",
      scenario.name, plan_.draw ? fmt::format(", sample {}", job.sample) : "", simulated, scenario.duration,
      deadline_of(plan_.deadline, scenario),
      arms > 1 ? fmt::format(" (multiplied by {}, the number of arms simulated side by side)", arms) : ""));
}

RolloutResult SingleRollouts::run(const RolloutJob& job, const std::function<bool()>& stop) {
  RunningTime time;
  const double deadline = deadline_of(plan_.deadline, plan_.scenarios[job.scenario]);
  const auto observer = [&](const Observation& o) {
    if (time.look() > deadline) throw late(job, 1, o.time);
    return !stop();
  };
  return rollout(job).run(job.gains, observer, job.limits, job.series);
}

}  // namespace armtune::internal
