// The committed runs keep what the README says, simulated anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "sim/scenario/gains_file.hpp"
#include "tests/sim/support/csv.hpp"
#include "tuner/robustness/margins.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/study/corner.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune {
namespace {

const std::string kRun = ARMTUNE_SOURCE_DIR "/results/ur10_gaze";

/// Start and tuned gains of the committed run over the bundled study's scenarios.
class CommittedResults : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    study_ = new Study(load_study("ur10_gaze"));
    const auto joints = joint_names(*study_->scenarios.front().robot);
    Workers workers(study_->scenarios, study_->stepper, 2);
    const std::atomic<bool> never{false};
    const std::vector<Gains> gains = {load_gains("published", joints),
                                      load_gains(kRun + "/gains.yaml", joints)};
    const auto results = workers.run(gains, never);
    objective_ = new Objective(study_->terms, study_->constraints, study_->scenarios, (*results)[0], "test");
    start_ = new Evaluation;
    tuned_ = new Evaluation;
    start_->results = (*results)[0];
    tuned_->results = (*results)[1];
    objective_->judge(*start_);
    objective_->judge(*tuned_);
  }
  static void TearDownTestSuite() {
    delete study_;
    delete start_;
    delete tuned_;
    delete objective_;
  }
  static Evaluation judged(const Gains& gains) {
    Workers workers(study_->scenarios, study_->stepper, 2);
    const std::atomic<bool> never{false};
    const std::vector<Gains> candidates = {gains};
    Evaluation e;
    e.results = (*workers.run(candidates, never))[0];
    objective_->judge(e);
    return e;
  }
  static double ratio(const std::string& scenario, Metric metric) {
    for (std::size_t s = 0; s < study_->scenarios.size(); ++s) {
      if (study_->scenarios[s].name == scenario) {
        return tuned_->results[s].metrics[metric] / start_->results[s].metrics[metric];
      }
    }
    return NAN;
  }

  static Study* study_;
  static Evaluation* start_;
  static Evaluation* tuned_;
  static Objective* objective_;
};

Study* CommittedResults::study_ = nullptr;
Evaluation* CommittedResults::start_ = nullptr;
Evaluation* CommittedResults::tuned_ = nullptr;
Objective* CommittedResults::objective_ = nullptr;

TEST_F(CommittedResults, AreFeasibleAndUseTheVelocityLimitWithoutPassingIt) {
  EXPECT_TRUE(tuned_->feasible) << tuned_->violation;
  EXPECT_GE(largest_velocity_ratio(*tuned_), 0.8);
  EXPECT_LE(largest_velocity_ratio(*tuned_), 0.9);
}

TEST_F(CommittedResults, ExtendedStudyAsksForTheClearanceOfThePublishedGains) {
  const Study extended = load_study("ur10_extended");
  const auto clearance = std::find_if(extended.constraints.begin(), extended.constraints.end(),
                                      [](auto& c) { return c.metric == Metric::kObstacleMinClearance; });
  ASSERT_NE(clearance, extended.constraints.end());
  for (std::size_t s = 0; s < study_->scenarios.size(); ++s) {
    if (study_->scenarios[s].name != "realistic_obstacle_pass") continue;
    // Rounded down to 0.1 mm in the study.
    EXPECT_NEAR(*clearance->limit, start_->results[s].metrics[Metric::kObstacleMinClearance], 2e-4);
  }
}

TEST_F(CommittedResults, HalveTheOrientationErrorOfTheRealisticArm) {
  EXPECT_LE(ratio("realistic_moving_target", Metric::kOrientationMax), 0.5);
}

TEST_F(CommittedResults, ReacquireTheTargetInLessThanHalfTheTime) {
  EXPECT_LE(ratio("realistic_target_switch", Metric::kReacquisitionTime), 0.4);
}

TEST_F(CommittedResults, BeatEveryPointOfTheSweepByATenth) {
  // Whether or not the point keeps the constraints, which the tuned gains do.
  const auto journal = test::read_csv(kRun + "/evaluations.csv");
  double best = HUGE_VAL;
  int points = 0;
  for (std::size_t row = 0; row < journal.rows.size(); ++row) {
    if (journal.at(row, "phase") != "sweep") continue;
    ++points;
    best = std::min(best, std::stod(journal.at(row, "objective")));
  }
  EXPECT_EQ(points, 25);
  EXPECT_LE(tuned_->objective, 0.9 * best);
}

TEST_F(CommittedResults, HoldTheNumbersThatASimulationGivesAgain) {
  const auto errors = test::read_csv(kRun + "/errors.csv");
  ASSERT_EQ(errors.rows.size(), study_->scenarios.size());
  for (std::size_t s = 0; s < errors.rows.size(); ++s) {
    // States toggle at an obstacle's border: there another processor's rounding may take another turn.
    if (!study_->scenarios[s].obstacles.empty()) continue;
    for (const Metric m : {Metric::kOrientationMax, Metric::kPositionMax, Metric::kJointVelocityMaxRatio}) {
      const double committed = std::stod(errors.at(s, name(m)));
      EXPECT_NEAR(tuned_->results[s].metrics[m], committed, 1e-3 * committed)
          << errors.at(s, "scenario") << name(m);
    }
  }
}

