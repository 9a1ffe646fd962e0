#include "tuner/samples/sample_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/search/tune.hpp"

namespace armtune::internal {
namespace sample_set_test {

using test::refused_at;

const std::atomic<bool> kNever{false};

SampleSet set_of(RiskMeasure measure, double level = 0.8) {
  SampleSet set;
  set.measure = measure;
  set.level = level;
  return set;
}

TEST(RiskMeasures, OfErrorsLookAtTheLargeOnes) {
  const std::vector<double> values = {5, 1, 4, 2, 3};
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kMean), false, values), 3.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kQuantile, 0.75), false, values), 4.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kWorst), false, values), 5.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kConditionalValueAtRisk, 0.6), false, values), 4.5);
  for (const RiskMeasure m : {RiskMeasure::kMean, RiskMeasure::kQuantile, RiskMeasure::kWorst,
                              RiskMeasure::kConditionalValueAtRisk}) {
    EXPECT_TRUE(std::isnan(measured(set_of(m), false, {1, NAN, 2})))
        << "an arm without a value is no good arm";
  }
}

TEST(RiskMeasures, OfClearanceLookAtTheSmallOnes) {
  const std::vector<double> values = {5, 1, 4, 2, 3};
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kMean), true, values), 3.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kQuantile, 0.75), true, values), 2.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kWorst), true, values), 1.0);
  EXPECT_DOUBLE_EQ(measured(set_of(RiskMeasure::kConditionalValueAtRisk, 0.6), true, values), 1.5);
}

TEST(RiskMeasures, HaveWeightsThatAreTheirDerivatives) {
  const std::vector<double> values = {5, 1, 4, 2, 3.5};
  for (const bool more_is_better : {false, true}) {
    for (const SampleSet& set :
         {set_of(RiskMeasure::kMean), set_of(RiskMeasure::kQuantile, 0.7), set_of(RiskMeasure::kWorst),
          set_of(RiskMeasure::kConditionalValueAtRisk, 0.7)}) {
      const std::vector<double> weights = risk_weights(set, more_is_better, values);
      ASSERT_EQ(weights.size(), values.size());
      double sum = 0.0;
      for (std::size_t k = 0; k < values.size(); ++k) {
        sum += weights[k] * values[k];
        constexpr double kStep = 0.125;  // keeps the order
        std::vector<double> changed = values;
        changed[k] += kStep;
        const double change = measured(set, more_is_better, changed) - measured(set, more_is_better, values);
        EXPECT_NEAR(weights[k], change / kStep, 1e-12) << k;
      }
      EXPECT_NEAR(sum, measured(set, more_is_better, values), 1e-12);
    }
  }
}

TEST(FoldedResult, IsCompletedOnlyIfEverySampleIs) {
  std::vector<RolloutResult> samples(3);
  for (std::size_t k = 0; k < 3; ++k) {
    samples[k].end_time = 8.0;
    samples[k].metrics[Metric::kJointVelocityMaxRatio] = 0.1 * static_cast<double>(k);
    samples[k].metrics.max_ratio_joint = std::string(1, static_cast<char>('a' + k));
  }
  RolloutResult all = folded(set_of(RiskMeasure::kWorst), samples);
  EXPECT_EQ(all.status, RolloutStatus::kCompleted);
  EXPECT_EQ(all.metrics.max_ratio_joint, "c");
  EXPECT_DOUBLE_EQ(all.metrics[Metric::kJointVelocityMaxRatio], 0.2);
  samples[1].status = RolloutStatus::kDiverged;
  samples[1].reason = "diverged at 3 s";
  samples[1].end_time = 3.0;
  all = folded(set_of(RiskMeasure::kMean), samples);
  EXPECT_EQ(all.status, RolloutStatus::kDiverged);
  EXPECT_EQ(all.reason, "sample 1: diverged at 3 s");
  EXPECT_EQ(all.end_time, 3.0);
}

