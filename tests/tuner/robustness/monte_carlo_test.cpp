#include "tuner/robustness/monte_carlo.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/read_back.hpp"
#include "tuner/robustness/drawn_arm.hpp"

namespace armtune::internal {
namespace monte_carlo_test {

using testing::HasSubstr;

const std::atomic<bool> kNever{false};

class MonteCarlo : public ::testing::Test {
 protected:
  MonteCarlo() {
    options_.samples = 4;
    for (const char* name : {"identified_realistic_target_switch", "identified_moving_target"}) {
      scenarios_.push_back(load_scenario(name));
      scenarios_.back().duration = 14.0;
    }
    gains_ = load_gains("extended_tuned", joint_names(*scenarios_.front().robot));
  }
  std::string csv() const {
    return samples_csv(scenarios_, options_, monte_carlo(scenarios_, gains_, options_, kNever));
  }

  std::vector<Scenario> scenarios_;
  Gains gains_;
  MonteCarloOptions options_;
};

TEST_F(MonteCarlo, OneSeedGivesTheSameBytesWithAnyNumberOfWorkers) {
  const std::string one = csv();
  options_.workers = 3;
  EXPECT_EQ(csv(), one);
  options_.seed = 2;
  EXPECT_NE(csv(), one);
}

TEST_F(MonteCarlo, ASampleAloneIsItsRow) {
  const std::string all = csv();
  options_.first = 2;
  options_.samples = 1;
  const std::string alone = csv();
  const std::string rows = alone.substr(alone.find('\n') + 1);
  EXPECT_THAT(rows, testing::StartsWith("2,identified_realistic_target_switch,completed,"));
  EXPECT_THAT(all, HasSubstr(rows));
}

TEST_F(MonteCarlo, AStopLeavesWholeSamplesOnly) {
  std::atomic<bool> stop{false};
  options_.progress = [&stop](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, 8U);
    stop = done == 5;
  };
  const auto samples = monte_carlo(scenarios_, gains_, options_, stop);
  EXPECT_EQ(samples.size(), 2U);
}

TEST_F(MonteCarlo, TheSummaryNamesTheWorstSampleOfEveryMetric) {
  const auto samples = monte_carlo(scenarios_, gains_, options_, kNever);
  int seen = 0;
  for (const MetricSpread& spread : spreads(samples, 0)) {
    const bool large_is_good = spread.metric == Metric::kJointPositionMinMargin ||
                               spread.metric == Metric::kClearanceSelf || spread.metric == Metric::kSamples;
    for (const MonteCarloSample& sample : samples) {
      const double value = sample.results[0].metrics[spread.metric];
      if (large_is_good) {
        EXPECT_GE(value, spread.worst) << name(spread.metric);
      } else {
        EXPECT_LE(value, spread.worst) << name(spread.metric);
      }
      if (sample.number != spread.worst_sample) continue;
      EXPECT_EQ(value, spread.worst) << name(spread.metric);
      ++seen;
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(Spreads, OfABandwidthTheSmallestIsTheWorst) {
  std::vector<MonteCarloSample> samples(3);
  const double bandwidths[] = {4.0, 2.0, 3.0};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].number = k;
    samples[k].results.resize(1);
    samples[k].results[0].metrics[Metric::kResponseBandwidth] = bandwidths[k];
  }
  const auto found = spreads(samples, 0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].worst, 2.0);
  EXPECT_EQ(found[0].worst_sample, 1U);
}

/// Two scenarios and samples whose metrics are awkward, or not there at all.
struct Awkward {
  std::vector<Scenario> scenarios = std::vector<Scenario>(2);
  std::vector<MonteCarloSample> samples = std::vector<MonteCarloSample>(4);

