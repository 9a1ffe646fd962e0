#pragma once
// A worker in this process. It simulates jobs of the native engine side by side, as many as the processor has
// lanes for, and all other jobs one at a time.

#include <memory>
#include <vector>

#include "tuner/workers/rollout_worker.hpp"
#include "tuner/workers/single_rollouts.hpp"

namespace armtune::internal {

class LaneWorker : public RolloutWorker {
 public:
  /// The plan must outlive the worker.
  explicit LaneWorker(const RolloutPlan& plan);
  ~LaneWorker() override;

  void work(JobSource& jobs) override;

 private:
  class LaneGroup;

  /// Starts jobs until the lanes are full or no more come. Jobs that cannot use lanes are simulated at once.
  void start_jobs(JobSource& jobs);
  /// Returns true if any next job could start at once, whatever its kind. Otherwise no job is taken, so that
  /// other workers can take it.
  bool has_room(std::size_t share) const;
  /// Returns the number of rollouts under way in all groups.
  std::size_t busy() const;
  LaneGroup& group_of(const RolloutJob& job, std::size_t share);

  const RolloutPlan& plan_;
  SingleRollouts alone_;
  std::size_t most_obstacles_ = 0;  ///< largest number in a scenario of the plan
  std::vector<std::unique_ptr<LaneGroup>> groups_;
};

}  // namespace armtune::internal
