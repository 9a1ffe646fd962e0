#pragma once
// A worker in this process, one rollout at a time.

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include "tuner/workers/prepared_arms.hpp"
#include "tuner/workers/worker.hpp"

namespace armtune {

class LocalWorker : public Worker {
 public:
  /// plan: outlives the worker.
  explicit LocalWorker(const RolloutPlan& plan) : plan_(plan), arms_(plan) {}

  RolloutResult run(const RolloutJob& job, const std::atomic<bool>& stop) override;
  /// stop: asked once per control period.
  RolloutResult run_until(const RolloutJob& job, const std::function<bool()>& stop);

  PreparedArms& arms() { return arms_; }
  /// What to throw when a job is not done within its deadline [s]. simulated: how far it came [s].
  std::runtime_error late(const RolloutJob& job, double deadline, double simulated) const;

 private:
  /// A plant made ready. Few are kept.
  struct Ready {
    std::size_t scenario;
    std::uint64_t sample;
    Engine engine;
    std::uint64_t used;
    std::unique_ptr<Rollout> rollout;
  };
  Rollout& rollout(const RolloutJob& job);

  const RolloutPlan& plan_;
  PreparedArms arms_;
  std::vector<Ready> ready_;
  std::uint64_t uses_ = 0;
};

}  // namespace armtune
