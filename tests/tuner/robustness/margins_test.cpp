// Margins, each confirmed by a rollout on either side.

#include "tuner/robustness/margins.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/sim/support/read_back.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/robustness/margin_report.hpp"

namespace armtune::internal {
namespace margins_test {

using testing::AllOf;
using testing::HasSubstr;

const std::atomic<bool> kNever{false};

/// Five seconds, of which the published gains that start in two track for two.
std::vector<Scenario> short_scenarios() {
  return {test::scenario_of("moving_target", 5.0), test::scenario_of("realistic_fixed_target", 5.0)};
}

const Margin& margin_of(const std::vector<Margin>& margins, MarginKind kind, const std::string& scenario) {
  const auto found = std::find_if(margins.begin(), margins.end(),
                                  [&](const Margin& m) { return m.kind == kind && m.scenario == scenario; });
  if (found == margins.end()) throw std::runtime_error("no margin in " + scenario);
  return *found;
}

/// The changed scenario and gains, written anew.
struct Case {
  Scenario scenario;
  Gains gains;
};

Case changed(MarginKind kind, double value, Case c) {
  PlantConditions& plant = c.scenario.plant;
  switch (kind) {
    case MarginKind::kTorqueDelay:
      plant.torque_delay_periods += static_cast<int>(value);
      break;
    case MarginKind::kGainFactor:
      for (Eigen::Index i = 0; i < 6; ++i) c.gains.task_space_gains_p[i] *= value;
      for (Eigen::Index i = 0; i < 6; ++i) c.gains.task_space_gains_d[i] *= value;
      break;
    case MarginKind::kControlRate:
      c.scenario.control_period = 1.0 / value;
      break;
    case MarginKind::kVelocityNoise:
      // A hundredth in every bundled scenario that has noise, and where there is none.
      plant.position_noise = 0.01 * value;
      plant.velocity_noise = value;
      break;
    case MarginKind::kCount:
      break;
  }
  return c;
}

/// Judged from a whole rollout: completed, inside the limits, a joint saturated in at most 1 % of the
/// periods.
bool stands(const Case& c) {
  double periods = 0.0;
  double saturated = 0.0;
  const JointVector effort = c.scenario.robot->effort_limits();
  const RolloutResult result =
      Rollout(c.scenario, Stepper::kMidpoint).run(c.gains, [&](const Observation& o) {
        periods += 1.0;
        saturated += (o.control->commanded.array().abs() > effort.array()).any() ? 1.0 : 0.0;
        return true;
      });
  return result.status == RolloutStatus::kCompleted &&
         result.metrics[Metric::kJointVelocityMaxRatio] <= 1.0 &&
         result.metrics[Metric::kJointPositionMinMargin] >= 0.0 && saturated <= 0.01 * periods;
}

/// The published gains in both scenarios, found by three workers. Made once, for the tests that look at it.
struct Found {
  std::vector<Scenario> scenarios = short_scenarios();
  Gains gains = test::quick_gains(scenarios.front());
  std::vector<Margin> all;
};

const Found& found() {
  static const Found result = [] {
    Found made;
    MarginOptions options;
    options.workers = 3;
    made.all = margins(made.scenarios, made.gains, options, kNever);
    return made;
  }();
  return result;
}

/// One of the scenarios, for tests that search themselves.
class Margins : public ::testing::Test {
 protected:
  const std::vector<Scenario> one_ = {short_scenarios().front()};
  const Gains gains_ = test::quick_gains(one_.front());
  MarginOptions options_;
};

TEST_F(Margins, AreConfirmedByARolloutOnEitherSide) {
  ASSERT_EQ(found().all.size(), kMarginCount * found().scenarios.size());
  for (const Margin& m : found().all) {
    SCOPED_TRACE(std::string(name(m.kind)) + " in " + m.scenario);
    ASSERT_TRUE(m.stands);
    ASSERT_TRUE(m.fails);
    EXPECT_NE(m.reason, "");
    const auto scenario = std::find_if(found().scenarios.begin(), found().scenarios.end(),
                                       [&m](const Scenario& s) { return s.name == m.scenario; });
    const Case nominal{*scenario, found().gains};
    EXPECT_TRUE(stands(changed(m.kind, *m.stands, nominal)));
    EXPECT_FALSE(stands(changed(m.kind, *m.fails, nominal)));
    // As near to each other as was asked for.
    if (m.kind == MarginKind::kTorqueDelay) {
      EXPECT_EQ(*m.fails, *m.stands + 1.0);
    } else {
      EXPECT_LE(std::abs(*m.fails - *m.stands), 0.02 * std::max(*m.fails, *m.stands));
    }
  }
}

TEST_F(Margins, LieOnTheFarSideOfTheNominal) {
  for (const Scenario& scenario : found().scenarios) {
    const auto of = [&](MarginKind kind) { return margin_of(found().all, kind, scenario.name); };
    EXPECT_EQ(of(MarginKind::kTorqueDelay).nominal, 0.0);
    EXPECT_GE(*of(MarginKind::kTorqueDelay).stands, 0.0);
    EXPECT_EQ(of(MarginKind::kGainFactor).nominal, 1.0);
    EXPECT_GT(*of(MarginKind::kGainFactor).stands, 1.0);
    EXPECT_DOUBLE_EQ(of(MarginKind::kControlRate).nominal, 500.0);
    EXPECT_LT(*of(MarginKind::kControlRate).stands, 500.0) << "slower than the scenario's";
    EXPECT_EQ(of(MarginKind::kVelocityNoise).nominal, scenario.plant.velocity_noise);
    EXPECT_GT(*of(MarginKind::kVelocityNoise).stands, scenario.plant.velocity_noise);
  }
}

TEST_F(Margins, AreTheSameBytesWithAnyNumberOfWorkers) {
  const std::string alone = margins_csv(one_, margins(one_, gains_, options_, kNever));
  options_.workers = 3;
  EXPECT_EQ(margins_csv(one_, margins(one_, gains_, options_, kNever)), alone);
}

TEST_F(Margins, AnotherEngineOnlySaysWhereToLook) {
  options_.engine = Engine::kNative;
  options_.workers = 3;
  EXPECT_EQ(margins_csv(found().scenarios, margins(found().scenarios, gains_, options_, kNever)),
            margins_csv(found().scenarios, found().all));
}

TEST_F(Margins, WhereAnotherEngineIsWrongSimbodySearchesItself) {
  // A limit between the engines' figures at the first stride, where the one then stands and the other fails.
  constexpr Metric kMetric = Metric::kEffortRateRms;
  const double stride = field(MarginKind::kGainFactor).search.stride;
  const Case pushed = changed(MarginKind::kGainFactor, stride, {one_.front(), gains_});
  const auto figure = [&](Engine engine) {
    return Rollout(pushed.scenario, Stepper::kMidpoint, engine).run(pushed.gains).metrics[kMetric];
  };
  const double between = 0.5 * (figure(Engine::kSimbody) + figure(Engine::kNative));
  const bool stands_in_simbody = figure(Engine::kSimbody) <= between;
  ASSERT_NE(stands_in_simbody, figure(Engine::kNative) <= between);

  options_.limits.push_back({kMetric, true, between});
  const Margin alone =
      margin_of(margins(one_, gains_, options_, kNever), MarginKind::kGainFactor, one_.front().name);
  options_.engine = Engine::kNative;
  const Margin helped =
      margin_of(margins(one_, gains_, options_, kNever), MarginKind::kGainFactor, one_.front().name);
  EXPECT_EQ(stands_in_simbody ? *alone.stands : *alone.fails, stride);
  EXPECT_EQ(helped.stands, alone.stands);
  EXPECT_EQ(helped.fails, alone.fails);
  EXPECT_EQ(helped.reason, alone.reason);
}

TEST_F(Margins, TheLeastIsThatOfTheScenarioThatFailsFirst) {
  for (std::size_t k = 0; k < kMarginCount; ++k) {
    const auto kind = static_cast<MarginKind>(k);
    const auto smallest = least(found().scenarios, found().all, kind);
    ASSERT_TRUE(smallest);
    for (const Margin& m : found().all) {
      if (m.kind != kind) continue;
      if (kind == MarginKind::kControlRate) {
        EXPECT_GE(*smallest->stands, *m.stands);
      } else {
        EXPECT_LE(*smallest->stands, *m.stands);
      }
    }
  }
  std::vector<Margin> partial(found().all);
  partial.erase(partial.begin());
  EXPECT_FALSE(least(found().scenarios, partial, MarginKind::kTorqueDelay))
      << "of some scenarios only it is none";
}

TEST_F(Margins, ALimitOfTheCallersTightensThem) {
  const double nominal =
      Rollout(one_.front(), Stepper::kMidpoint).run(gains_).metrics[Metric::kEffortRateRms];
  // Noise shakes the torque long before it saturates it.
  options_.limits.push_back({Metric::kEffortRateRms, true, 3.0 * nominal});
  const auto tight = margins(one_, gains_, options_, kNever);
  const Margin& m = margin_of(tight, MarginKind::kVelocityNoise, one_.front().name);
  ASSERT_TRUE(m.stands);
  EXPECT_LT(*m.stands, *margin_of(found().all, MarginKind::kVelocityNoise, one_.front().name).stands);
  EXPECT_THAT(m.reason, HasSubstr("effort_rate/rms"));
}

TEST_F(Margins, ANominalThatDoesNotStandIsTold) {
  options_.limits = {parse_limit("joint_velocity/max_ratio<=0.01")};
  const auto none = margins(one_, gains_, options_, kNever);
  ASSERT_EQ(none.size(), kMarginCount);
  for (const Margin& m : none) {
    EXPECT_FALSE(m.stands);
    EXPECT_EQ(m.fails, m.nominal);
    EXPECT_THAT(m.reason, HasSubstr("breaks joint_velocity/max_ratio <= 0.01 at "));
  }
  EXPECT_THAT(margins_csv(one_, none), HasSubstr("\ngain_factor,1,all,1,,1,moving_target: "));
  EXPECT_THAT(margins_table(one_, {{"strict", none}}),
              AllOf(HasSubstr("none"), HasSubstr("strict: the closed loop fails in moving_target")));
}

TEST_F(Margins, AStopLeavesWholeMarginsOnly) {
  std::atomic<bool> stop{false};
  options_.progress = [&stop](std::size_t done, std::size_t all) {
    EXPECT_EQ(all, kMarginCount * 2);
    stop = done == 1;
  };
  const auto some = margins(found().scenarios, found().gains, options_, stop);
  ASSERT_EQ(some.size(), 1U);
  EXPECT_EQ(some.front().stands, found().all.front().stands);
  EXPECT_EQ(margins_csv(found().scenarios, some).find(",all,"), std::string::npos);
}

TEST_F(Margins, AreShownSideBySide) {
  const std::string csv = margins_csv(found().scenarios, found().all);
  EXPECT_THAT(csv, testing::StartsWith("margin,unit,scenario,nominal,stands,fails,reason\n"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + static_cast<int>(kMarginCount) * 3);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), ','), 6 * std::count(csv.begin(), csv.end(), '\n'));
  const std::string table =
      margins_table(found().scenarios, {{"start", found().all}, {"tuned", found().all}});
  EXPECT_THAT(table, AllOf(HasSubstr("start"), HasSubstr("tuned"), HasSubstr("control_rate [Hz]"),
                           HasSubstr(" ms)"), HasSubstr("tuned: the closed loop fails at gain_factor ")));
  EXPECT_THAT(margins_by_scenario(found().scenarios, found().all), HasSubstr("\nrealistic_fixed_target "));
}

