#include "tuner/workers/lane_worker.hpp"

#include <algorithm>
#include <cmath>

namespace armtune {
namespace {

/// Between two looks at clock and `stop`: as long as a few periods of one arm in Simbody.
constexpr int kPeriodsAtOnce = 16;

}  // namespace

LaneWorker::LaneWorker(const RolloutPlan& plan) : plan_(plan), alone_(plan) {
  for (const Scenario& scenario : plan.scenarios) {
    most_obstacles_ = std::max(most_obstacles_, scenario.obstacles.size());
  }
}

bool LaneWorker::fits(const RolloutJob& job, std::size_t share) {
  const LaneKind kind = lane_kind(plan_.scenarios[job.scenario], plan_.stepper, most_obstacles_);
  const int most = most_lanes(best_processor());
  const int wanted = static_cast<int>(std::min<std::size_t>(share, static_cast<std::size_t>(most)));
  if (lanes_ != nullptr && kind == kind_ && lanes_->lanes() >= wanted) return lanes_->free_lane() >= 0;
  if (lanes_ != nullptr && lanes_->busy() > 0) return false;
  kind_ = kind;
  lanes_ = std::make_unique<RolloutLanes>(kind, wanted);
  under_way_.clear();
  under_way_.resize(static_cast<std::size_t>(lanes_->lanes()));
  return true;
}

void LaneWorker::start(GivenJob&& one) {
  const int lane = lanes_->free_lane();
  const RolloutJob& job = one.job;
  lanes_->start(lane, {alone_.arms().at(job.scenario, job.sample), job.gains, job.limits, job.cost});
  under_way_[static_cast<std::size_t>(lane)].emplace(InLane{std::move(one), {}});
}

void LaneWorker::fill(JobSource& jobs, const std::atomic<bool>& stop) {
  const std::size_t share = jobs.share();
  while (lanes_ == nullptr || static_cast<std::size_t>(lanes_->busy()) < share) {
    if (!held_ && !no_more_) {
      held_ = jobs.next();
      no_more_ = !held_;
    }
    if (!held_) return;
    if (held_->job.engine != Engine::kNative || share == 1) {
      jobs.finished(held_->number, alone_.run(held_->job, stop));
    } else if (fits(held_->job, share)) {
      start(std::move(*held_));
    } else {
      return;
    }
    held_.reset();
  }
}

void LaneWorker::check_deadlines() {
  for (std::size_t lane = 0; lane < under_way_.size(); ++lane) {
    std::optional<InLane>& one = under_way_[lane];
    if (!one) continue;
    // Side by side a rollout takes longer than alone, all of them together less.
    const double deadline = lanes_->lanes() * deadline_of(plan_, plan_.scenarios[one->job.job.scenario]);
    if (one->time.look() > deadline) {
      throw alone_.late(one->job.job, deadline, lanes_->time(static_cast<int>(lane)));
    }
  }
}

void LaneWorker::step(JobSource& jobs) {
  bool some_ended = false;
  for (int i = 0; i < kPeriodsAtOnce && !some_ended; ++i) {
    lanes_->step([&](int lane, RolloutResult&& result) {
      some_ended = true;
      std::optional<InLane>& one = under_way_[static_cast<std::size_t>(lane)];
      const std::size_t number = one->job.number;
      one.reset();
      jobs.finished(number, std::move(result));
    });
  }
  if (!some_ended) return;
  // What has ended may show of others under way that they are of no use.
  for (std::size_t lane = 0; lane < under_way_.size(); ++lane) {
    const std::optional<InLane>& one = under_way_[lane];
    if (one && one->job.job.cost.beyond < HUGE_VAL) {
      lanes_->end_by(static_cast<int>(lane), jobs.cost_now(one->job.number));
    }
  }
}

void LaneWorker::work(JobSource& jobs, const std::atomic<bool>& stop) {
  no_more_ = false;
  held_.reset();
  if (lanes_) lanes_->clear();
  for (auto& one : under_way_) one.reset();
  for (fill(jobs, stop); lanes_ != nullptr && lanes_->busy() > 0 && !stop; fill(jobs, stop)) {
    step(jobs);
    check_deadlines();
  }
}

}  // namespace armtune