TEST(FoldedResult, NamesJointAndTimeOfOneArmTheOneWithTheLargestVelocity) {
  std::vector<RolloutResult> samples(3);
  const double ratios[] = {0.4, 0.9, 0.6};
  const double times[] = {7.0, 2.0, 5.0};
  for (std::size_t k = 0; k < 3; ++k) {
    samples[k].metrics[Metric::kJointVelocityMaxRatio] = ratios[k];
    samples[k].metrics[Metric::kJointVelocityMaxRatioTime] = times[k];
    samples[k].metrics.max_ratio_joint = std::string(1, static_cast<char>('a' + k));
  }
  for (const RiskMeasure measure : {RiskMeasure::kWorst, RiskMeasure::kMean}) {
    const Metrics metrics = folded(set_of(measure), samples).metrics;
    EXPECT_EQ(metrics.max_ratio_joint, "b");
    EXPECT_EQ(metrics[Metric::kJointVelocityMaxRatioTime], 2.0);
  }
}

TEST(FoldedResult, OfSeveralFailuresIsTheOneThatEndedFirst) {
  std::vector<RolloutResult> samples(4);
  const auto fail = [&samples](std::size_t k, RolloutStatus status, double end) {
    samples[k].status = status;
    samples[k].end_time = end;
    samples[k].reason = name(status);
  };
  samples[0].end_time = 8.0;
  fail(1, RolloutStatus::kNoSamples, 8.0);
  fail(2, RolloutStatus::kHopeless, 5.0);
  fail(3, RolloutStatus::kDiverged, 2.0);
  RolloutResult all = folded(set_of(RiskMeasure::kWorst), samples);
  EXPECT_EQ(all.status, RolloutStatus::kDiverged);
  EXPECT_EQ(all.end_time, 2.0);
  EXPECT_EQ(all.reason, "sample 3: diverged");
  fail(3, RolloutStatus::kDiverged, 6.0);
  all = folded(set_of(RiskMeasure::kWorst), samples);
  EXPECT_EQ(all.status, RolloutStatus::kHopeless);
  EXPECT_EQ(all.reason, "sample 2: hopeless");
}

const std::string kRobust =
    "robust:\n  samples: 3\n  seed: 4\n  measure: worst\n"
    "  uncertainty: {mass: 0.3, payload: 2, delay: 1, noise: 0, phases: false}\n";

class RobustStudy : public ::testing::Test {
 protected:
  test::ShortStudy files_{test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                          kRobust + "search: {algorithm: COBYLA, max_evaluations: 6}\n"};
  Study study_ = load_study(files_.path());
};

TEST_F(RobustStudy, ItsWorkersGiveTheMeasureOfRolloutsOfEachArm) {
  ASSERT_TRUE(study_.robust);
  EXPECT_EQ(study_.robust->perturbation.mass, 0.3);
  EXPECT_EQ(study_.robust->perturbation.inertia, Perturbation{}.inertia) << "not named: the default";
  CandidateRunner workers(study_.scenarios, study_.stepper, 2, study_.robust);
  const std::vector<Gains> gains = {study_.space.start};
  const auto results = workers.run(gains, kNever);
  ASSERT_EQ((*results)[0].size(), study_.scenarios.size());
  for (std::size_t s = 0; s < study_.scenarios.size(); ++s) {
    double worst = 0.0;
    double nominal = 0.0;
    for (std::uint64_t k = 0; k < 3; ++k) {
      const Scenario arm = perturbed(study_.scenarios[s], study_.robust->perturbation, 4, k);
      worst = std::max(worst, Rollout(arm, study_.stepper).run(gains[0]).metrics[Metric::kOrientationRms]);
    }
    nominal = Rollout(study_.scenarios[s], study_.stepper).run(gains[0]).metrics[Metric::kOrientationRms];
    EXPECT_EQ((*results)[0][s].metrics[Metric::kOrientationRms], std::max(worst, nominal));
    EXPECT_NE(worst, nominal);
  }
}

