#include "tuner/workers/local_worker.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tuner/workers/patience.hpp"

namespace armtune {

Rollout& LocalWorker::rollout(const RolloutJob& job) {
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

RolloutResult LocalWorker::run(const RolloutJob& job, const std::atomic<bool>& stop) {
  return run_until(job, [&stop] { return stop.load(); });
}

std::runtime_error LocalWorker::late(const RolloutJob& job, double deadline, double simulated) const {
  const Scenario& scenario = plan_.scenarios[job.scenario];
  return std::runtime_error(
      fmt::format("{}{}: the rollout came to {:.3f} s of {} s simulated within its deadline of {} s; allow "
                  "more with --rollout-deadline, or find out what slows it down",
                  scenario.name, plan_.draw ? fmt::format(", sample {}", job.sample) : "", simulated,
                  scenario.duration, deadline));
}

RolloutResult LocalWorker::run_until(const RolloutJob& job, const std::function<bool()>& stop) {
  RunningTime time;
  const double deadline = deadline_of(plan_, plan_.scenarios[job.scenario]);
  const auto observer = [&](const Observation& o) {
    if (time.look() > deadline) throw late(job, deadline, o.time);
    return !stop();
  };
  return rollout(job).run(job.gains, observer, job.limits, job.cost);
}

}  // namespace armtune
