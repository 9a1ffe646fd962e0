#include "tuner/study/corner.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/sim/support/rollouts.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/evaluation/simulate_points.hpp"
#include "tuner/robustness/margins.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace corner_test {

using test::refused_at;
using testing::HasSubstr;

const std::atomic<bool> kNever{false};
const std::string kMargins = "margins: {delay_periods: 1, gain: 1.2, noise: 2, rate: 0.8}\n";

/// A constraint's corner rollout and a margin's bisection must agree on every loop, the sound and the unsound
/// ones.
TEST(Corner, HoldsExactlyWhereTheMarginsSayThatTheLoopHolds) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  MarginOptions options;
  int held = 0;
  int failed = 0;
  for (const MarginThreshold& margin : margin_thresholds()) {
    const bool rate = margin.kind == MarginKind::kControlRate;
    for (const double value : {rate ? 0.9 : 2.0, rate ? 0.3 : 8.0, rate ? 0.1 : 40.0}) {
      const MarginDemand demand{margin.kind, value};
      const Scenario corner = corner_of(scenario, demand);
      const RolloutResult result = Rollout(corner, Stepper::kMidpoint).run(gains);
      const auto why =
          failure_at(margin.kind, demanded_value(demand, scenario), scenario, gains, options, kNever);
      ASSERT_TRUE(why);
      EXPECT_EQ(missing_to_hold(result, corner) <= 0.0, why->holds())
          << margin.key << " at " << value << ": " << why->text;
      ++(why->holds() ? held : failed);
    }
  }
  EXPECT_GT(held, 2) << "or the law says nothing of loops that hold";
  EXPECT_GT(failed, 2);
}

TEST(Corner, WithNothingDemandedIsTheScenarioItself) {
  const Scenario scenario = test::scenario_of("realistic_fixed_target", 5.0);
  const Gains gains = test::quick_gains(scenario);
  const RolloutResult own = Rollout(scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
  for (const MarginThreshold& margin : margin_thresholds()) {
    const double nothing = margin.kind == MarginKind::kTorqueDelay ? 0.0 : 1.0;
    const Scenario corner = corner_of(scenario, {margin.kind, nothing});
    EXPECT_EQ(test::bits(Rollout(corner, Stepper::kMidpoint, Engine::kNative).run(gains).metrics),
              test::bits(own.metrics))
        << margin.key;
  }
}

TEST(Corner, MissesMoreTheEarlierALoopBreaksOff) {
  const Scenario corner = corner_of(test::scenario_of("moving_target", 5.0), {MarginKind::kGainFactor, 1.2});
  RolloutResult diverged;
  diverged.status = RolloutStatus::kDiverged;
  double last = 0.0;
  for (const double end : {5.0, 3.0, 0.1}) {
    diverged.end_time = end;
    EXPECT_GT(missing_to_hold(diverged, corner), last);
    last = missing_to_hold(diverged, corner);
  }
  EXPECT_GE(last, 1.0);
}

TEST(Corner, LacksWhatAnAccelerationIsBeyondItsLimit) {
  Scenario scenario = test::scenario_of("moving_target", 5.0);
  RolloutResult result;
  for (const Metric ratio : {Metric::kJointVelocityMaxRatio, Metric::kJointAccelerationMaxRatio})
    result.metrics[ratio] = ratio == Metric::kJointVelocityMaxRatio ? 0.5 : 1.25;
  result.metrics[Metric::kJointPositionMinMargin] = 1.0;
  result.metrics[Metric::kJointEffortSaturatedPeriods] = 0.0;
  result.metrics[Metric::kObstacleMinClearance] = 1.0;
  const MarginDemand demand{MarginKind::kGainFactor, 1.2};
  EXPECT_LT(missing_to_hold(result, corner_of(scenario, demand)), 0.0) << "the robot file has no such limit";
  RobotModel limited = *scenario.robot;
  limited.joints[2].limits.acceleration = 4.0;
  scenario.robot = std::make_shared<const RobotModel>(limited);
  EXPECT_DOUBLE_EQ(missing_to_hold(result, corner_of(scenario, demand)), 0.25);
}

TEST(Corner, AStudysMarginsBecomeOneConstraintEachOverCornersOfEveryScenario) {
  const test::ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                               test::kShortSearch + kMargins + "robust: {samples: 3, measure: worst}\n");
  const Study study = load_study(files.path());
  ASSERT_EQ(study.margins.size(), 4U);
  EXPECT_EQ(study.constraints.size(), 2U + 4U);
  EXPECT_EQ(rollouts_per_evaluation(study), 2U * (4U + 4U));
  const std::vector<Scenario> all = simulated_scenarios(study);
  ASSERT_EQ(all.size(), 2U * 5U);
  for (std::size_t s = 0; s < all.size(); ++s) EXPECT_EQ(all[s].pushed, s >= 2) << s;
  for (std::size_t c = 2; c < study.constraints.size(); ++c) {
    for (const std::size_t s : study.constraints[c].scenarios) {
      EXPECT_THAT(all[s].name, HasSubstr(name(study.constraints[c].margin->kind)));
    }
  }
  // Written out and read again it demands the same.
  const std::string copy = files.write("copy.yaml", study_yaml(study, "gains.yaml"));
  const Study again = load_study(copy);
  ASSERT_EQ(again.margins.size(), study.margins.size());
  for (std::size_t m = 0; m < study.margins.size(); ++m) {
    EXPECT_EQ(again.margins[m].kind, study.margins[m].kind);
    EXPECT_EQ(again.margins[m].value, study.margins[m].value);
  }
}

