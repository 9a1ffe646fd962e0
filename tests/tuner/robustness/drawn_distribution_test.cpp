// Random arms that are drawn from a joint distribution.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/csv/csv_table.hpp"
#include "sim/scenario/arm_distribution.hpp"
#include "tests/sim/support/arm_distributions.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/robustness/drawn_arm.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/verdict/yield_check.hpp"

namespace armtune::internal {
namespace drawn_distribution_test {

using testing::Contains;
using testing::HasSubstr;

const std::atomic<bool> kNever{false};

class DrawnDistribution : public ::testing::Test {
 protected:
  /// Options with which arms are drawn from a file with this text.
  MonteCarloOptions options(const std::string& text) {
    MonteCarloOptions given;
    given.samples = 4;
    given.engine = Engine::kNative;
    given.perturbation = default_perturbation(scenarios_);
    draw_from(load_arm_distribution(folder_.write("uncertainty.yaml", text), scenarios_), given.perturbation);
    return given;
  }
  std::vector<MonteCarloSample> samples(const MonteCarloOptions& given) {
    return monte_carlo(scenarios_, test::quick_gains(scenarios_[0]), given, kNever);
  }

  test::TemporaryFolder folder_;
  std::vector<Scenario> scenarios_ = {test::scenario_of("realistic_fixed_target", 4.0),
                                      test::scenario_of("realistic_moving_target", 4.0)};
};

TEST_F(DrawnDistribution, OneSeedGivesTheSameBytesWithAnyNumberOfWorkers) {
  MonteCarloOptions given = options(test::kSmallDistribution);
  const std::string one = samples_csv(scenarios_, given, samples(given));
  given.workers = 3;
  EXPECT_EQ(samples_csv(scenarios_, given, samples(given)), one);
  given.seed = 2;
  EXPECT_NE(samples_csv(scenarios_, given, samples(given)), one);
}

TEST_F(DrawnDistribution, ItsColumnsHaveTheValuesOfEachArmInEveryScenario) {
  const MonteCarloOptions given = options(test::kSmallDistribution);
  const auto found = samples(given);
  const CsvTable table = CsvTable::parse(samples_csv(scenarios_, given, found), "samples.csv");
  const ArmDistribution& from = *given.perturbation.distribution;
  for (std::size_t i = 0; i < from.parameters.size(); ++i) {
    const std::vector<double> column = table.numbers(table.column("distribution/" + from.parameters[i].name));
    ASSERT_EQ(column.size(), 2 * found.size());
    for (std::size_t row = 0; row < column.size(); ++row) {
      const Eigen::VectorXd values = drawn_parameters(from, given.seed, found[row / 2].number);
      EXPECT_EQ(column[row], values[static_cast<Eigen::Index>(i)]) << from.parameters[i].name;
    }
  }
}

TEST_F(DrawnDistribution, AParameterThatArmsCannotVaryHasNoColumnAndIsNamed) {
  const MonteCarloOptions given = options(test::kDriveDistribution);
  const auto columns = distribution_columns(given.perturbation);
  EXPECT_EQ(columns.size(), 6U);
  EXPECT_THAT(columns, testing::Not(Contains("distribution/elbow_joint/torque_factor")));
  EXPECT_THAT(spread_text("the given", given.perturbation), HasSubstr("elbow_joint/torque_factor"));
}

TEST_F(DrawnDistribution, TheVerdictNamesItsFileAndWhatNoLogTells) {
  const MonteCarloOptions given = options(test::kSmallDistribution);
  const SimulationVerdict verdict = yield_verdict(scenarios_, samples(given), given);
  EXPECT_THAT(verdict.assumes, Contains(testing::AllOf(HasSubstr(folder_ / "uncertainty.yaml"),
                                                       HasSubstr("4 parameters"), HasSubstr("1 of them"))));
  EXPECT_THAT(verdict.assumes, testing::Not(Contains(HasSubstr("no more than")))) << "nothing is uniform";
}

TEST_F(DrawnDistribution, WhatElseVariesAndTheNoteOfTheFileAreSaid) {
  MonteCarloOptions given = options("note: too narrow\n" + test::kSmallDistribution);
  given.perturbation.mass = 0.1;
  given.perturbation.payload = 2.5;
  EXPECT_THAT(
      spread_text("the given", given.perturbation),
      testing::AllOf(HasSubstr("the given random changes"), HasSubstr("2.5 kg"), HasSubstr("too narrow")));
}

}  // namespace drawn_distribution_test
}  // namespace armtune::internal
