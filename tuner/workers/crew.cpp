#include "tuner/workers/crew.hpp"

#include <mutex>

#include "tuner/workers/local_worker.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune {

Crew::Crew(RolloutPlan plan, int threads) : plan_(std::make_shared<const RolloutPlan>(std::move(plan))) {
  workers_.reserve(static_cast<std::size_t>(threads));
  for (int w = 0; w < threads; ++w) workers_.push_back(std::make_unique<LocalWorker>(*plan_));
}

Crew::Crew(std::shared_ptr<const RolloutPlan> plan, std::vector<std::unique_ptr<Worker>> workers)
    : plan_(std::move(plan)), workers_(std::move(workers)) {}

void Crew::run(std::size_t count, const std::function<RolloutJob(std::size_t)>& job,
               const std::atomic<bool>& stop,
               const std::function<void(std::size_t, RolloutResult&&)>& finished) {
  std::mutex mutex;
  parallel_for(count, this->count(), stop, [&](std::size_t worker, std::size_t i) {
    RolloutResult result = workers_[worker]->run(job(i), stop);
    if (result.status == RolloutStatus::kInterrupted) return;
    ++done_;
    simulated_ += result.end_time;
    const std::lock_guard lock(mutex);
    finished(i, std::move(result));
  });
}

}  // namespace armtune
