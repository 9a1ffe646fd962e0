#include "tuner/verdict/search_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/rollouts.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/robustness/margins.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/study/corner.hpp"
#include "tuner/verdict/rotor_check.hpp"

namespace armtune::internal {
namespace search_checks_test {

using testing::HasSubstr;

const std::atomic<bool> kNever{false};

TuneResult result_of(bool start_feasible, double start_violation, bool feasible, double violation,
                     double objective) {
  TuneResult result;
  result.start.feasible = start_feasible;
  result.start.violation = start_violation;
  result.start.objective = 1.0;
  result.best.feasible = feasible;
  result.best.violation = violation;
  result.best.objective = objective;
  result.start.x = {0.0};
  result.best.x = {1.0};
  return result;
}

TEST(SearchOutcome, IsTunedOnlyWhereTheResultIsFeasibleAndBetterThanTheStart) {
  EXPECT_EQ(outcome_of(result_of(true, 0.0, true, 0.0, 0.9)), SearchOutcome::kTuned);
  EXPECT_EQ(outcome_of(result_of(true, 0.0, true, 0.0, 1.0)), SearchOutcome::kStart);
  EXPECT_EQ(outcome_of(result_of(true, 0.0, true, 0.0, 1.1)), SearchOutcome::kStart);
  EXPECT_EQ(outcome_of(result_of(true, 0.0, false, 0.1, 0.2)), SearchOutcome::kStart);
  // A start that breaks a constraint: any feasible point is better, whatever its objective.
  EXPECT_EQ(outcome_of(result_of(false, 0.5, true, 0.0, 1.5)), SearchOutcome::kTuned);
  EXPECT_EQ(outcome_of(result_of(false, 0.5, false, 0.2, 2.0)), SearchOutcome::kLeastViolation);
  EXPECT_EQ(outcome_of(result_of(false, 0.5, false, 0.5, 1.0)), SearchOutcome::kStart);
  // The start itself, judged again in another engine, is no other point.
  TuneResult again = result_of(false, 0.5, false, 0.4, 1.0);
  again.best.x = again.start.x;
  EXPECT_EQ(outcome_of(again), SearchOutcome::kStart);
}

/// Margins of quick gains over a short scenario: what each check says is what `failure_at` says.
TEST(MarginChecks, PassExactlyWhereTheLoopHoldsAtTheThreshold) {
  const test::ShortStudy files;
  Study study = load_study(files.path());
  study.scenarios = {test::scenario_of("realistic_fixed_target", 5.0)};
  const Gains gains = test::quick_gains(study.scenarios.front());
  MarginOptions options;
  options.stepper = study.stepper;
  int failed = 0;
  for (const double delay : {1.0, 60.0}) {
    study.thresholds = VerdictThresholds();
    study.thresholds.delay_periods = delay;
    SimulationVerdict verdict;
    ASSERT_TRUE(add_margin_checks(study, gains, {2, {}}, kNever, verdict));
    ASSERT_EQ(verdict.checks.size(), kMarginCount);
    for (std::size_t m = 0; m < kMarginCount; ++m) {
      const MarginThreshold& margin = margin_thresholds()[m];
      const MarginDemand demand{margin.kind, study.thresholds.*margin.value};
      const auto why = failure_at(margin.kind, demanded_value(demand, study.scenarios.front()),
                                  study.scenarios.front(), gains, options, kNever);
      EXPECT_EQ(verdict.checks[m].passed, why->holds()) << margin.key << ": " << why->text;
      EXPECT_EQ(verdict.checks[m].joint, why->joint);
      EXPECT_TRUE(verdict.checks[m].time == why->time || std::isnan(why->time)) << why->text;
      failed += verdict.checks[m].passed ? 0 : 1;
      if (!verdict.checks[m].passed) {
        EXPECT_EQ(verdict.checks[m].scenario, "realistic_fixed_target");
      }
    }
  }
  EXPECT_GE(failed, 1) << "sixty periods of delay are beyond any loop";
}

/// The check says what a simulation of a third and of three times the estimate says.
TEST(RotorCheck, PassesExactlyWhereTheLoopHoldsOnBothSidesOfTheEstimate) {
  const test::ShortStudy files;
  Study study = load_study(files.path());
  Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  study.scenarios = {scenario};
  SimulationVerdict none;
  ASSERT_TRUE(add_rotor_check(study, gains, {2, {}}, kNever, none));
  EXPECT_TRUE(none.checks.empty()) << "nothing is estimated";
  MarginOptions options;
  options.stepper = study.stepper;
  int failed = 0;
  for (const double rotor : {0.3, 30.0}) {
    RobotModel robot = *scenario.robot;
    robot.chain.rotor_inertia.setConstant(rotor);
    robot.estimated_rotors = joint_names(robot);
    scenario.robot = std::make_shared<const RobotModel>(std::move(robot));
    study.scenarios = {scenario};
    SimulationVerdict verdict;
    ASSERT_TRUE(add_rotor_check(study, gains, {2, {}}, kNever, verdict));
    ASSERT_EQ(verdict.checks.size(), 1U);
    const Check& check = verdict.checks.front();
    EXPECT_EQ(check.kind, CheckKind::kRotorEstimate);
    bool holds = true;
    for (const double factor : {1.0 / 3.0, 3.0}) {
      Scenario other = scenario;
      other.plant.rotor_factors = JointVector::Constant(6, factor);
      holds = loop_failure(other, gains, options, kNever)->holds() && holds;
    }
    EXPECT_EQ(check.passed, holds) << check.detail;
    failed += check.passed ? 0 : 1;
  }
  EXPECT_EQ(failed, 1) << "or only one side of the check was seen";
}

TEST(YieldCheck, CountsTheArmsThatMonteCarloCounts) {
  const test::ShortStudy files;
  Study study = load_study(files.path());
  study.scenarios = {test::scenario_of("realistic_fixed_target", 5.0)};
  study.thresholds.arms = 6;
  study.thresholds.yield = 0.5;
  Gains gains = test::quick_gains(study.scenarios.front());
  for (const double factor : {1.0, 60.0}) {
    gains.task_space_gains_p *= factor;
    SimulationVerdict verdict;
    ASSERT_TRUE(add_yield_check(study, gains, {2, {}}, kNever, verdict));
    MonteCarloOptions how;  // in Simbody alone
    how.samples = 6;
    how.perturbation = default_perturbation(study.scenarios);
    how.workers = 2;
    double kept = 0.0;
    for (const MonteCarloSample& sample : monte_carlo(study.scenarios, gains, how, kNever))
      kept += sample.keeps_all() ? 1.0 : 0.0;
    EXPECT_DOUBLE_EQ(verdict.checks.front().value, kept / 6.0) << factor;
    EXPECT_EQ(verdict.checks.front().passed, kept >= 3.0) << factor;
    EXPECT_EQ(kept > 3.0, factor == 1.0) << "or only one side of the check was seen";
  }
}

/// A constraint's value is the study's measure over its arms, which need not be the worst one's.
TEST(ConstraintCheck, SaysByWhichMeasureOverTheArmsItsValueIs) {
  const test::ShortStudy files(test::kShortParameters, test::kShortObjective,
                               "constraints: [{metric: joint_velocity/max_ratio, at_most: 0.01}]\n");
  Study study = load_study(files.path());
  for (const auto measure : {std::optional<RiskMeasure>(), std::optional(RiskMeasure::kMean),
                             std::optional(RiskMeasure::kWorst)}) {
    if (measure) {
      study.robust.emplace();
      study.robust->samples = 1;
      study.robust->measure = *measure;
    }
    CandidateRunner runner(study.scenarios, study.stepper, 1, study.robust);
    auto points = simulate_points(study, {study.space.start_point()}, runner, kNever, {});
    ASSERT_TRUE(points);
    Evaluation start = points->front();
    const Objective objective(study.terms, study.constraints, simulated_scenarios(study), start.results,
                              study.source);
    objective.judge(start);
    TuneResult result;
    result.start = result.best = start;
    SimulationVerdict verdict;
    add_search_checks(study, result, objective, verdict);
    const Check& check = verdict.checks.front();
    ASSERT_FALSE(check.passed);
    EXPECT_THAT(check.joint, testing::Not(testing::IsEmpty()));
    const bool worst = measure == RiskMeasure::kWorst;
    EXPECT_EQ(check.detail.find("worst of 2 arms") != std::string::npos, worst) << check.detail;
    EXPECT_EQ(check.detail.find("mean of 2 arms") != std::string::npos, measure == RiskMeasure::kMean)
        << check.detail;
    EXPECT_EQ(check.detail.find(" arms") != std::string::npos, measure.has_value()) << check.detail;
  }
}

TEST(BoundsNote, NamesTheGainsOnTheirBounds) {
  const test::ShortStudy files;
  const Study study = load_study(files.path());
  SimulationVerdict none;
  add_bounds_note(study, study.space.start, none);
  EXPECT_TRUE(none.notes.empty());
  Gains gains = study.space.start;
  value(gains, study.space.free.front().entry) = study.space.free.front().upper;
  SimulationVerdict one;
  add_bounds_note(study, gains, one);
  ASSERT_EQ(one.notes.size(), 1U);
  EXPECT_THAT(one.notes.front(), HasSubstr(study.space.free.front().entry.name));
}

}  // namespace search_checks_test
}  // namespace armtune::internal
