#pragma once
// A worker in this process that simulates jobs of the native engine side by side, as many as the processor
// has lanes for, and all others one at a time.

#include "tuner/workers/single_rollouts.hpp"
#include "tuner/workers/worker.hpp"

namespace armtune {

class LaneWorker : public Worker {
 public:
  /// plan: outlives the worker.
  explicit LaneWorker(const RolloutPlan& plan) : plan_(plan), alone_(plan) {}

  void work(JobSource& jobs) override;

 private:
  const RolloutPlan& plan_;
  SingleRollouts alone_;
};

}  // namespace armtune