TEST(MarginsCsv, ReadsBackToTheBitAndIsEmptyWhereNothingStandsOrFails) {
  std::vector<Scenario> scenarios(3);
  scenarios[0].name = test::kAwkwardText;
  scenarios[1].name = test::kFormula;
  scenarios[2].name = "plain";
  std::vector<Margin> all;
  for (std::size_t k = 0; k < kMarginCount; ++k) {
    for (std::size_t s = 0; s < scenarios.size(); ++s) {
      const std::size_t i = all.size();
      Margin& m = all.emplace_back();
      m.kind = static_cast<MarginKind>(k);
      m.scenario = scenarios[s].name;
      m.nominal = i % 4 == 3 ? test::no_figures()[k] : test::awkward(i);
      if (i % 5 != 0) m.stands = test::awkward(i + 1);
      if (i % 3 != 1) m.fails = test::awkward(i + 2);
      if (m.fails) m.reason = i % 2 == 0 ? test::kAwkwardText : test::kFormula;
    }
  }
  all.pop_back();  // of the last kind a scenario is missing
  test::ReadBack read(margins_csv(scenarios, all));
  std::size_t row = 0;
  const auto expect_row = [&](const Margin& m, const std::string& scenario, const std::string& reason) {
    read.text(row, "margin", name(m.kind));
    read.text(row, "unit", field(m.kind).unit);
    read.text(row, "scenario", scenario);
    read.number(row, "nominal", m.nominal);
    read.number(row, "stands", m.stands.value_or(NAN));
    read.number(row, "fails", m.fails.value_or(NAN));
    read.text(row++, "reason", reason);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    expect_row(all[i], all[i].scenario, all[i].reason);
    if (i % scenarios.size() != scenarios.size() - 1) continue;
    const auto smallest = least(scenarios, all, all[i].kind);
    ASSERT_TRUE(smallest);
    expect_row(*smallest, "all",
               smallest->fails ? smallest->scenario + ": " + smallest->reason : std::string());
  }
  read.expect_all_seen(row);
  EXPECT_EQ(row, kMarginCount * 4 - 2) << "no least of a margin that one scenario is without";
}

