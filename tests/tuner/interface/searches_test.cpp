// Studies and searches of the interface.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "armtune/error.hpp"
#include "armtune/evaluate.hpp"
#include "armtune/front.hpp"
#include "armtune/robustness.hpp"
#include "armtune/tune.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/perturbation.hpp"
#include "tests/tuner/support/short_scenario.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tests/tuner/support/tuned.hpp"

namespace armtune {
namespace searches_test {

using internal::test::brief;
using internal::test::quick;
using internal::test::short_scenario;
using internal::test::ShortStudy;

TEST(InterfaceOfTune, FindsWhatTheSearchFinds) {
  const ShortStudy files;
  const Study study = Study::load(files.path());
  const internal::test::Tuned inside = internal::test::run(study.inside(), 1, files / "evaluations.csv");
  std::vector<std::string> works;
  TuneOptions options = brief();
  options.workers = 2;
  options.watch.progress = [&](const Progress& at) { works.push_back(at.work); };
  const Tuned tuned = tune(study, options);
  EXPECT_EQ(tuned.objective, inside.result.best.objective);
  EXPECT_TRUE(tuned.feasible);
  EXPECT_FALSE(tuned.interrupted);
  EXPECT_EQ(tuned.best.text(), Gains(inside.result.best.gains, tuned.start.joints()).text());
  EXPECT_EQ(tuned.parameters, (std::vector<std::string>{"task_space_gains_p/rx", "slerpDurationErrorGain"}));
  ASSERT_EQ(tuned.evaluations.size(), inside.evaluations.size());
  for (std::size_t i = 0; i < tuned.evaluations.size(); ++i) {
    EXPECT_EQ(tuned.evaluations[i].x, inside.evaluations[i].x);
    EXPECT_EQ(tuned.evaluations[i].objective, inside.evaluations[i].objective);
    EXPECT_EQ(tuned.evaluations[i].violation, inside.evaluations[i].violation);
  }
  EXPECT_FALSE(tuned.verdict.checks.empty());
  EXPECT_THAT(works, testing::Contains("start"));
  EXPECT_TRUE(tuned.files.empty());
}

TEST(InterfaceOfEvaluate, GivesEveryPointWhatTheSearchGivesIt) {
  const ShortStudy files(internal::test::kShortParameters, internal::test::kShortObjective,
                         internal::test::kShortConstraints, internal::test::kShortNativeSearch);
  const Study study = Study::load(files.path());
  const Tuned tuned = tune(study, brief());
  for (const Engine engine : {Engine::kNative, Engine::kSimbody}) {
    std::vector<std::vector<double>> points;
    std::vector<TunePoint> expected;
    for (const TunePoint& point : tuned.evaluations) {
      if (point.engine != engine) continue;
      points.push_back(point.x);
      expected.push_back(point);
    }
    ASSERT_GE(points.size(), 2U);
    Evaluator evaluator(study, {engine, 2});
    EXPECT_EQ(evaluator.start().objective, 1.0);
    const double before = evaluator.simulated();
    EXPECT_NEAR(before, 16.0, 1e-9) << "two scenarios of 8 s";
    const std::vector<TunePoint> again = evaluator.evaluate(points);
    ASSERT_EQ(again.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(again[i].x, expected[i].x);
      EXPECT_EQ(again[i].objective, expected[i].objective);
      EXPECT_EQ(again[i].violation, expected[i].violation);
      EXPECT_EQ(again[i].constraints, expected[i].constraints);
    }
    EXPECT_GT(evaluator.simulated(), before);
    EXPECT_EQ(evaluator.gains_at(evaluator.start().x).text(), study.start().text());
  }
}

TEST(InterfaceOfEvaluate, SimulatesInTheEngineOfTheSearchUnlessToldOtherwise) {
  const ShortStudy native(internal::test::kShortParameters, internal::test::kShortObjective,
                          internal::test::kShortConstraints, internal::test::kShortNativeSearch);
  EXPECT_EQ(Evaluator(Study::load(native.path())).start().engine, Engine::kNative);
  EXPECT_EQ(Evaluator(Study::load(ShortStudy().path())).start().engine, Engine::kSimbody);
}

TEST(InterfaceOfEvaluate, RefusesWhatIsNoPointAndEndsWhereItIsStopped) {
  const ShortStudy files;
  Evaluator evaluator(Study::load(files.path()));
  const std::vector<double> middle = {0.5, 0.5};
  EXPECT_THAT(
      [&] {
        evaluator.evaluate({middle, {0.5}});
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("1 coordinates; the study")));
  for (const double outside : {-0.1, 1.1, double(NAN)})
    EXPECT_THAT(
        [&] {
          evaluator.gains_at({0.5, outside});
        },
        testing::ThrowsMessage<InputError>(testing::HasSubstr("between 0 and 1")));
  EXPECT_TRUE(evaluator.evaluate({}).empty());
  const std::atomic<bool> stop{true};
  Watch watch;
  watch.stop = &stop;
  EXPECT_TRUE(evaluator.evaluate({middle}, watch).empty());
  EXPECT_THROW(Evaluator(Study::load(files.path()), {}, watch), FailedError);
  Evaluator moved = std::move(evaluator);
  EXPECT_EQ(moved.evaluate({middle}).size(), 1U);
}

TEST(InterfaceOfTune, LeavesTheFilesOfARun) {
  const ShortStudy files;
  TuneOptions options = brief();
  options.folder = files / "run";
  const Tuned tuned = tune(Study::load(files.path()), options);
  EXPECT_THAT(tuned.files, testing::IsSupersetOf({"gains.yaml", "errors.csv", "verdict.yaml"}));
  for (const char* name : {"gains.yaml", "evaluations.csv", "journal.txt", "start/gains.yaml"}) {
    EXPECT_TRUE(std::ifstream(options.folder + "/" + name).good()) << name;
  }
  EXPECT_EQ(Gains::load(options.folder + "/gains.yaml", Robot::load("ur10")).text(), tuned.best.text());
  EXPECT_THROW(tune(Study::load(files.path()), options), InputError) << "the folder is used";
  options.resume = true;
  EXPECT_THROW(tune(Study::load(files.path()), options), InputError) << "the run has ended";
}

TEST(InterfaceOfTune, ARunThatWasInterruptedGoesOnToTheSameEnd) {
  const ShortStudy files;
  const Study study = Study::load(files.path());
  std::atomic<bool> stop{false};
  TuneOptions options = brief();
  options.folder = files / "run";
  options.watch.stop = &stop;
  options.watch.progress = [&](const Progress& at) { stop = stop || at.done == 4; };
  const Tuned part = tune(study, options);
  EXPECT_TRUE(part.interrupted);
  EXPECT_TRUE(part.verdict.checks.empty()) << "what was not finished has passed nothing";
  EXPECT_LT(part.evaluations.size(), 12U);
  stop = false;
  options.watch = {};
  options.resume = true;
  const Tuned whole = tune(study, options);
  const Tuned alone = tune(study, brief());
  EXPECT_EQ(whole.best.text(), alone.best.text());
  EXPECT_EQ(whole.evaluations.size(), alone.evaluations.size());
}

TEST(InterfaceOfTune, AFileThatChangedSinceItWasReadIsRefused) {
  const ShortStudy files;
  const Study study = Study::load(files.path());
  TuneOptions options = brief();
  options.folder = files / "run";
  files.write("short.yaml", "base: moving_target\nduration: 9\n");
  EXPECT_THROW(tune(study, options), InputError);
  EXPECT_FALSE(std::ifstream(options.folder + "/journal.txt").good());
  options.folder.clear();
  EXPECT_EQ(tune(study, options).evaluations.size(), 12U) << "what was read is simulated all the same";
}

TEST(InterfaceOfFront, NoPointDominatesAnother) {
  const ShortStudy files;
  FrontOptions options;
  options.levels = 2;
  options.max_evaluations = 20;
  const Front found =
      front(Study::load(files.path()), {"error/orientation/rms", "joint_velocity/max_ratio"}, options);
  ASSERT_FALSE(found.points.empty());
  EXPECT_EQ(found.start.values.size(), 2U);
  EXPECT_GT(found.points.size(), 1U);
  for (const FrontPoint& a : found.points) {
    for (const FrontPoint& b : found.points) {
      EXPECT_FALSE(a.values != b.values && a.values[0] <= b.values[0] && a.values[1] <= b.values[1]);
    }
  }
  EXPECT_THROW(front(Study::load(files.path()), {"no/metric", "objective"}, options), InputError);
  EXPECT_THROW(front(Study::load(files.path()), {}, options), InputError);
  EXPECT_THROW(front(Study::load(files.path()), {"objective"}, options), InputError);
  options.levels = 1;
  EXPECT_THROW(front(Study::load(files.path()), {"objective", "gaze/rms"}, options), InputError);
}

TEST(InterfaceOfRobustness, TheYieldIsTheShareThatKeepsAll) {
  const Scenario scenario = short_scenario();
  RobustnessOptions options;
  options.samples = 4;
  options.engine = Engine::kNative;
  const Robustness found = robustness({scenario}, quick(scenario), options);
  ASSERT_EQ(found.samples.size(), 4U);
  double kept = 0.0;
  for (const RobustnessSample& sample : found.samples) kept += sample.keeps_all() ? 1.0 : 0.0;
  EXPECT_EQ(found.yield(), kept / 4.0);
  EXPECT_THAT(found.verdict.assumes, testing::Contains(testing::HasSubstr("Simbody did not simulate")));
  EXPECT_NE(found.samples[0].rollouts[0].metric("error/position/max"),
            found.samples[1].rollouts[0].metric("error/position/max"));
  options.perturbation = {{"no such width", 0.1}};
  EXPECT_THROW(robustness({scenario}, quick(scenario), options), InputError);
  options.perturbation = {};
  const internal::test::TemporaryFolder folder;
  options.folder = folder / "run";
  EXPECT_THROW(robustness({scenario}, quick(scenario), options), InputError) << "a scenario that was changed";
  options.folder.clear();
  EXPECT_THROW(robustness({}, quick(scenario), options), InputError) << "no scenario at all";
  options.samples = 0;
  EXPECT_THROW(robustness({scenario}, quick(scenario), options), InputError);
}

TEST(InterfaceOfRobustness, WidthsAreThoseOfThePerturbation) {
  const Scenario scenario = short_scenario();
  RobustnessOptions options;
  options.samples = 2;
  options.engine = Engine::kNative;
  options.perturbation = {{"mass", 0.05}, {"target_speed", 0.0}, {"payload", 0.0}};
  const Robustness found = robustness({scenario}, quick(scenario), options);
  internal::Perturbation widths = internal::default_perturbation(std::vector{scenario.inside()});
  widths.mass = 0.05;
  widths.target_speed = 0.0;
  widths.payload = 0.0;
  for (const RobustnessSample& sample : found.samples) {
    const internal::Scenario arm =
        internal::perturbed(scenario.inside(), widths, options.seed, sample.number);
    const auto alone = internal::Rollout(arm, internal::Stepper::kMidpoint, internal::Engine::kNative)
                           .run(quick(scenario).inside());
    EXPECT_EQ(sample.rollouts[0].metric("error/position/max"), alone.metrics[internal::Metric::kPositionMax]);
    EXPECT_FALSE(sample.rollouts[0].broken_limits().has_value()) << "nobody looked";
  }
}

TEST(InterfaceOfMargins, EveryMarginOfEveryScenario) {
  const Scenario scenario = short_scenario();
  MarginsOptions options;
  options.engine = Engine::kNative;
  options.workers = 2;
  const std::vector<Margin> found = margins({scenario}, quick(scenario), options).margins;
  std::vector<std::string> kinds;
  for (const Margin& margin : found) {
    kinds.push_back(margin.kind);
    EXPECT_EQ(margin.scenario, "short");
    ASSERT_TRUE(margin.stands && margin.fails) << margin.kind;
    EXPECT_EQ(std::abs(*margin.fails - margin.nominal) > std::abs(*margin.stands - margin.nominal), true);
  }
  EXPECT_THAT(kinds,
              testing::UnorderedElementsAre("torque_delay", "gain_factor", "control_rate", "velocity_noise"));
}

}  // namespace searches_test
}  // namespace armtune
