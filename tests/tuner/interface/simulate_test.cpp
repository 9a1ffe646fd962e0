// The interface for programs of others against what it stands for.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "armtune/error.hpp"
#include "armtune/rollout.hpp"
#include "sim/rollout/rollout.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune {
namespace simulate_test {

Scenario short_scenario(double duration = 6.0) {
  Scenario scenario = Scenario::load("moving_target");
  scenario.set_duration(duration);
  return scenario;
}

Gains quick(const Scenario& scenario) {
  return {internal::test::quick_gains(scenario.inside()), scenario.robot().joints()};
}

void expect_equal(const Rollout& a, const internal::RolloutResult& b) {
  EXPECT_EQ(a.status(), internal::name(b.status));
  for (const internal::Metric metric : internal::all_metrics()) {
    const double value = a.metric(internal::name(metric));
    EXPECT_TRUE(value == b.metrics[metric] || (std::isnan(value) && std::isnan(b.metrics[metric])))
        << internal::name(metric);
  }
}

TEST(InterfaceOfSimulate, GivesTheRolloutsOfBothEngines) {
  const Scenario scenario = short_scenario();
  const Gains gains = quick(scenario);
  for (const auto& [engine, inside] : {std::pair(Engine::kSimbody, internal::Engine::kSimbody),
                                       std::pair(Engine::kNative, internal::Engine::kNative)}) {
    SimulateOptions options;
    options.engine = engine;
    const auto rollouts = simulate({scenario}, gains, options).rollouts;
    ASSERT_EQ(rollouts.size(), 1U);
    expect_equal(
        rollouts[0],
        internal::Rollout(scenario.inside(), internal::Stepper::kMidpoint, inside).run(gains.inside()));
  }
}

TEST(InterfaceOfSimulate, ColumnsAreTheRowsOfValues) {
  const Scenario scenario = short_scenario();
  const Rollout rollout = simulate({scenario}, quick(scenario)).rollouts.front();
  ASSERT_GT(rollout.rows(), 100U);
  ASSERT_EQ(rollout.values().size(), rollout.rows() * rollout.columns().size());
  EXPECT_EQ(rollout.columns().front(), "time");
  const std::vector<double> time = rollout.column("time");
  for (std::size_t row = 0; row < rollout.rows(); ++row) {
    EXPECT_EQ(time[row], rollout.values()[row * rollout.columns().size()]);
    if (row > 0) {
      EXPECT_NEAR(time[row] - time[row - 1], 5 * scenario.control_period(), 1e-9);
    }
  }
  EXPECT_THAT([&] { (void)rollout.column("tide"); },
              internal::test::refused_at({.key = "column", .value = "tide"}));
  EXPECT_THAT([&] { (void)rollout.metric("error/tide"); },
              internal::test::refused_at({.key = "metric", .value = "error/tide"}));
  SimulateOptions unrecorded;
  unrecorded.record_every = 0;
  EXPECT_EQ(simulate({scenario}, quick(scenario), unrecorded).rollouts.front().rows(), 0U);
}

TEST(InterfaceOfSimulate, SeveralSetsAreEachAlone) {
  const Scenario scenario = short_scenario();
  Scenario other = short_scenario(7.0);
  other.set_name("longer");
  std::vector<Gains> sets(5, quick(scenario));
  for (std::size_t i = 0; i < sets.size(); ++i)
    sets[i].numbers("task_space_gains_p")[0] += static_cast<double>(i);
  for (const Engine engine : {Engine::kSimbody, Engine::kNative}) {
    SimulateOptions options;
    options.engine = engine;
    options.workers = 2;
    const auto together = simulate_sets({scenario, other}, sets, options);
    ASSERT_EQ(together.size(), sets.size());
    for (std::size_t i = 0; i < sets.size(); ++i) {
      ASSERT_EQ(together[i].size(), 2U);
      const auto alone = simulate({scenario, other}, sets[i], options).rollouts;
      EXPECT_EQ(errors_csv(together[i]), errors_csv(alone)) << i;
    }
    EXPECT_NE(errors_csv(together[0]), errors_csv(together[1])) << "the gain matters";
  }
}

TEST(InterfaceOfSimulate, BrokenLimitsAreToldWhereSomebodyLooked) {
  const Scenario scenario = Scenario::load("moving_target");
  const Gains gains = Gains::load("published", scenario.robot());
  SimulateOptions options;
  options.engine = Engine::kNative;
  const auto alone = simulate({scenario}, gains, options).rollouts.front().broken_limits();
  ASSERT_TRUE(alone.has_value());
  EXPECT_THAT(*alone, testing::Contains(testing::HasSubstr("elbow_joint")))
      << "the published gains saturate the elbow";
  EXPECT_FALSE(simulate_sets({scenario}, {gains}, options)[0][0].broken_limits().has_value());
}

TEST(InterfaceOfSimulate, TwoScenariosNeedTwoNames) {
  const Scenario scenario = short_scenario();
  EXPECT_THROW(simulate({scenario, scenario}, quick(scenario)), InputError);
  EXPECT_THROW(simulate_sets({scenario, scenario}, {quick(scenario)}), InputError);
  EXPECT_THROW(simulate({}, quick(scenario)), InputError);
  EXPECT_THROW(errors_csv({Rollout()}), InputError);
}

TEST(InterfaceOfSimulate, TellsProgressAndStops) {
  const Scenario scenario = short_scenario();
  std::vector<long> done;
  SimulateOptions options;
  options.watch.progress = [&](const Progress& at) {
    EXPECT_EQ(at.all, 3);
    done.push_back(at.done);
  };
  simulate_sets({scenario}, std::vector<Gains>(3, quick(scenario)), options);
  EXPECT_THAT(done, testing::ElementsAre(1, 2, 3));
  const std::atomic<bool> stopped{true};
  options.watch.stop = &stopped;
  const Simulated cut = simulate({scenario}, quick(scenario), options);
  EXPECT_EQ(cut.rollouts.front().status(), "interrupted");
  EXPECT_TRUE(cut.interrupted && cut.verdict.checks.empty()) << "an unfinished rollout has passed nothing";
  EXPECT_TRUE(simulate_sets({scenario}, {quick(scenario)}, options).front().empty());
}

TEST(InterfaceOfGains, NumbersAreInPlaceAndCopiesApart) {
  const Scenario scenario = short_scenario();
  Gains gains = Gains::load("published", scenario.robot());
  EXPECT_EQ(gains.numbers("task_space_gains_p").size(), 6U);
  EXPECT_EQ(gains.numbers("joint_space_gains_p").size(), scenario.robot().joints().size());
  EXPECT_EQ(gains.numbers("slerpDurationErrorGain").size(), 1U);
  const Gains before = gains;
  gains.numbers("task_space_gains_p")[3] = 31.0;
  EXPECT_EQ(gains.inside().task_space_gains_p[3], 31.0);
  EXPECT_NE(before.numbers("task_space_gains_p")[3], 31.0);
  gains.set("task_space_gains_i", 2.0);
  for (const double value : gains.numbers("task_space_gains_i")) EXPECT_EQ(value, 2.0);
  EXPECT_THROW(gains.set("task_space_gains_i", std::vector<double>{1.0, 2.0}), InputError);
  EXPECT_THROW(gains.numbers("task_space_gains_q"), InputError);
  EXPECT_THROW(gains.numbers("gaze_feedforward"), InputError);
  gains.set_word("gaze_feedforward", "true");
  EXPECT_TRUE(gains.inside().gaze_feedforward);
  EXPECT_EQ(gains.word("gaze_feedforward"), "true");
  gains.set_word("slerp_reference", "current");
  EXPECT_EQ(gains.word("slerp_reference"), "current");
  EXPECT_THROW(gains.set_word("gaze_feedforward", "yes"), InputError);
  EXPECT_THROW(gains.word("task_space_gains_p"), InputError);
  gains.set("task_space_gains_p", -1.0);
  EXPECT_THROW(gains.text(), InputError);
  EXPECT_THROW(simulate({scenario}, gains), InputError);
}

TEST(InterfaceOfGains, WhatIsSavedReadsBackToTheSameBits) {
  const internal::test::TemporaryFolder folder;
  const Scenario scenario = short_scenario();
  Gains gains = quick(scenario);
  gains.set("slerpDurationErrorGain", 1.0 / 3.0);
  gains.save(folder / "gains.yaml");
  EXPECT_EQ(Gains::load(folder / "gains.yaml", scenario.robot()).text(), gains.text());
}

TEST(InterfaceOfRobot, HasJointsAndLimits) {
  const Robot robot = Robot::load("ur10");
  ASSERT_EQ(robot.joints().size(), 6U);
  EXPECT_EQ(robot.joints().front(), "shoulder_pan_joint");
  EXPECT_EQ(robot.effort_limits().size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_GT(robot.velocity_limits()[i], 0.0);
    EXPECT_LT(robot.lower_position_limits()[i], robot.upper_position_limits()[i]);
  }
}

TEST(InterfaceOfErrors, AllAreOneHierarchyAndOneLine) {
  try {
    Scenario::load("no/such\nfile.yaml");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr("\n")));
    EXPECT_NE(dynamic_cast<const InputError*>(&error), nullptr);
  }
  Scenario scenario = short_scenario();
  EXPECT_THROW(scenario.set_duration(0.0), InputError);
  EXPECT_THROW(scenario.set_duration(NAN), InputError);
  EXPECT_THROW(scenario.set_name("../up"), InputError);
  EXPECT_THROW(simulate({Scenario::load("panda_moving_target")}, quick(scenario)), InputError);
  SimulateOptions options;
  options.workers = 0;
  EXPECT_THROW(simulate({scenario}, quick(scenario), options), InputError);
}

}  // namespace simulate_test
}  // namespace armtune