TEST(MarginFields, TheNominalValueChangesNothing) {
  for (const char* bundled : {"moving_target", "realistic_moving_target"}) {
    const Scenario scenario = test::scenario_of(bundled);
    const Gains gains = test::published_gains(scenario);
    for (const MarginField& field : margin_fields()) {
      Scenario same = scenario;
      Gains alike = gains;
      field.apply(field.nominal(scenario), same, alike);
      EXPECT_EQ(same.control_period, scenario.control_period) << field.name;
      EXPECT_EQ(same.plant.torque_delay_periods, scenario.plant.torque_delay_periods) << field.name;
      EXPECT_EQ(same.plant.velocity_noise, scenario.plant.velocity_noise) << field.name;
      EXPECT_EQ(same.plant.position_noise, scenario.plant.position_noise) << field.name;
      EXPECT_EQ(alike.task_space_gains_p, gains.task_space_gains_p) << field.name;
      EXPECT_EQ(alike.task_space_gains_d, gains.task_space_gains_d) << field.name;
    }
  }
}

TEST(MarginFields, ASlowerRateGivesTheControllerFewerPeriods) {
  Scenario scenario = test::scenario_of("moving_target", 5.0);
  Gains gains = test::quick_gains(scenario);
  field(MarginKind::kControlRate).apply(250.0, scenario, gains);
  std::vector<double> times;
  Rollout(scenario, Stepper::kMidpoint).run(gains, [&times](const Observation& o) {
    times.push_back(o.time);
    return true;
  });
  EXPECT_EQ(times.size(), 1250U);
  EXPECT_DOUBLE_EQ(times[1], 0.004);
}

}  // namespace margins_test
}  // namespace armtune::internal
