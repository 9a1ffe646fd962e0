#pragma once
// A worker in this process that simulates jobs of the native engine side by side, as many as the processor
// has lanes for, and all others one at a time.

#include <optional>
#include <vector>

#include "sim/lanes/rollout_lanes.hpp"
#include "tuner/workers/local_worker.hpp"
#include "tuner/workers/patience.hpp"

namespace armtune {

class LaneWorker : public Worker {
 public:
  /// plan: outlives the worker.
  explicit LaneWorker(const RolloutPlan& plan);

  RolloutResult run(const RolloutJob& job, const std::atomic<bool>& stop) override {
    return alone_.run(job, stop);
  }
  void work(JobSource& jobs, const std::atomic<bool>& stop) override;

 private:
  struct InLane {
    GivenJob job;
    RunningTime time;
  };
  void fill(JobSource& jobs, const std::atomic<bool>& stop);
  void start(GivenJob&& one);
  bool fits(const RolloutJob& job, std::size_t share);
  void step(JobSource& jobs);
  void check_deadlines();

  const RolloutPlan& plan_;
  LocalWorker alone_;
  std::size_t most_obstacles_ = 0;
  std::unique_ptr<RolloutLanes> lanes_;
  LaneKind kind_;                                 ///< of lanes_
  std::vector<std::optional<InLane>> under_way_;  ///< per lane
  std::optional<GivenJob> held_;                  ///< until the lanes are free for its kind
  bool no_more_ = false;
};

}  // namespace armtune
