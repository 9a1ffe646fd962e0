// Studies whose arms are drawn from a joint distribution.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/scenario/arm_distribution.hpp"
#include "tests/sim/support/arm_distributions.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/verdict/search_checks.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace armtune::internal {
namespace robust_distribution_test {

using test::refused_at;
using testing::Contains;

const std::atomic<bool> kNever{false};

/// Files of a study with these keys of `robust`, and uncertainty.yaml beside it.
struct DistributionStudy {
  explicit DistributionStudy(const std::string& robust, const std::string& text = test::kSmallDistribution)
      : files(test::kShortParameters, test::kShortObjective, test::kShortConstraints,
              "robust: {samples: 2, measure: worst, " + robust + "}\nsearch: {max_evaluations: 6}\n") {
    distribution = files.write("uncertainty.yaml", text);
  }
  Study load() const { return load_study(files.path()); }

  test::ShortStudy files;
  std::string distribution;
};

TEST(RobustDistribution, IsReadFromTheFolderOfTheStudy) {
  const DistributionStudy files("distribution: uncertainty.yaml, uncertainty: {mass: 0.1, noise: 0.25}");
  const Study study = files.load();
  ASSERT_TRUE(study.robust);
  const Perturbation& perturbation = study.robust->perturbation;
  ASSERT_TRUE(perturbation.distribution);
  EXPECT_EQ(perturbation.distribution->file, files.distribution);
  EXPECT_EQ(perturbation.mass, 0.1);
  EXPECT_EQ(perturbation.noise, 0.25);
  EXPECT_EQ(perturbation.inertia, 0.0) << "it concerns the arm and is not given";
  EXPECT_EQ(perturbation.theta, Perturbation().theta);
}

TEST(RobustDistribution, IsWrittenAndReadBack) {
  const DistributionStudy files("distribution: uncertainty.yaml, uncertainty: {mass: 0.1}");
  const Study study = files.load();
  files.files.write("again.yaml", study_yaml(study, "gains.yaml"));
  const Study again = load_study(files.files / "again.yaml");
  ASSERT_TRUE(again.robust && again.robust->perturbation.distribution);
  EXPECT_EQ(again.robust->perturbation.distribution->file, files.distribution);
  EXPECT_EQ(again.robust->perturbation.distribution->factor, study.robust->perturbation.distribution->factor);
  for (const PerturbationField& f : perturbation_fields())
    EXPECT_EQ(again.robust->perturbation.*f.width, study.robust->perturbation.*f.width) << f.name;
}

TEST(RobustDistribution, ItsArmsAreTheSameForAnyNumberOfWorkers) {
  const Study study = DistributionStudy("distribution: uncertainty.yaml").load();
  const std::vector<Gains> gains = {study.space.start};
  const auto metric = [&](int count, const std::optional<SampleSet>& set) {
    CandidateRunner workers(study.scenarios, study.stepper, count, set);
    return (*workers.run(gains, kNever))[0][1].metrics[Metric::kPositionRms];
  };
  SampleSet drawn = *study.robust;
  drawn.measure = RiskMeasure::kMean;  // the worst arm may be the scenario's own
  EXPECT_EQ(metric(1, drawn), metric(3, drawn));
  SampleSet uniform = drawn;
  uniform.perturbation.distribution = nullptr;
  EXPECT_NE(metric(1, drawn), metric(1, uniform));
}

TEST(RobustDistribution, IsAnInputOfTheRunAndInItsRecord) {
  const DistributionStudy files("distribution: uncertainty.yaml", test::kDriveDistribution);
  const Study study = files.load();
  EXPECT_THAT(inputs_of(study), Contains(files.distribution));
  EXPECT_THAT(files_of(study), Contains(files.distribution));
  const RunRecord record = record_of_search(study, {}, 1, 0.0);
  ASSERT_TRUE(record.distribution);
  EXPECT_EQ(record.distribution->file, files.distribution);
  EXPECT_EQ(record.distribution->drawn.size(), 6U);
  EXPECT_THAT(record.distribution->not_drawn, testing::ElementsAre("elbow_joint/torque_factor"));
}

TEST(RobustDistribution, TheYieldIsThatOfItsArmsAndTheVerdictNamesIt) {
  const DistributionStudy files("distribution: uncertainty.yaml");
  Study study = files.load();
  study.scenarios = {test::scenario_of("realistic_fixed_target", 4.0)};
  study.thresholds.arms = 2;
  SimulationVerdict verdict;
  ASSERT_TRUE(add_yield_check(study, test::quick_gains(study.scenarios.front()), {2, {}}, kNever, verdict));
  EXPECT_THAT(verdict.assumes, Contains(testing::HasSubstr(files.distribution)));
}

TEST(RobustDistribution, ThatDoesNotFitIsRefusedAtItsKey) {
  const auto refusal = [](const DistributionStudy& files) {
    return test::input_error([&files] { (void)files.load(); });
  };
  const DistributionStudy unknown(
      "distribution: uncertainty.yaml",
      "parameters:\n  - {name: knee/rotor_inertia, mean: 0}\ncovariance: [[1]]\n");
  EXPECT_THAT(refusal(unknown), refused_at({.file = unknown.distribution,
                                            .line = 2,
                                            .key = "parameters/0/name",
                                            .value = "knee/rotor_inertia"}));
  EXPECT_THAT(refusal(DistributionStudy("distribution: uncertainty.yaml, uncertainty: {friction: 0.25}")),
              refused_at({.line = 13, .key = "robust/uncertainty/friction", .value = "0.25"}));
  const DistributionStudy missing("distribution: none.yaml");
  EXPECT_THAT(refusal(missing), refused_at({.file = missing.files / "none.yaml"}));
}

}  // namespace robust_distribution_test
}  // namespace armtune::internal
