// The committed runs keep what the README says, simulated anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/sim/support/csv.hpp"
#include "tuner/robustness/margins.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/study/corner.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune::internal {
namespace committed_results_test {

const std::string kRun = test::source_dir() + "/results/ur10_gaze";

/// Judges gains as a study does: the worst of its arms, and its margins, from its start. Native engine, which
/// the tests of the engines hold to Simbody's.
class Judge {
 public:
  explicit Judge(const std::string& study)
      : study_(as_in_the_run(load_study(study))), start_(simulated(study_.space.start)) {
    objective_.emplace(study_.terms, study_.constraints, simulated_scenarios(study_), start_.results, "test");
    objective_->judge(start_);
  }
  Evaluation judged(const Gains& gains) const {
    Evaluation e = simulated(gains);
    objective_->judge(e);
    return e;
  }
  Evaluation judged(const std::string& file) const {
    return judged(load_gains(file, joint_names(*study_.scenarios.front().robot)));
  }
  const Study& study() const { return study_; }
  const Evaluation& start() const { return start_; }

 private:
  /// The committed runs are older than the cell of the realistic scenarios.
  static Study as_in_the_run(Study study) {
    for (Scenario& scenario : study.scenarios) scenario.clearance.reset();
    return study;
  }

  Evaluation simulated(const Gains& gains) const {
    CandidateRunner workers(simulated_scenarios(study_), study_.stepper, 2, study_.robust);
    const std::atomic<bool> never{false};
    const std::vector<Gains> candidates = {gains};
    Conditions conditions;
    conditions.engine = Engine::kNative;
    Evaluation e;
    e.gains = gains;
    e.results = (*workers.run(candidates, never, {}, conditions))[0];
    return e;
  }

  Study study_;
  Evaluation start_;
  std::optional<Objective> objective_;
};

/// Start and tuned gains of the committed run.
class CommittedResults : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    judge_ = new Judge("ur10_gaze");
    tuned_ = new Evaluation(judge_->judged(kRun + "/gains.yaml"));
  }
  static void TearDownTestSuite() {
    delete judge_;
    delete tuned_;
  }
  static const Study& study() { return judge_->study(); }
  static double ratio(const std::string& scenario, Metric metric) {
    for (std::size_t s = 0; s < study().scenarios.size(); ++s) {
      if (study().scenarios[s].name == scenario) {
        return tuned_->results[s].metrics[metric] / judge_->start().results[s].metrics[metric];
      }
    }
    return NAN;
  }

  static Judge* judge_;
  static Evaluation* tuned_;
};

Judge* CommittedResults::judge_ = nullptr;
Evaluation* CommittedResults::tuned_ = nullptr;

TEST_F(CommittedResults, KeepEveryConstraintAndMarginOnEveryArmOfTheStudy) {
  EXPECT_TRUE(tuned_->feasible) << tuned_->violation;
  EXPECT_FALSE(judge_->start().feasible) << "the published gains ask a wrist for more than its torque";
  EXPECT_LE(largest_velocity_ratio(study(), *tuned_), 0.9);
  EXPECT_LE(tuned_->objective, 0.5);
}

TEST_F(CommittedResults, HalveTheOrientationErrorOfTheWorstArm) {
  EXPECT_LE(ratio("realistic_moving_target", Metric::kOrientationMax), 0.5);
}

TEST_F(CommittedResults, ReacquireTheTargetInAlmostHalfTheTime) {
  EXPECT_LE(ratio("realistic_target_switch", Metric::kReacquisitionTime), 0.5);
}

