#include "tuner/workers/lane_worker.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "sim/lanes/rollout_lanes.hpp"
#include "tuner/ranks/patience.hpp"

namespace armtune::internal {
namespace {

/// Number of control periods between two checks of the clock and of `stop`. They take as long as a few
/// periods of one arm in Simbody.
constexpr int kPeriodsAtOnce = 16;

}  // namespace

/// Lanes for jobs of one kind, and the jobs that are under way in them.
class LaneWorker::LaneGroup {
 public:
  /// share: largest number of jobs at once. More lanes than that would only cost time.
  LaneGroup(const LaneKind& kind, std::size_t share)
      : kind_(kind),
        lanes_(kind, static_cast<int>(std::min(share, most()))),
        arms_(static_cast<int>(std::min(share, lane_count()))),
        under_way_(lane_count()) {}

  const LaneKind& kind() const { return kind_; }
  std::size_t busy() const { return static_cast<std::size_t>(lanes_.busy()); }
  bool is_full() const { return lanes_.free_lane() < 0; }

  void start(std::shared_ptr<const PreparedScenario> scenario, GivenJob&& one) {
    const int lane = lanes_.free_lane();
    const RolloutJob& job = one.job;
    lanes_.start(lane, {std::move(scenario), job.gains, job.limits, job.series});
    under_way_[static_cast<std::size_t>(lane)].emplace(InLane{std::move(one), {}});
  }

  /// Simulates kPeriodsAtOnce control periods, or fewer if a rollout ends.
  void step(JobSource& jobs) {
    bool some_ended = false;
    for (int i = 0; i < kPeriodsAtOnce && busy() > 0 && !some_ended; ++i) {
      lanes_.step([&](int lane, RolloutResult&& result) {
        some_ended = true;
        std::optional<InLane>& one = under_way_[static_cast<std::size_t>(lane)];
        const std::size_t number = one->job.number;
        one.reset();
        jobs.finished(number, std::move(result));
      });
    }
  }

  void check_deadlines(const RolloutPlan& plan, const SingleRollouts& alone) {
    for (std::size_t lane = 0; lane < under_way_.size(); ++lane) {
      std::optional<InLane>& one = under_way_[lane];
      if (!one) continue;
      // A rollout takes longer beside others than alone, but all of them together take less time.
      if (one->time.look() > arms_ * deadline_of(plan.deadline, plan.scenarios[one->job.job.scenario])) {
        throw alone.late(one->job.job, arms_, lanes_.time(static_cast<int>(lane)));
      }
    }
  }

  void interrupt(JobSource& jobs) const {
    for (const std::optional<InLane>& one : under_way_) {
      RolloutResult interrupted;
      interrupted.status = RolloutStatus::kInterrupted;
      if (one) jobs.finished(one->job.number, std::move(interrupted));
    }
  }

 private:
  struct InLane {
    GivenJob job;
    RunningTime time;
  };
  static std::size_t most() { return static_cast<std::size_t>(most_lanes(best_processor())); }
  std::size_t lane_count() const { return static_cast<std::size_t>(lanes_.lanes()); }

  LaneKind kind_;
  RolloutLanes lanes_;
  int arms_;  ///< number of arms that share the thread; multiplies the deadline
  std::vector<std::optional<InLane>> under_way_;  ///< per lane
};

LaneWorker::LaneWorker(const RolloutPlan& plan) : plan_(plan), alone_(plan) {
  for (const Scenario& scenario : plan.scenarios) {
    most_obstacles_ = std::max(most_obstacles_, scenario.obstacles.size());
  }
}

LaneWorker::~LaneWorker() = default;

void LaneWorker::work(JobSource& jobs) {
  groups_.clear();
  for (start_jobs(jobs); busy() > 0; start_jobs(jobs)) {
    if (jobs.stopped()) {
      for (const auto& group : groups_) group->interrupt(jobs);
      return;
    }
    for (const auto& group : groups_) group->step(jobs);
    for (const auto& group : groups_) group->check_deadlines(plan_, alone_);
  }
}

void LaneWorker::start_jobs(JobSource& jobs) {
  while (has_room(jobs.share())) {
    std::optional<GivenJob> one = jobs.next();
    if (!one) return;
    const bool in_lanes = one->job.engine == Engine::kNative && lane_law(one->job.gains).has_value();
    if (!in_lanes || jobs.share() == 1) {
      jobs.finished(one->number, alone_.run(one->job, [&jobs] { return jobs.stopped(); }));
      continue;
    }
    auto scenario = alone_.arms().at(one->job.scenario, one->job.sample);
    group_of(one->job, jobs.share()).start(std::move(scenario), std::move(*one));
  }
}

bool LaneWorker::has_room(std::size_t share) const {
  const bool some_full =
      std::any_of(groups_.begin(), groups_.end(), [](const auto& group) { return group->is_full(); });
  return !some_full && busy() < share;
}

std::size_t LaneWorker::busy() const {
  std::size_t sum = 0;
  for (const auto& group : groups_) sum += group->busy();
  return sum;
}

LaneWorker::LaneGroup& LaneWorker::group_of(const RolloutJob& job, std::size_t share) {
  const LaneKind kind =
      lane_kind(plan_.scenarios[job.scenario], plan_.stepper, most_obstacles_, *lane_law(job.gains));
  for (const auto& group : groups_) {
    if (group->kind() == kind) return *group;
  }
  return *groups_.emplace_back(std::make_unique<LaneGroup>(kind, share));
}

}  // namespace armtune::internal
