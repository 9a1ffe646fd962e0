#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>

#include "tests/sim/support/rollouts.hpp"
#include "tuner/study/objective.hpp"

namespace armtune {
namespace {

constexpr double kPenalty = 1.5;

using Finished = std::vector<std::optional<RolloutResult>>;

constexpr double kBar = 5.0;

/// What the candidate costs at least, by those that are finished and the metrics so far of one that is not.
double least(const EndCost& cost, const Metrics& so_far) {
  double sum = kBar - cost.beyond;
  for (const EndCost::Share& share : cost.shares) sum += share.at(so_far[share.metric]);
  return sum;
}

constexpr double kRounding = 1e-8;  // end_cost keeps 1e-9 of the bar for it

/// Three scenarios of 10 s, the last with an obstacle, under terms and constraints of every kind: metrics
/// that only worsen and one that does not, upper and lower bounds, limits that are zero or the start's.
class EndCostOfThreeScenarios : public testing::Test {
 protected:
  EndCostOfThreeScenarios() {
    scenarios_.resize(3);
    for (Scenario& s : scenarios_) {
      s.duration = 10.0;
      s.robot = robot_;
    }
    scenarios_[2].obstacles.resize(1);
    for (std::size_t s = 0; s < 3; ++s) start_.push_back(some(1.0));
  }

  Objective objective() const { return {terms_, constraints_, scenarios_, start_, "study.yaml"}; }

  /// A rollout with every metric at most `scale` times what it is drawn from.
  RolloutResult some(double scale) {
    std::uniform_real_distribution<double> uniform(0.2, 1.0);
    RolloutResult r;
    r.end_time = 10.0;
    for (const Metric m : all_metrics()) r.metrics[m] = scale * uniform(draw_);
    r.metrics[Metric::kJointPositionMinMargin] = 1.0 - scale * uniform(draw_);
    r.metrics[Metric::kObstacleMinClearance] = 1.0 / (scale * uniform(draw_));
    return r;
  }

  /// Checks that the bound is no more than what random candidates cost, and returns how often it is near
  /// that.
  int expect_bounds() {
    std::uniform_int_distribution<int> one_in_two(0, 1);
    const Objective judge = objective();
    int near = 0;
    for (const double scale : {0.3, 1.0, 3.0, 30.0}) {
      for (int k = 0; k < 300; ++k) {
        std::vector<RolloutResult> results = {some(scale), some(scale), some(scale)};
        for (std::size_t s = 0; s < 3; ++s) {
          const Metrics whole = results[s].metrics;
          if (one_in_two(draw_) + one_in_two(draw_) == 2) {  // it may come to no good end, too
            results[s].status = one_in_two(draw_) == 0 ? RolloutStatus::kDiverged : RolloutStatus::kHopeless;
            results[s].end_time = 4.0;
          }
          Finished finished(3);
          for (std::size_t other = 0; other < 3; ++other) {
            if (other != s && one_in_two(draw_) == 1) finished[other] = results[other];
          }
          const double cost = penalised(results);
          const double bound = least(judge.end_cost(s, finished, kPenalty, kBar), whole);
          EXPECT_LE(bound, cost + kRounding);
          if (bound > 0.8 * cost) ++near;
        }
      }
    }
    return near;
  }

  double penalised(const std::vector<RolloutResult>& results) const {
    Evaluation e;
    e.results = results;
    objective().judge(e);
    return armtune::penalised(e, kPenalty);
  }