  Awkward() {
    scenarios[0].name = "plain";
    scenarios[1].name = test::kAwkwardText;
    for (Scenario& scenario : scenarios) scenario.robot = load_robot("ur10");
    for (std::size_t k = 0; k < samples.size(); ++k) {
      samples[k].number = k + (std::uint64_t{1} << 60U);
      samples[k].results.resize(2);
      samples[k].broken = {{k == 0 ? test::kFormula : "", {}}, {k == 1 ? test::kAwkwardText : "", {}}};
      for (std::size_t s = 0; s < 2; ++s) {
        RolloutResult& result = samples[k].results[s];
        if (k == 3) result.status = RolloutStatus::kDiverged;
        result.metrics.max_ratio_joint = k == 3 ? "" : "elbow_joint";
        for (std::size_t m = 0; m < kMetricCount; ++m)
          result.metrics.value[m] = (m + k + s) % 4 == 0 ? test::no_figures()[k] : test::awkward(m + k);
      }
    }
  }
};

TEST(SamplesCsv, ReadsBackToTheBitAndIsEmptyWithItsStatus) {
  const Awkward a;
  test::ReadBack read(samples_csv(a.scenarios, {}, a.samples));
  std::size_t row = 0;
  for (const MonteCarloSample& sample : a.samples) {
    for (std::size_t s = 0; s < 2; ++s, ++row) {
      const RolloutResult& result = sample.results[s];
      read.text(row, "sample", std::to_string(sample.number));
      read.text(row, "scenario", a.scenarios[s].name);
      read.text(row, "status", name(result.status));
      read.text(row, "broken_limit", sample.broken[s].text);
      read.text(row, "joint_velocity/max_ratio_joint", result.metrics.max_ratio_joint);
      for (const Metric m : all_metrics()) read.number(row, name(m), result.metrics[m]);
      const auto drawn =
          drawn_values(a.scenarios, a.scenarios[s],
                       perturbed(a.scenarios[s], Perturbation(), MonteCarloOptions().seed, sample.number));
      const auto columns = drawn_columns(a.scenarios);
      for (std::size_t c = 0; c < columns.size(); ++c) read.number(row, columns[c], drawn[c]);
    }
  }
  read.expect_all_seen(row);
}

TEST(DrawnArm, ItsColumnsSayWhatWasDrawn) {
  const Scenario own = load_scenario("realistic_obstacle_pass");
  const Scenario drawn = perturbed(own, Perturbation(), 7, 3);
  const auto columns = drawn_columns({own});
  const auto values = drawn_values({own}, own, drawn);
  ASSERT_EQ(values.size(), columns.size());
  const auto value = [&](const std::string& name) {
    return values[static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) -
                                           columns.begin())];
  };
  EXPECT_EQ(value("drawn/elbow_joint/mass_factor"), drawn.plant.mass_factors[2]);
  EXPECT_EQ(value("drawn/wrist_3_joint/rotor_factor"), drawn.plant.rotor_factors[5]);
  EXPECT_EQ(value("drawn/elbow_joint/center_y"), drawn.plant.center_offsets(1, 2));
  EXPECT_EQ(value("drawn/elbow_joint/viscous_friction"), drawn.plant.viscous_friction[2]);
  EXPECT_EQ(value("drawn/elbow_joint/theta_factor"), drawn.theta.factors[2]);
  EXPECT_EQ(value("drawn/payload"), drawn.plant.payload.mass);
  EXPECT_EQ(value("drawn/delay"), drawn.plant.torque_delay_periods);
  const std::string& obstacle = own.obstacles[0].name;
  EXPECT_EQ(value("drawn/" + obstacle + "/phase"), drawn.obstacles[0].path.phase);
}

TEST(DrawnArm, ItsFilesAreTheArmThatWasSimulated) {
  const Scenario drawn = perturbed(load_scenario("realistic_obstacle_pass"), Perturbation(), 7, 3);
  const test::TemporaryFolder folder;
  for (const auto& [name, text] : drawn_arm_files(drawn)) folder.write(name, text);
  const auto read = load_robot(folder / "arm.yaml");
  const RobotModel expected = plant_model(drawn);
  const ParameterVector of_file = theta_of(read->chain);
  const ParameterVector of_plant = theta_of(expected.chain);
  EXPECT_LT((of_file - of_plant).norm(), 1e-9 * of_plant.norm());
  EXPECT_EQ(read->chain.rotor_inertia, expected.chain.rotor_inertia);
  EXPECT_EQ(read->chain.viscous_friction, expected.chain.viscous_friction);
}