TEST_F(CommittedResults, HoldTheNumbersThatASimulationGivesAgain) {
  const auto errors = test::read_csv(kRun + "/errors.csv");
  ASSERT_EQ(errors.rows.size(), study().scenarios.size());
  for (std::size_t s = 0; s < errors.rows.size(); ++s) {
    // States toggle at an obstacle's border: there another processor's rounding may take another turn.
    if (!study().scenarios[s].obstacles.empty()) continue;
    // The file's are those of the scenario's own arm.
    const RolloutResult own = Rollout(study().scenarios[s], study().stepper).run(tuned_->gains);
    for (const Metric m : {Metric::kOrientationMax, Metric::kPositionMax, Metric::kJointVelocityMaxRatio}) {
      const double committed = std::stod(errors.at(s, name(m)));
      EXPECT_NEAR(own.metrics[m], committed, 1e-3 * committed) << errors.at(s, "scenario") << name(m);
    }
  }
}

TEST_F(CommittedResults, LoseLittleWithTheLessImportantHalfOfTheGainsFixed) {
  const Study reduced = load_study(kRun + "/reduced_study.yaml");
  EXPECT_EQ(reduced.space.free.size(), study().space.free.size() / 2);
  const auto joints = joint_names(*study().scenarios.front().robot);
  const Gains gains = load_gains(test::source_dir() + "/results/ur10_gaze_reduced/gains.yaml", joints);
  for (const GainEntry& entry : gain_entries(study().space.start, joints)) {
    const auto tuned = [&entry](const Parameter& p) { return p.entry.name == entry.name; };
    if (std::none_of(reduced.space.free.begin(), reduced.space.free.end(), tuned)) {
      EXPECT_EQ(value(gains, entry), value(study().space.start, entry)) << entry.name;
    }
  }
  const Evaluation e = judge_->judged(gains);
  EXPECT_TRUE(e.feasible) << e.violation;
  EXPECT_GE(1.0 - e.objective, 0.95 * (1.0 - tuned_->objective));
}

TEST(CommittedFront, HasNoPointThatAnotherDominatesAndDominatesThePublishedGains) {
  const std::string folder = test::source_dir() + "/results/pareto";
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
  const Judge judge(test::source_dir() + "/benchmarks/studies/ur10_gaze_nominal.yaml");
  for (const std::size_t i : {std::size_t{0}, front.size() / 2, front.size() - 1}) {
    const Evaluation e = judge.judged(folder + "/" + point_file(i));
    EXPECT_TRUE(e.feasible);
    EXPECT_NEAR(e.objective, front[i][0], 5e-3) << i;
    EXPECT_NEAR(largest_velocity_ratio(judge.study(), e), front[i][1], 5e-3) << i;
  }
}

/// What keeps the adaptation bounded must not cost accuracy: the RMS errors of the gains that were bundled
/// before it was bounded, and that failed after minutes, at payloads that the controller does not know.
TEST(CommittedExtendedGains, AreAtMostFivePercentWorseThanThoseWhoseAdaptationDrifted) {
  struct Before {
    const char* scenario;
    double payload;                // kg
    double position, orientation;  // m, rad: RMS of the whole scenario
  };
  const std::vector<Before> all = {
      {"identified_realistic_moving_target", 0.0, 9.4e-05, 0.0001879},
      {"identified_realistic_moving_target", 1.0, 9.974e-05, 0.0002336},
      {"identified_realistic_moving_target", 3.0, 0.0001242, 0.0004955},
      {"identified_realistic_target_switch", 0.0, 9.44e-05, 0.0001884},
      {"identified_realistic_target_switch", 1.0, 0.000104, 0.0002458},
      {"identified_realistic_target_switch", 3.0, 0.0001472, 0.0005334},
      {"identified_realistic_obstacle_pass", 0.0, 8.764e-05, 0.0001882},
      {"identified_realistic_obstacle_pass", 1.0, 9.203e-05, 0.0002242},
      {"identified_realistic_obstacle_pass", 3.0, 0.0001135, 0.0004429},
      {"identified_realistic_fixed_target", 0.0, 9.142e-05, 0.0001754},
      {"identified_realistic_fixed_target", 1.0, 9.674e-05, 0.0001884},
      {"identified_realistic_fixed_target", 3.0, 0.0001171, 0.000284},
      // theta starts 20 % wrong
      {"realistic_moving_target", 0.0, 0.000238, 0.0008983},
      {"realistic_moving_target", 1.0, 0.0002464, 0.0009268},
      {"realistic_moving_target", 3.0, 0.0002604, 0.001018},
      {"realistic_target_switch", 0.0, 0.0002395, 0.0009609},
      {"realistic_target_switch", 1.0, 0.0002515, 0.0009867},
      {"realistic_target_switch", 3.0, 0.0002843, 0.001114},
      {"realistic_obstacle_pass", 0.0, 0.0002083, 0.001018},
      {"realistic_obstacle_pass", 1.0, 0.0002158, 0.001023},
      {"realistic_obstacle_pass", 3.0, 0.0002301, 0.00109},
      {"realistic_fixed_target", 0.0, 0.0001715, 0.000523},
      {"realistic_fixed_target", 1.0, 0.0001837, 0.0005378},
      {"realistic_fixed_target", 3.0, 0.0002083, 0.0005777},
  };
  for (const Before& before : all) {
    Scenario scenario = load_scenario(before.scenario);
    scenario.plant.payload.mass = before.payload;
    const Gains gains = load_gains("extended_tuned", joint_names(*scenario.robot));
    const RolloutResult now = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
    ASSERT_EQ(now.status, RolloutStatus::kCompleted) << now.reason;
    EXPECT_LE(now.metrics[Metric::kPositionRms], 1.05 * before.position)
        << before.scenario << " with " << before.payload << " kg";
    EXPECT_LE(now.metrics[Metric::kOrientationRms], 1.05 * before.orientation)
        << before.scenario << " with " << before.payload << " kg";
  }
}