/// Arms are drawn for the scenarios; corners are the nominal arm's.
TEST(Corner, RolloutsAreOfTheNominalArmAndWhatIsMissingIsTheConstraint) {
  const test::ShortStudy files(
      test::kShortParameters, test::kShortObjective, test::kShortConstraints,
      test::kShortSearch + "margins: {gain: 1.2, rate: 0.8}\n" + "robust: {samples: 2, measure: worst}\n");
  const Study study = load_study(files.path());
  CandidateRunner workers(simulated_scenarios(study), study.stepper, 2, study.robust);
  Conditions native;
  native.engine = Engine::kNative;
  const auto found = simulate_points(study, {study.space.start_point()}, workers, kNever, native);
  ASSERT_TRUE(found);
  Evaluation e = found->front();
  const std::vector<Scenario> all = simulated_scenarios(study);
  ASSERT_EQ(e.results.size(), all.size());
  const Objective objective(study.terms, study.constraints, all, e.results, "test");
  objective.judge(e);
  for (std::size_t s = 2; s < all.size(); ++s) {
    const RolloutResult alone = Rollout(all[s], study.stepper, Engine::kNative).run(e.gains);
    EXPECT_EQ(test::bits(e.results[s].metrics), test::bits(alone.metrics)) << all[s].name;
  }
  for (std::size_t m = 0; m < study.margins.size(); ++m) {
    const std::size_t c = study.constraints.size() - study.margins.size() + m;
    double worst = -HUGE_VAL;
    for (const std::size_t s : study.constraints[c].scenarios)
      worst = std::max(worst, missing_to_hold(e.results[s], all[s]));
    EXPECT_EQ(e.constraints[c], worst);
  }
}

TEST(Corner, ADemandOfNothingOrOfHalfAPeriodIsRefused) {
  const auto refused = [](const std::string& margins) {
    const test::ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                                 test::kShortSearch + "margins: {" + margins + "}\n");
    return test::input_error([&] { load_study(files.path()); });
  };
  EXPECT_THAT(refused(""),
              refused_at({.line = 14, .key = "margins", .limit = testing::StartsWith("one of: ")}));
  EXPECT_THAT(
      refused("delay_periods: 0.5"),
      refused_at({.line = 14, .key = "margins/delay_periods", .value = "0.5", .limit = "a whole number"}));
  EXPECT_THAT(refused("gain: 0.5"),
              refused_at({.line = 14, .key = "margins/gain", .value = "0.5", .limit = "1 to 100"}));
  EXPECT_THAT(refused("gains: 1.2"), refused_at({.line = 14, .key = "margins/gains", .value = "gains"}));
}

/// What is checked is what the file asks for: half a period would be cut to none without a word.
TEST(Corner, AVerdictOfHalfAPeriodOrOfHalfAnArmIsRefused) {
  const test::ShortStudy files;
  std::ifstream file(files.path());
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::string without = text.substr(0, text.find("verdict:"));
  for (const auto& [key, value] : {std::pair("delay_periods", "1.5"), std::pair("arms", "20.5")}) {
    files.write("study.yaml", without + "verdict: {" + key + ": " + value + "}\n");
    EXPECT_THAT([&] { return load_study(files.path()); }, refused_at({.file = files.path(),
                                                                      .line = 14,
                                                                      .key = std::string("verdict/") + key,
                                                                      .value = value,
                                                                      .limit = "a whole number"}));
  }
}

}  // namespace corner_test
}  // namespace armtune::internal
