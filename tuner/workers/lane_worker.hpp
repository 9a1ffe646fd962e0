#pragma once
// A worker that simulates rollouts in this process. With armtune's own engine (native) it simulates several
// rollouts at the same time, one in each SIMD lane of the processor. All other rollouts are simulated one at
// a time.

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

  /// Starts jobs until the lanes are full, or until there are no more jobs. A job that cannot use lanes is
  /// simulated completely before the next one is taken.
  void start_jobs(JobSource& jobs);
  /// True if a further job could start now, whatever its kind. The worker takes a job only if this is true.
  /// Otherwise other workers can take the job. share: see JobSource::share.
  bool has_room(std::size_t share) const;
  /// Returns the number of rollouts under way in all groups.
  std::size_t busy() const;
  LaneGroup& group_of(const RolloutJob& job, std::size_t share);

  const RolloutPlan& plan_;
  SingleRollouts alone_;
  std::size_t most_obstacles_ = 0;  ///< largest number of obstacles in a scenario of the plan
  std::vector<std::unique_ptr<LaneGroup>> groups_;
};

}  // namespace armtune::internal