/// What benchmark_endurance saw: two hours of the realistic scenarios of every bundled arm, and half an hour
/// of each on twenty random arms. What does not hold is counted here and in the README, and may only become
/// less.
TEST(CommittedEndurance, TheBundledTunedGainsHoldForTwoHoursAndOnRandomArms) {
  // Three of the 280 runs on random UR10s pass an effort or velocity limit, all of them with obstacles.
  const std::map<std::string, std::size_t> failing_arms = {
      {"extended_tuned", 3}, {"panda_tuned", 0}, {"youbot_tuned", 0}};
  std::set<std::string> failed, seen;
  for (const auto& [gains, allowed] : failing_arms) {
    const auto table = test::read_csv(test::source_dir() + "/results/endurance/" + gains + "/endurance.csv");
    std::size_t arms = 0, lost = 0, scenarios = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      const std::string scenario = table.at(row, "scenario");
      const bool own = table.at(row, "arm") == "own";
      const bool passed = table.at(row, "passed") == "1";
      EXPECT_EQ(table.at(row, "minutes"), own ? "120" : "30");
      if (own) {
        ++scenarios;
        seen.insert(scenario);
        if (!passed) failed.insert(scenario);
      } else {
        ++arms;
        lost += passed ? 0 : 1;
      }
      if (!passed) continue;
      EXPECT_LE(std::stod(table.at(row, "rms_growth")), 1.2) << scenario;
      EXPECT_LE(std::stod(table.at(row, "peak_growth")), 1.5) << scenario;
    }
    EXPECT_EQ(arms, 20 * scenarios) << gains;
    EXPECT_LE(lost, allowed) << gains;
  }
  EXPECT_TRUE(failed.empty()) << *failed.begin();
  for (const std::string& name : bundled_names("scenarios")) {
    if (name.find("realistic") != std::string::npos) {
      EXPECT_EQ(seen.count(name), 1U) << name;
    }
  }
}

/// An arm that is not bundled, under the gains that `robot --task` and `tune` gave it.
TEST(CommittedUr5e, FollowsWithAThirdLessErrorThanItsStartAndHoldsEveryMargin) {
  const std::string folder = test::source_dir() + "/results/ur5e";
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
    EXPECT_EQ(failure_at(margin.kind, value, scenario, tuned, MarginOptions(), never)->text, "")
        << margin.key;
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

}  // namespace committed_results_test
}  // namespace armtune::internal
