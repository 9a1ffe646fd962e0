// Studies of the interface.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "armtune/error.hpp"
#include "armtune/tune.hpp"
#include "sim/rollout/rollout.hpp"
#include "tests/tuner/support/short_scenario.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tests/tuner/support/tuned.hpp"

namespace armtune {
namespace studies_test {

using internal::test::brief;
using internal::test::quick;
using internal::test::short_scenario;
using internal::test::ShortStudy;

/// The keys of a study but scenarios and gains, one scenario's objective in place of a term.
const std::string kRest = internal::test::kShortParameters +
                          "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 0.9}\n" +
                          internal::test::kShortSearch;

TEST(InterfaceOfStudy, ATextIsTheStudyOfItsFile) {
  const ShortStudy files;
  std::stringstream text;
  text << std::ifstream(files.path()).rdbuf();
  const Study of_file = Study::load(files.path());
  StudyInputs inputs;
  inputs.scenarios = of_file.scenarios();
  inputs.start = of_file.start();
  const Study of_text = Study::parse(text.str(), inputs);
  const Tuned a = tune(of_file, brief()), b = tune(of_text, brief());
  EXPECT_EQ(a.best.text(), b.best.text());
  EXPECT_EQ(a.evaluations.size(), b.evaluations.size());
  TuneOptions options = brief();
  options.folder = files / "run";
  EXPECT_THROW(tune(of_text, options), InputError) << "no file says what was simulated";
  EXPECT_FALSE(std::ifstream(options.folder).good());
}

TEST(InterfaceOfStudy, AnOwnObjectiveIsWhatATermOfTheFileIs) {
  const Scenario scenario = short_scenario();
  StudyInputs inputs;
  inputs.scenarios = {scenario};
  inputs.start = quick(scenario);
  const Tuned term =
      tune(Study::parse("objective: [{metric: error/orientation/rms}]\n" + kRest, inputs), brief());
  inputs.objective = [](const std::vector<Rollout>& rollouts) {
    EXPECT_EQ(rollouts.size(), 1U);
    EXPECT_EQ(rollouts[0].scenario(), "short");
    return rollouts[0].metric("error/orientation/rms");
  };
  const Tuned own = tune(Study::parse(kRest, inputs), brief());
  EXPECT_EQ(own.objective, term.objective);
  EXPECT_EQ(own.best.text(), term.best.text());
  EXPECT_NEAR(own.objective,
              own.after[0].metric("error/orientation/rms") / own.before[0].metric("error/orientation/rms"),
              1e-12);
  EXPECT_LT(own.objective, 1.0);
  EXPECT_EQ(tune(Study::parse("objective: [{metric: gaze/rms}]\n" + kRest, inputs), brief()).objective,
            own.objective)
      << "it takes the place of the key";
  inputs.objective = [](const std::vector<Rollout>&) { return 0.0; };
  EXPECT_THROW(tune(Study::parse(kRest, inputs), brief()), InputError) << "zero is no reference";
  for (const double wrong : {-1.0, double(NAN)}) {
    long asked = 0;
    inputs.objective = [&](const std::vector<Rollout>&) { return ++asked > 4 ? wrong : 1.0; };
    EXPECT_THROW(tune(Study::parse(kRest, inputs), brief()), FailedError) << wrong;
  }
}

TEST(InterfaceOfStudy, AChangedScenarioStaysOne) {
  StudyInputs inputs;
  inputs.scenarios = {short_scenario()};
  inputs.start = quick(inputs.scenarios[0]);
  const Study study = Study::parse("objective: [{metric: error/orientation/rms}]\n" + kRest, inputs);
  EXPECT_FALSE(inputs.scenarios[0].as_in_file());
  EXPECT_FALSE(study.scenarios()[0].as_in_file());
  EXPECT_TRUE(Scenario::load("moving_target").as_in_file());
}

TEST(InterfaceOfStudy, PartsThatDoNotFitAreRefused) {
  const Scenario scenario = short_scenario();
  const std::string text = "objective: [{metric: error/orientation/rms}]\n" + kRest;
  StudyInputs inputs;
  inputs.scenarios = {scenario, scenario};
  inputs.start = quick(scenario);
  EXPECT_THROW(Study::parse(text, inputs), InputError) << "one name twice";
  inputs.scenarios = {Scenario::load("panda_moving_target")};
  EXPECT_THROW(Study::parse(text, inputs), InputError) << "gains of another arm";
  inputs.scenarios = {};
  EXPECT_THROW(Study::parse(text, inputs), InputError) << "no scenarios at all";
}

TEST(InterfaceOfStudy, SettersChangeOneStudyAlone) {
  const ShortStudy files;
  const Study study = Study::load(files.path());
  Study other = study;
  other.set_max_evaluations(3);
  other.set_seed(7);
  EXPECT_EQ(other.max_evaluations(), 3);
  EXPECT_EQ(other.seed(), 7U);
  EXPECT_EQ(study.max_evaluations(), 12);
  EXPECT_THROW(other.set_max_evaluations(0), InputError);
  EXPECT_EQ(tune(other, brief()).evaluations.size(), 3U);
}

}  // namespace studies_test
}  // namespace armtune
