#include "tuner/workers/candidate_runner.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/sim/support/rollouts.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune::internal {
namespace workers_test {

TEST(Workers, GiveEachCandidateItsRolloutsWhateverTheirNumber) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 3.0),
                                           test::scenario_of("realistic_moving_target", 4.0),
                                           test::scenario_of("realistic_target_switch", 2.5)};
  std::vector<Gains> candidates(2, test::quick_gains(scenarios[0]));
  candidates[1].task_space_gains_p *= 1.2;
  const std::atomic<bool> never{false};
  for (const int count : {1, 2, 5}) {
    CandidateRunner workers(scenarios, Stepper::kMidpoint, count);
    const auto results = workers.run(candidates, never);
    ASSERT_TRUE(results.has_value());
    ASSERT_EQ(results->size(), candidates.size());
    EXPECT_EQ(workers.rollouts_done(), 6);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      ASSERT_EQ((*results)[c].size(), scenarios.size());
      for (std::size_t s = 0; s < scenarios.size(); ++s) {
        const RolloutResult expected = Rollout(scenarios[s], Stepper::kMidpoint).run(candidates[c]);
        EXPECT_EQ(test::bits((*results)[c][s].metrics), test::bits(expected.metrics))
            << "candidate " << c << ", " << scenarios[s].name << ", " << count << " workers";
        EXPECT_EQ((*results)[c][s].reason, expected.reason);
      }
    }
  }
}

// Scenarios of every kind, more than there are lanes: with and without obstacles, two control periods, arms
// drawn.
TEST(Workers, SimulateSideBySideWhatTheySimulateAlone) {
  std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 4.0),
                                     test::scenario_of("realistic_obstacle_pass", 3.5),
                                     test::scenario_of("target_switch", 3.0)};
  scenarios.push_back(scenarios[0]);
  scenarios.back().control_period *= 2.0;
  std::vector<Gains> candidates(3, test::quick_gains(scenarios[0]));
  candidates[1].task_space_gains_p *= 1.2;
  candidates[2].task_space_gains_d *= -3.0;
  std::vector<EndLimits> limits(scenarios.size());
  limits[2] = {{Metric::kJointVelocityMaxRatio, 0.2}};
  const std::atomic<bool> never{false};
  for (const int count : {1, 2, 5}) {
    CandidateRunner workers(scenarios, Stepper::kMidpoint, count);
    const auto results = *workers.run(candidates, never, {}, {Engine::kNative, limits});
    EXPECT_EQ(workers.rollouts_done(), 12);
    for (std::size_t c = 0; c < candidates.size(); ++c) {
      for (std::size_t s = 0; s < scenarios.size(); ++s) {
        const RolloutResult expected =
            Rollout(scenarios[s], Stepper::kMidpoint, Engine::kNative).run(candidates[c], {}, limits[s]);
        EXPECT_EQ(test::bits(results[c][s].metrics), test::bits(expected.metrics))
            << "candidate " << c << ", scenario " << s << ", " << count << " workers";
        EXPECT_EQ(results[c][s].status, expected.status);
        EXPECT_EQ(results[c][s].reason, expected.reason);
      }
    }
  }
  SampleSet set;
  set.samples = 70;  // more arms than a worker keeps
  set.measure = RiskMeasure::kWorst;
  scenarios = {test::scenario_of("moving_target", 2.2)};
  const std::size_t arms_of_set = arms(set);
  CandidateRunner on_arms(scenarios, Stepper::kMidpoint, 2, set);
  const auto folded_results = (*on_arms.run({candidates.data(), 1}, never, {}, {Engine::kNative}))[0];
  double largest = 0.0;
  for (std::size_t k = 0; k < arms_of_set; ++k) {
    const Scenario arm = arm_of(set, scenarios[0], k);
    const RolloutResult alone = Rollout(arm, Stepper::kMidpoint, Engine::kNative).run(candidates[0]);
    largest = std::max(largest, alone.metrics[Metric::kJointVelocityMaxRatio]);
  }
  EXPECT_EQ(folded_results[0].metrics[Metric::kJointVelocityMaxRatio], largest);
}

