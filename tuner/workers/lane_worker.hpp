#pragma once
// A worker that simulates rollouts in this process. With the native engine it simulates several rollouts at
// once, one in each SIMD lane of the processor. All other rollouts are simulated one at a time.

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
  /// True if a further job could start now, whatever its kind. Otherwise no job is taken, so that other
  /// workers can take it. share: see JobSource::share.
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
