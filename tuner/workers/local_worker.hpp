#pragma once
// A worker in this process.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "tuner/workers/worker.hpp"

namespace armtune {

class LocalWorker : public Worker {
 public:
  /// plan: outlives the worker.
  explicit LocalWorker(const RolloutPlan& plan) : plan_(plan) {}

  RolloutResult run(const RolloutJob& job, const std::atomic<bool>& stop) override;
  /// stop: asked once per control period.
  RolloutResult run_until(const RolloutJob& job, const std::function<bool()>& stop);

 private:
  /// A plant with its scenario made ready. Few are kept, so that memory does not grow with the samples.
  struct Ready {
    std::size_t scenario;
    std::uint64_t sample;
    Engine engine;
    std::uint64_t used;
    std::unique_ptr<Rollout> rollout;
  };
  Rollout& rollout(const RolloutJob& job);

  const RolloutPlan& plan_;
  std::vector<Ready> ready_;
  std::uint64_t uses_ = 0;
};

}  // namespace armtune