  std::shared_ptr<const RobotModel> robot_ = test::scenario_of("moving_target").robot;
  std::seed_seq sequence_{7};
  std::mt19937 draw_{sequence_};
  std::vector<Scenario> scenarios_;
  std::vector<RolloutResult> start_;
  std::vector<ObjectiveTerm> terms_ = {{Metric::kPositionMax, 1.0, 0.0, {0, 1, 2}},
                                       {Metric::kOrientationMax, 3.0, 2.0, {1}},
                                       {Metric::kOrientationRms, 2.0, 0.0, {0, 2}}};
  std::vector<Constraint> constraints_ = {{Metric::kJointVelocityMaxRatio, true, 0.9, {0, 1, 2}},
                                          {Metric::kJointPositionMinMargin, false, 0.0, {0, 1}},
                                          {Metric::kGazeMax, true, {}, {2}},
                                          {Metric::kObstacleMinClearance, false, {}, {0, 2}},
                                          {Metric::kGazeRms, true, 0.5, {0, 1, 2}}};
};

TEST_F(EndCostOfThreeScenarios, IsNoMoreThanWhatTheCandidateCosts) {
  EXPECT_GT(expect_bounds(), 300) << "the bound says something";
}

TEST_F(EndCostOfThreeScenarios, IsNoMoreThanThatWithTermsOfWhichMoreIsBetter) {
  terms_ = {{Metric::kPositionMax, 1.0, 0.0, {0, 1, 2}},
            {Metric::kJointPositionMinMargin, 1.0, 0.5, {0, 1}},
            {Metric::kObstacleMinClearance, 1.0, 0.0, {2}},
            {Metric::kResponseBandwidth, 0.5, 0.0, {1}}};
  EXPECT_GT(expect_bounds(), 100) << "the bound says something";
}

TEST_F(EndCostOfThreeScenarios, GrowsAsAMetricOfWhichMoreIsBetterFalls) {
  terms_ = {{Metric::kObstacleMinClearance, 1.0, 0.0, {2}}};
  constraints_.clear();
  const double start = start_[2].metrics[Metric::kObstacleMinClearance];
  const EndCost cost = objective().end_cost(2, Finished(3), kPenalty, kBar);
  ASSERT_EQ(cost.shares.size(), 1U);
  const auto share = [&](double clearance) { return cost.shares[0].at(clearance); };
  EXPECT_NEAR(share(start), 1.0, 1e-12) << "exact at the start";
  EXPECT_EQ(share(3.0 * start), 0.0);
  EXPECT_GT(share(0.5 * start), share(start));
  EXPECT_GT(share(-start), share(0.5 * start));
}

TEST_F(EndCostOfThreeScenarios, IsAllOfItOnceEveryMetricIsSeen) {
  terms_ = {{Metric::kPositionMax, 1.0, 0.0, {0, 1, 2}},
            {Metric::kGazeTimeOutside, 3.0, 0.5, {1}},
            {Metric::kOrientationRms, 2.0, 0.0, {0, 2}}};
  constraints_.pop_back();  // an RMS, known at the end only
  for (const double scale : {0.3, 1.0, 3.0, 30.0}) {
    for (int k = 0; k < 100; ++k) {
      const std::vector<RolloutResult> results = {some(scale), some(scale), some(scale)};
      const EndCost cost = objective().end_cost(1, {results[0], std::nullopt, results[2]}, kPenalty, kBar);
      EXPECT_NEAR(least(cost, results[1].metrics), penalised(results), kRounding);
      EXPECT_LT(kBar - cost.beyond, penalised(results) + kRounding);
    }
  }
}

TEST_F(EndCostOfThreeScenarios, CountsAConstraintOnceThatIsBrokenInSeveral) {
  terms_ = {{Metric::kOrientationRms, 1.0, 0.0, {0}}};
  constraints_ = {{Metric::kJointVelocityMaxRatio, true, 0.9, {0, 1}}};
  RolloutResult done = start_[1];
  done.metrics[Metric::kJointVelocityMaxRatio] = 1.8;  // twice its limit
  Metrics now = start_[0].metrics;
  const auto cost = [&](double ratio) {
    now[Metric::kJointVelocityMaxRatio] = ratio;
    return least(objective().end_cost(0, {std::nullopt, done, std::nullopt}, kPenalty, kBar), now);
  };
  EXPECT_NEAR(cost(0.5), kPenalty, kRounding);
  EXPECT_NEAR(cost(1.8), kPenalty, kRounding);
  EXPECT_NEAR(cost(2.7), 2.0 * kPenalty, kRounding);
}

}  // namespace
}  // namespace armtune