TEST_F(CommittedResults, LoseLittleWithTheLessImportantHalfOfTheGainsFixed) {
  const Study reduced = load_study(kRun + "/reduced_study.yaml");
  EXPECT_EQ(reduced.space.free.size(), study_->space.free.size() / 2);
  const auto joints = joint_names(*study_->scenarios.front().robot);
  const Gains gains = load_gains(ARMTUNE_SOURCE_DIR "/results/ur10_gaze_reduced/gains.yaml", joints);
  for (const GainEntry& entry : gain_entries(gain_fields(), joints)) {
    const auto tuned = [&entry](const Parameter& p) { return p.entry.name == entry.name; };
    if (std::none_of(reduced.space.free.begin(), reduced.space.free.end(), tuned)) {
      EXPECT_EQ(value(gains, entry), value(study_->space.start, entry)) << entry.name;
    }
  }
  const Evaluation e = judged(gains);
  EXPECT_TRUE(e.feasible) << e.violation;
  EXPECT_GE(1.0 - e.objective, 0.95 * (1.0 - tuned_->objective));
}

TEST_F(CommittedResults, FrontHasNoPointThatAnotherDominatesAndDominatesThePublishedGains) {
  const std::string folder = ARMTUNE_SOURCE_DIR "/results/pareto";
  const auto csv = test::read_csv(folder + "/pareto.csv");
  std::vector<Costs> front;
  std::optional<Costs> start;
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    const Costs costs = {std::stod(csv.at(row, "objective")),
                         std::stod(csv.at(row, "joint_velocity/max_ratio"))};
    if (csv.at(row, "kind") == "front") {
      front.push_back(costs);
    } else {
      start = costs;
    }
  }
  ASSERT_GE(front.size(), 12U);
  ASSERT_TRUE(start);
  std::size_t better = 0;
  for (const Costs& p : front) {
    if (dominates(p, *start)) ++better;
    for (const Costs& other : front) EXPECT_FALSE(dominates(other, p));
  }
  EXPECT_GE(better, 12U);
  // Its ends and its middle, from the gains beside it.
  const auto joints = joint_names(*study_->scenarios.front().robot);
  for (const std::size_t i : {std::size_t{0}, front.size() / 2, front.size() - 1}) {
    const Evaluation e = judged(load_gains(folder + "/" + point_file(i), joints));
    EXPECT_TRUE(e.feasible);
    EXPECT_NEAR(e.objective, front[i][0], 5e-3) << i;
    EXPECT_NEAR(largest_velocity_ratio(e), front[i][1], 5e-3) << i;
  }
}

/// An arm that is not bundled, under the gains that `robot --task` and `tune` gave it.
TEST(CommittedUr5e, FollowsWithAThirdLessErrorThanItsStartAndHoldsEveryMargin) {
  const std::string folder = ARMTUNE_SOURCE_DIR "/results/ur5e";
  const Scenario scenario = load_scenario(folder + "/task.yaml");
  const auto joints = joint_names(*scenario.robot);
  const Gains start = load_gains(folder + "/start/gains.yaml", joints);
  const Gains tuned = load_gains(folder + "/gains.yaml", joints);
  const std::atomic<bool> never{false};
  const RolloutResult before = Rollout(scenario, Stepper::kMidpoint).run(start);
  const RolloutResult after = Rollout(scenario, Stepper::kMidpoint).run(tuned);
  for (const Metric m : {Metric::kPositionMax, Metric::kOrientationMax}) {
    EXPECT_LE(after.metrics[m], 0.7 * before.metrics[m]) << name(m);
  }
  const VerdictThresholds thresholds;
  for (const MarginThreshold& margin : margin_thresholds()) {
    const double value = demanded_value({margin.kind, thresholds.*margin.value}, scenario);
    EXPECT_EQ(failure_at(margin.kind, value, scenario, tuned, MarginOptions(), never), "") << margin.key;
  }
  // And on 200 other arms, as the committed summaries have it.
  for (const char* set : {"start", "tuned"}) {
    const auto summary = test::read_csv(folder + "/arms/summary_" + set + ".csv");
    ASSERT_FALSE(summary.rows.empty());
    EXPECT_EQ(summary.at(0, "samples"), "200") << set;
  }
  const auto median = [&](const char* set, Metric metric) {
    const auto summary = test::read_csv(folder + "/arms/summary_" + set + ".csv");
    for (std::size_t row = 0; row < summary.rows.size(); ++row) {
      if (summary.at(row, "metric") == name(metric)) return std::stod(summary.at(row, "median"));
    }
    return std::nan("");
  };
  for (const Metric m :
       {Metric::kPositionRms, Metric::kPositionMax, Metric::kOrientationRms, Metric::kOrientationMax}) {
    EXPECT_LE(median("tuned", m), 0.7 * median("start", m)) << name(m);
  }
}

}  // namespace
}  // namespace armtune
