#pragma once
// A worker in this process that simulates jobs of the native engine side by side, as many as the processor
// has lanes for, and all others one at a time.

#include <memory>
#include <vector>

#include "tuner/workers/rollout_worker.hpp"
#include "tuner/workers/single_rollouts.hpp"

namespace armtune::internal {

class LaneWorker : public RolloutWorker {
 public:
  /// plan: outlives the worker.
  explicit LaneWorker(const RolloutPlan& plan);
  ~LaneWorker() override;

  void work(JobSource& jobs) override;

 private:
  class LaneGroup;

  /// Starts jobs until the lanes are full or no more come. What has no lanes is simulated at once, alone.
  void start_jobs(JobSource& jobs);
  /// Returns whether the next job can begin at once, whatever its kind: none is taken from others that could
  /// not.
  bool has_room(std::size_t share) const;
  /// Returns how many rollouts are under way in all groups.
  std::size_t busy() const;
  LaneGroup& group_of(const RolloutJob& job, std::size_t share);

  const RolloutPlan& plan_;
  SingleRollouts alone_;
  std::size_t most_obstacles_ = 0;  ///< of any scenario of the plan
  std::vector<std::unique_ptr<LaneGroup>> groups_;
};

}  // namespace armtune::internal
