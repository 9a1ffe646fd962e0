#pragma once
// Rollouts in lanes, compared with the same rollouts alone.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "sim/lanes/rollout_lanes.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal::test {

/// Returns the kinds of processors whose lanes run on this one.
inline std::vector<Processor> processors() {
  std::vector<Processor> all;
  for (const Processor p : {Processor::kAny, Processor::kAvx2, Processor::kAvx512}) {
    if (runs_here(p)) all.push_back(p);
  }
  return all;
}

inline LaneJob job_of(const Scenario& scenario, const Gains& gains) {
  return {std::make_shared<const PreparedScenario>(scenario), gains};
}

inline RolloutResult alone(const LaneJob& job, Stepper stepper = Stepper::kMidpoint) {
  return Rollout(job.scenario, stepper, Engine::kNative).run(job.gains, {}, job.limits);
}

/// All jobs through `lanes` lanes, refilled as they become free.
inline std::vector<RolloutResult> side_by_side(const std::vector<LaneJob>& jobs, int lanes,
                                               Processor processor, Stepper stepper) {
  std::vector<RolloutResult> results(jobs.size());
  std::size_t obstacles = 0;
  for (const LaneJob& job : jobs) obstacles = std::max(obstacles, job.scenario->scenario.obstacles.size());
  RolloutLanes block(
      lane_kind(jobs[0].scenario->scenario, stepper, obstacles, lane_law(jobs[0].gains).value()), lanes,
      processor);
  std::vector<std::size_t> in_lane(static_cast<std::size_t>(block.lanes()));
  std::size_t next = 0;
  const auto fill = [&] {
    for (int lane = block.free_lane(); lane >= 0 && next < jobs.size(); lane = block.free_lane()) {
      in_lane[static_cast<std::size_t>(lane)] = next;
      block.start(lane, jobs[next++]);
    }
  };
  for (fill(); block.busy() > 0; fill()) {
    block.step([&](int lane, RolloutResult&& result) {
      results[in_lane[static_cast<std::size_t>(lane)]] = std::move(result);
    });
  }
  return results;
}

inline void expect_the_same(const std::vector<LaneJob>& jobs, Stepper stepper = Stepper::kMidpoint) {
  std::vector<RolloutResult> expected;
  for (const LaneJob& job : jobs) expected.push_back(alone(job, stepper));
  for (const Processor processor : processors()) {
    for (const int lanes : {1, 3, 8}) {
      const std::vector<RolloutResult> found = side_by_side(jobs, lanes, processor, stepper);
      for (std::size_t i = 0; i < jobs.size(); ++i) {
        const std::string what = fmt::format("{}, {} lanes, {}", i, lanes, name(processor));
        EXPECT_EQ(bits(found[i].metrics), bits(expected[i].metrics)) << what;
        EXPECT_EQ(found[i].status, expected[i].status) << what;
        EXPECT_EQ(found[i].reason, expected[i].reason) << what;
        EXPECT_EQ(found[i].end_time, expected[i].end_time) << what;
      }
    }
  }
}

}  // namespace armtune::internal::test
