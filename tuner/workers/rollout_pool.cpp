#include "tuner/workers/rollout_pool.hpp"

#include <mutex>

#include "tuner/workers/lane_worker.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {
namespace {

/// Jobs 0 .. count - 1 for all workers of a pool.
class SharedJobs final : public JobSource {
 public:
  SharedJobs(std::size_t count, std::size_t workers, const std::function<RolloutJob(std::size_t)>& job,
             const std::atomic<bool>& stop, const std::function<void(std::size_t, RolloutResult&&)>& finished)
      : count_(count), share_((count + workers - 1) / workers), job_(job), stop_(stop), finished_(finished) {}

  std::size_t share() const override { return share_; }
  std::optional<GivenJob> next() override {
    if (stop_ || closed_) return std::nullopt;
    const std::size_t number = next_++;
    if (number >= count_) return std::nullopt;
    return GivenJob{number, job_(number)};
  }
  bool stopped() override { return stop_; }
  void finished(std::size_t number, RolloutResult&& result) override {
    const std::lock_guard lock(mutex_);
    finished_(number, std::move(result));
  }
  /// Makes next() return no further job.
  void close() { closed_ = true; }

 private:
  std::size_t count_, share_;
  const std::function<RolloutJob(std::size_t)>& job_;
  const std::atomic<bool>& stop_;
  const std::function<void(std::size_t, RolloutResult&&)>& finished_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> closed_{false};
  std::mutex mutex_;
};

}  // namespace

RolloutPool::RolloutPool(RolloutPlan plan, int threads)
    : plan_(std::make_shared<const RolloutPlan>(std::move(plan))) {
  workers_.reserve(static_cast<std::size_t>(threads));
  for (int w = 0; w < threads; ++w) workers_.push_back(std::make_unique<LaneWorker>(*plan_));
}

RolloutPool::RolloutPool(std::shared_ptr<const RolloutPlan> plan,
                         std::vector<std::unique_ptr<RolloutWorker>> workers)
    : plan_(std::move(plan)), workers_(std::move(workers)) {}

void RolloutPool::run(std::size_t count, const std::function<RolloutJob(std::size_t)>& job,
                      const std::atomic<bool>& stop,
                      const std::function<void(std::size_t, RolloutResult&&)>& finished) {
  const std::function<void(std::size_t, RolloutResult &&)> count_and_finish = [&](std::size_t i,
                                                                                  RolloutResult&& result) {
    if (result.status == RolloutStatus::kInterrupted) return;
    ++done_;
    simulated_ = simulated_ + result.end_time;
    finished(i, std::move(result));
  };
  SharedJobs jobs(count, workers_.size(), job, stop, count_and_finish);
  parallel_for(workers_.size(), this->count(), stop, [&](std::size_t, std::size_t worker) {
    try {
      workers_[worker]->work(jobs);
    } catch (...) {
      jobs.close();
      throw;
    }
  });
}

}  // namespace armtune::internal