TEST(Workers, SideBySideAreStoppedAndKeepToTheirDeadline) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 10.0)};
  const std::vector<Gains> candidates(20, test::quick_gains(scenarios[0]));  // more than there are lanes
  RolloutPlan plan = plan_of(scenarios, Stepper::kMidpoint, std::nullopt);
  plan.deadline = 1e-6;
  CandidateRunner late(std::make_unique<RolloutPool>(plan, 1), std::nullopt);
  std::atomic<bool> stop{false};
  const Conditions native{.engine = Engine::kNative};
  try {
    late.run(candidates, stop, {}, native);
    ADD_FAILURE() << "the deadline did not strike";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("moving_target: the rollout simulated only"), std::string::npos)
        << e.what();
  }
  // A pool whose results threw is of use again, and one that is stopped returns nothing.
  plan.deadline = 0.0;
  CandidateRunner workers(std::make_unique<RolloutPool>(plan, 1), std::nullopt);
  const auto expected = workers.run({candidates.data(), 2}, stop, {}, native);
  const auto full = [](std::size_t, const std::vector<RolloutResult>&) {
    throw std::runtime_error("the disk is full");
  };
  EXPECT_THROW(workers.run(candidates, stop, full, native), std::runtime_error);
  const auto again = workers.run({candidates.data(), 2}, stop, {}, native);
  EXPECT_EQ(test::bits((*again)[1][0].metrics), test::bits((*expected)[1][0].metrics));
  int finished = 0;
  const auto none = workers.run(
      candidates, stop,
      [&](std::size_t, const std::vector<RolloutResult>&) {
        ++finished;
        stop = true;
      },
      native);
  EXPECT_FALSE(none.has_value());
  EXPECT_LT(finished, 20);
  stop = false;
  EXPECT_TRUE(workers.run({candidates.data(), 2}, stop, {}, native).has_value());
}

TEST(Workers, EndEveryArmOfAScenarioAtThatScenariosLimits) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 3.0),
                                           test::scenario_of("realistic_moving_target", 3.5)};
  const std::vector<Gains> candidates = {test::quick_gains(scenarios[0])};
  // A hundredth of the velocity limit is passed on the way out of the singularity.
  const std::vector<EndLimits> limits = {{}, {{Metric::kJointVelocityMaxRatio, 0.01}}};
  SampleSet set;
  set.samples = 2;
  set.measure = RiskMeasure::kWorst;
  const std::atomic<bool> never{false};
  for (const int count : {1, 3}) {
    CandidateRunner plain(scenarios, Stepper::kMidpoint, count);
    const auto ended = (*plain.run(candidates, never, {}, {Engine::kSimbody, limits}))[0];
    EXPECT_EQ(ended[0].status, RolloutStatus::kNoSamples) << "it ran whole";
    EXPECT_EQ(ended[1].status, RolloutStatus::kHopeless);
    const RolloutResult alone = Rollout(scenarios[1], Stepper::kMidpoint).run(candidates[0], {}, limits[1]);
    EXPECT_EQ(test::bits(ended[1].metrics), test::bits(alone.metrics));
    EXPECT_EQ(ended[1].end_time, alone.end_time);

    CandidateRunner on_arms(scenarios, Stepper::kMidpoint, count, set);
    const auto folded_results = (*on_arms.run(candidates, never, {}, {Engine::kSimbody, limits}))[0];
    double first = HUGE_VAL;
    for (std::size_t k = 0; k < 3; ++k) {
      const Scenario arm = arm_of(set, scenarios[1], k);
      first = std::min(first, Rollout(arm, Stepper::kMidpoint).run(candidates[0], {}, limits[1]).end_time);
    }
    EXPECT_EQ(folded_results[0].status, RolloutStatus::kNoSamples);
    EXPECT_EQ(folded_results[1].status, RolloutStatus::kHopeless);
    EXPECT_EQ(folded_results[1].end_time, first);
  }
}

TEST(Workers, FinishOneCandidateBeforeTheyBeginTheNext) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 2.5),
                                           test::scenario_of("realistic_moving_target", 3.0)};
  const std::vector<Gains> candidates(3, test::quick_gains(scenarios[0]));
  const std::atomic<bool> never{false};
  CandidateRunner workers(scenarios, Stepper::kMidpoint, 1);
  std::vector<long> rollouts;
  workers.run(candidates, never, [&](std::size_t candidate, const std::vector<RolloutResult>&) {
    EXPECT_EQ(candidate, rollouts.size());
    rollouts.push_back(workers.rollouts_done());
  });
  EXPECT_EQ(rollouts, (std::vector<long>{2, 4, 6})) << "what is finished is on disk early";
}

TEST(Workers, StoppedTheyGiveNothing) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 3.0)};
  const std::atomic<bool> stop{true};
  CandidateRunner workers(scenarios, Stepper::kMidpoint, 2);
  EXPECT_FALSE(workers.run(std::vector<Gains>{test::quick_gains(scenarios[0])}, stop).has_value());
}

TEST(ParallelFor, DoesEveryJobOnce) {
  const std::atomic<bool> never{false};
  for (const int workers : {1, 2, 4}) {
    std::vector<std::atomic<int>> done(100);
    parallel_for(done.size(), workers, never, [&](std::size_t worker, std::size_t i) {
      EXPECT_LT(worker, static_cast<std::size_t>(workers));
      ++done[i];
    });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

TEST(ParallelFor, PassesOnTheExceptionAndStartsNoFurtherJob) {
  const std::atomic<bool> never{false};
  std::atomic<int> started{0};
  try {
    parallel_for(1000, 2, never, [&](std::size_t, std::size_t i) {
      ++started;
      if (i == 3) throw std::runtime_error("job 3");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    FAIL() << "nothing was thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "job 3");
  }
  EXPECT_LT(started, 500) << "one under way on the other thread, and what it begins before it hears of it";
}

}  // namespace workers_test
}  // namespace armtune::internal
