#include "tuner/workers/workers.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "tests/sim/support/rollouts.hpp"
#include "tuner/workers/parallel.hpp"

namespace armtune {
namespace {

TEST(Workers, GiveEachCandidateItsRolloutsWhateverTheirNumber) {
  const std::vector<Scenario> scenarios = {test::scenario_of("moving_target", 3.0),
                                           test::scenario_of("realistic_moving_target", 4.0),
                                           test::scenario_of("realistic_target_switch", 2.5)};
  std::vector<Gains> candidates(2, test::quick_gains(scenarios[0]));
  candidates[1].task_space_gains_p *= 1.2;
  const std::atomic<bool> never{false};
  for (const int count : {1, 2, 5}) {
    Workers workers(scenarios, Stepper::kMidpoint, count);
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
    Workers plain(scenarios, Stepper::kMidpoint, count);
    const auto ended = (*plain.run(candidates, never, {}, {Engine::kSimbody, limits}))[0];
    EXPECT_EQ(ended[0].status, RolloutStatus::kNoSamples) << "it ran whole";
    EXPECT_EQ(ended[1].status, RolloutStatus::kHopeless);
    const RolloutResult alone = Rollout(scenarios[1], Stepper::kMidpoint).run(candidates[0], {}, limits[1]);
    EXPECT_EQ(test::bits(ended[1].metrics), test::bits(alone.metrics));
    EXPECT_EQ(ended[1].end_time, alone.end_time);

    Workers arms(scenarios, Stepper::kMidpoint, count, set);
    const auto folded_results = (*arms.run(candidates, never, {}, {Engine::kSimbody, limits}))[0];
    double first = HUGE_VAL;
    for (std::uint64_t k = 0; k < 2; ++k) {
      const Scenario arm = perturbed(scenarios[1], set.perturbation, set.seed, k);
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
  Workers workers(scenarios, Stepper::kMidpoint, 1);
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
  Workers workers(scenarios, Stepper::kMidpoint, 2);
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

}  // namespace
}  // namespace armtune
