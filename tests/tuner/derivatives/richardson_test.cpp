// Derivatives of metrics on three arms with four laws, compared with Richardson differences.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/tuner/derivatives/study_of_gains.hpp"

namespace armtune::internal {
namespace richardson_test {

using test::study_of_gains;
using test::uses_of;

const std::atomic<bool> kNever{false};

const std::vector<Metric> kCompared = {
    Metric::kPositionMax,           Metric::kPositionRms,      Metric::kOrientationMax,
    Metric::kOrientationRms,        Metric::kEffortRateRms,    Metric::kJointEffortMaxRatio,
    Metric::kJointVelocityMaxRatio, Metric::kGazeRateErrorMax, Metric::kJointPositionMinMargin};

/// Central differences of a rollout along one coordinate, extrapolated to the step zero (Richardson): an
/// error of the order of h^4. The rollouts run one at a time.
class Richardson {
 public:
  Richardson(const Study& study, const std::vector<double>& x, std::size_t gain)
      : rollout_(study.scenarios.front(), study.stepper, Engine::kNative) {
    base_ = run(study, x);
    for (std::size_t i = 0; i < kSteps.size(); ++i) {
      std::vector<double> there = x;
      there[gain] += kSteps[i];
      copies_[i] = run(study, there);
      no_event_ = no_event_ && copies_[i].series.modes == base_.series.modes;
    }
  }
  /// False if an event lies between the rollouts.
  bool applies() const { return no_event_; }
  template <typename Value>
  double of(const Value& value) const {
    const auto central = [&](std::size_t i) {
      return (value(copies_[i]) - value(copies_[i + 1])) / (kSteps[i] - kSteps[i + 1]);
    };
    return (4.0 * central(2) - central(0)) / 3.0;
  }

 private:
  // Truncation is about h^4, rounding about 1e-12 / h: both are far below 1e-6.
  static constexpr std::array kSteps{4e-5, -4e-5, 2e-5, -2e-5};
  RolloutResult run(const Study& study, const std::vector<double>& x) {
    return rollout_.run(study.space.gains_at(x), {}, {}, kCompared);
  }
  Rollout rollout_;
  RolloutResult base_;
  std::array<RolloutResult, kSteps.size()> copies_;
  bool no_event_ = true;
};

struct ArmAndLaw {
  const char* scenario;
  const char* law;
};

class DerivativesOf : public testing::TestWithParam<ArmAndLaw> {};

// The law of the whole service. Compared are samples that depend noticeably on the gains: for all others, the
// rounding errors of a rollout are in the way.
TEST_P(DerivativesOf, AgreeWithRichardsonDifferencesWhereNoEventLiesBetween) {
  constexpr double kNoticeable = 1e-3;
  Scenario scenario = test::scenario_of(GetParam().scenario, 7.0);
  scenario.theta = {};
  scenario.theta.model_scale = 0.9;
  const Study study = study_of_gains({scenario}, test::gains_of(scenario, GetParam().law), 4);
  std::vector<double> x = study.space.start_point();
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += 0.02 * static_cast<double>(i + 1);
  CandidateRunner workers(study.scenarios, study.stepper, 1);
  std::vector<Richardson> references;
  for (std::size_t i = 0; i < x.size(); ++i) references.emplace_back(study, x, i);
  DerivativeOptions accurate;
  accurate.step = 3e-6;
  accurate.two_steps = true;
  // The error of a single difference is of the order of its step.
  const std::pair<DerivativeOptions, double> all[] = {{accurate, 1e-4}, {DerivativeOptions(), 1e-3}};
  for (const auto& [options, tolerance] : all) {
    const auto found = metric_derivatives(study, x, uses_of(kCompared, 1), workers, kNever, options);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->results[0].status, RolloutStatus::kCompleted) << found->results[0].reason;
    int compared = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Richardson& expected = references[i];
      if (!expected.applies()) continue;
      const auto compare = [&, gain = static_cast<int>(i), allowed = tolerance, step = options.step](
                               const auto& of, double reference, const std::string& what) {
        const double largest = of.gradient.template lpNorm<Eigen::Infinity>();
        const bool missing = std::find(of.missing.begin(), of.missing.end(), gain) != of.missing.end();
        if (missing || !(largest > kNoticeable * std::abs(of.value))) return;
        const double rounding = kRolloutRounding * (1.0 + std::abs(of.value)) / step;
        EXPECT_NEAR(of.gradient[gain], reference, allowed * largest + rounding)
            << what << " by gain " << gain;
        ++compared;
      };
      for (const MetricDerivative& d : found->metrics) {
        const Metric metric = d.use.metric;
        for (const SampleRow& row : d.rows) {
          const auto channel = static_cast<std::size_t>(row.channel);
          const auto sample = [&](const RolloutResult& r) {
            return r.series.find(metric)->at(row.period, channel);
          };
          compare(row, expected.of(sample), fmt::format("{} at {} s", name(metric), row.time));
        }
        if (d.shape != MetricShape::kRms) continue;
        compare(d, expected.of([&](const RolloutResult& r) { return r.metrics[metric]; }), name(metric));
      }
    }
    EXPECT_GT(compared, 100) << "too many events between the rollouts";
  }
}

INSTANTIATE_TEST_SUITE_P(
    ArmsAndLaws, DerivativesOf,
    testing::Values(
        ArmAndLaw{"realistic_moving_target", "adaptive"}, ArmAndLaw{"moving_target", "computed_torque"},
        ArmAndLaw{"moving_target", "joint_pd"}, ArmAndLaw{"moving_target", "impedance"},
        ArmAndLaw{"panda_moving_target", "adaptive"}, ArmAndLaw{"panda_moving_target", "computed_torque"},
        ArmAndLaw{"panda_moving_target", "joint_pd"}, ArmAndLaw{"panda_moving_target", "impedance"},
        ArmAndLaw{"youbot_moving_target", "adaptive"}, ArmAndLaw{"youbot_moving_target", "computed_torque"},
        ArmAndLaw{"youbot_moving_target", "joint_pd"}, ArmAndLaw{"youbot_moving_target", "impedance"}),
    [](const auto& test) { return fmt::format("{}_{}", test.param.scenario, test.param.law); });

}  // namespace richardson_test
}  // namespace armtune::internal