TEST_F(RobustStudy, TunesOnTheScenariosOwnArmToo) {
  SampleSet set = *study_.robust;
  EXPECT_EQ(arms(set), set.samples + 1);
  // Arms that hardly differ from one another, and from the scenario's own by a load that it does not have.
  set.perturbation = no_perturbation();
  set.perturbation.payload = 1e-9;
  Scenario loaded = study_.scenarios[1];
  loaded.plant.payload.mass = 6.0;
  CandidateRunner workers({loaded}, study_.stepper, 2, set);
  const std::vector<Gains> gains = {study_.space.start};
  const auto results = workers.run(gains, kNever);
  const auto error = [&](const Scenario& s) {
    return Rollout(s, study_.stepper).run(gains[0]).metrics[Metric::kPositionRms];
  };
  EXPECT_EQ((*results)[0][0].metrics[Metric::kPositionRms], error(loaded));
  EXPECT_GT(error(loaded), 1.1 * error(arm_of(set, loaded, 0)));
  EXPECT_EQ(rollouts_per_evaluation(study_), study_.scenarios.size() * 4);
}

TEST_F(RobustStudy, IsTunedOnThemTheSameForAnyNumberOfWorkers) {
  const auto best = [this](int count) {
    CandidateRunner workers(study_.scenarios, study_.stepper, count, study_.robust);
    return tune(study_, workers, kNever, {}).best;
  };
  const Evaluation one = best(1);
  EXPECT_EQ(one.objective, best(3).objective);
  EXPECT_LT(one.objective, 1.0);
  CandidateRunner nominal(study_.scenarios, study_.stepper, 2);
  Study plain = study_;
  plain.robust.reset();
  EXPECT_NE(tune(plain, nominal, kNever, {}).best.objective, one.objective);
}

TEST_F(RobustStudy, IsWrittenWholeAndReadBack) {
  files_.write("again.yaml", study_yaml(study_, "gains.yaml"));
  const Study again = load_study(files_ / "again.yaml");
  ASSERT_TRUE(again.robust);
  EXPECT_EQ(again.robust->samples, 3U);
  EXPECT_EQ(again.robust->seed, 4U);
  EXPECT_EQ(again.robust->measure, RiskMeasure::kWorst);
  EXPECT_EQ(again.robust->level, study_.robust->level);
  EXPECT_FALSE(again.robust->perturbation.phases);
  for (const PerturbationField& f : perturbation_fields()) {
    EXPECT_EQ(again.robust->perturbation.*f.width, study_.robust->perturbation.*f.width) << f.name;
  }
}

TEST(RobustKeys, ThatAreWrongAreRefusedWithFileAndLine) {
  const auto refused = [](const std::string& robust) {
    const test::ShortStudy files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
                                 robust);
    InputError error = test::input_error([&] { load_study(files.path()); });
    EXPECT_THAT(error, refused_at({.file = files.path(), .line = 13}));
    return error;
  };
  EXPECT_THAT(
      refused("robust: {measure: median}\n"),
      refused_at(
          {.key = "robust/measure", .value = "median", .limit = "one of: mean, quantile, worst, cvar"}));
  EXPECT_THAT(refused("robust: {level: 1}\n"),
              refused_at({.key = "robust/level", .value = "1", .limit = "between 0 and 1, both excluded"}));
  for (const std::string samples : {"0", "1001"}) {
    EXPECT_THAT(refused("robust: {samples: " + samples + "}\n"),
                refused_at({.key = "robust/samples", .value = samples, .limit = "1 .. 1000"}));
  }
  EXPECT_THAT(refused("robust: {samples: 2.7}\n"), refused_at({.key = "robust/samples", .value = "2.7"}))
      << "no half arms";
  EXPECT_THAT(refused("robust: {uncertainty: {mass: 1.5}}\n"),
              refused_at({.key = "robust/uncertainty/mass", .value = "1.5", .limit = "in [0, 1)"}));
  const InputError misspelt = refused("robust: {uncertainty: {masses: 0.1}}\n");
  EXPECT_THAT(misspelt, refused_at({.key = "robust/uncertainty/masses", .value = "masses"}));
  EXPECT_EQ(test::suggested_by(misspelt), "mass");
}

}  // namespace sample_set_test
}  // namespace armtune::internal