TEST(SummaryCsv, ReadsBackToTheBitAndIsEmptyForWhatIsNotFinite) {
  const Awkward a;
  test::ReadBack read(summary_csv(a.scenarios, a.samples));
  std::size_t row = 0;
  for (std::size_t s = 0; s < 2; ++s) {
    for (const MetricSpread& spread : spreads(a.samples, s)) {
      read.text(row, "scenario", a.scenarios[s].name);
      read.text(row, "metric", name(spread.metric));
      read.text(row, "unit", field(spread.metric).unit);
      read.text(row, "samples", std::to_string(spread.count));
      read.text(row, "not_given", std::to_string(spread.not_given));
      read.number(row, "median", spread.median);
      read.number(row, "p95", spread.p95);
      read.number(row, "p99", spread.p99);
      read.number(row, "worst", spread.worst);
      read.text(row++, "worst_sample", std::to_string(spread.worst_sample));
      EXPECT_EQ(spread.count + spread.not_given, a.samples.size());
      EXPECT_TRUE(std::isfinite(spread.worst)) << "an infinite figure is none";
    }
  }
  read.expect_all_seen(row);
  EXPECT_GT(row, kMetricCount);
}

TEST(Limits, AreReadAndToldApart) {
  const MetricLimit limit = parse_limit("joint_velocity/max_ratio<=0.9");
  EXPECT_EQ(to_string(limit), "joint_velocity/max_ratio <= 0.9");
  const Scenario plain = load_scenario("moving_target");
  const Scenario obstacles = load_scenario("obstacle_pass");
  RolloutResult result;
  result.metrics[Metric::kJointVelocityMaxRatio] = 0.91;
  EXPECT_EQ(broken_limit(result, {limit}, plain).text, "joint_velocity/max_ratio <= 0.9");
  EXPECT_EQ(broken_limit(result, {limit}, plain).metric, Metric::kJointVelocityMaxRatio);
  result.metrics[Metric::kJointVelocityMaxRatio] = 0.9;
  EXPECT_EQ(broken_limit(result, {limit}, plain).text, "");
  EXPECT_EQ(broken_limit(result, {parse_limit("obstacle/min_clearance>=0.1")}, plain).text, "")
      << "without obstacles";
  EXPECT_EQ(broken_limit(result, {parse_limit("obstacle/min_clearance>=0.1")}, obstacles).text,
            "obstacle/min_clearance >= 0.1")
      << "no value where there should be one";
  EXPECT_EQ(broken_limit(result, {parse_limit("response/rise_time<=1")}, load_scenario("step_position")).text,
            "response/rise_time <= 1")
      << "it never rose";
  result.metrics[Metric::kObstacleMinClearance] = 0.05;
  EXPECT_EQ(broken_limit(result, {limit, parse_limit("obstacle/min_clearance>=0.1")}, obstacles).text,
            "obstacle/min_clearance >= 0.1");
  // A loop that chatters from torque bound to torque bound may keep every other limit.
  const auto allowed = static_cast<double>(saturated_periods_allowed(plain));
  EXPECT_GT(allowed, 100.0);
  result.metrics[Metric::kJointEffortSaturatedPeriods] = allowed;
  EXPECT_EQ(broken_limit(result, {limit}, plain).text, "");
  result.metrics[Metric::kJointEffortSaturatedPeriods] = allowed + 1.0;
  EXPECT_EQ(broken_limit(result, {limit}, plain).text, "torque saturated in over 1 % of the periods");
  EXPECT_EQ(broken_limit(result, {limit}, plain).metric, std::nullopt) << "it has no limit of its own";
  result.status = RolloutStatus::kDiverged;
  EXPECT_EQ(broken_limit(result, {limit}, plain).text, "diverged");
}

TEST(Limits, WhatIsNoneIsRefused) {
  using test::refused_at;
  for (const std::string text : {"joint_velocity/max_ratio", "joint_velocity/max_ratio<0.9"}) {
    EXPECT_THAT([&] { parse_limit(text); },
                refused_at({.key = "limit", .value = text, .limit = "METRIC<=VALUE or METRIC>=VALUE"}));
  }
  const InputError misspelt = test::input_error([] { parse_limit("joint_velocity/max_rato<=0.9"); });
  EXPECT_THAT(misspelt, refused_at({.key = "limit",
                                    .value = "joint_velocity/max_rato",
                                    .limit = HasSubstr("joint_velocity/max_ratio")}));
  EXPECT_EQ(test::suggested_by(misspelt), "joint_velocity/max_ratio");
  EXPECT_THAT([] { parse_limit("gaze/rms<=much"); },
              refused_at({.key = "limit", .value = "much", .limit = "a finite number"}));
}

}  // namespace monte_carlo_test
}  // namespace armtune::internal
