// Study files with a fault are refused where the fault stands.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_refusals_test {

using test::refused_at;
using test::ShortStudy;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kRx = "task_space_gains_p/rx";

/// Returns the error with which a study of these parts is refused. Its file is the study's.
InputError refusal(const std::string& parameters, const std::string& objective = test::kShortObjective,
                   const std::string& constraints = test::kShortConstraints,
                   const std::string& search = test::kShortSearch) {
  const ShortStudy files(parameters, objective, constraints, search);
  InputError error = test::input_error([&] { load_study(files.path()); });
  EXPECT_THAT(error, refused_at({.file = files.path()}));
  return error;
}

/// Does the same for the objective in lines 7 and following of the file.
InputError objective_refusal(const std::string& objective) {
  return refusal(test::kShortParameters, objective);
}

/// Does the same for one constraint, in line 11 of the file.
InputError constraint_refusal(const std::string& constraint) {
  return refusal(test::kShortParameters, test::kShortObjective, "constraints:\n  - {" + constraint + "}\n");
}

/// Does the same for lines below `search:`, from line 11 of the file on.
InputError search_refusal(const std::string& text) {
  return refusal(test::kShortParameters, test::kShortObjective, "", "search:\n  " + text + "\n");
}

TEST(StudyFile, UnknownNamesAreRefusedWithTheNearest) {
  const InputError gain = refusal("parameters:\n  - {name: task_space_gain_p/rx}\n");
  EXPECT_THAT(gain, refused_at({.line = 5, .key = "parameters/0/name", .value = "task_space_gain_p/rx"}));
  EXPECT_EQ(test::suggested_by(gain), "task_space_gains_p/rx");
  const InputError metric = objective_refusal("objective:\n  - {metric: error/orientaton/rms}\n");
  EXPECT_THAT(metric, refused_at({.line = 8,
                                  .key = "objective/0/metric",
                                  .value = "error/orientaton/rms",
                                  .limit = HasSubstr("error/orientation/rms")}));
  EXPECT_EQ(test::suggested_by(metric), "error/orientation/rms");
  const InputError constraint = constraint_refusal("metric: joint_velocty/max_ratio, at_most: 1");
  EXPECT_THAT(constraint, refused_at({.line = 11,
                                      .key = "constraints/0/metric",
                                      .value = "joint_velocty/max_ratio",
                                      .limit = StartsWith("one of: ")}));
  EXPECT_EQ(test::suggested_by(constraint), "joint_velocity/max_ratio");
  EXPECT_THAT(objective_refusal("objective:\n  - {metric: gaze/rms, scenarios: [short, shirt]}\n"),
              refused_at({.line = 8,
                          .key = "objective/0/scenarios/1",
                          .value = "shirt",
                          .limit = "one of: short, short_realistic"}));
}

TEST(StudyFile, AnAlgorithmOrStepperThatIsNotOfferedIsRefused) {
  const InputError algorithm = search_refusal("algorithm: COBYLLA");
  EXPECT_THAT(algorithm, refused_at({.line = 11,
                                     .key = "search/algorithm",
                                     .value = "COBYLLA",
                                     .limit = StartsWith("one of: COBYLA, BOBYQA,")}));
  EXPECT_EQ(test::suggested_by(algorithm), "COBYLA");
  EXPECT_THAT(
      search_refusal("stepper: euler"),
      refused_at({.line = 11, .key = "search/stepper", .value = "euler", .limit = StartsWith("midpoint, ")}));
  EXPECT_THAT(
      search_refusal("engine: mujoco"),
      refused_at({.line = 11, .key = "search/engine", .value = "mujoco", .limit = "simbody or native"}));
  const InputError share = search_refusal("verify_share: 0.2");
  EXPECT_THAT(share, refused_at({.line = 11, .key = "search/verify_share", .value = "0.2"}));
  EXPECT_THAT(share.what(), HasSubstr("engine: native"));
  EXPECT_THAT(search_refusal("engine: native\n  verify_share: 1.5"),
              refused_at({.line = 12, .key = "search/verify_share", .value = "1.5", .limit = "0 to 1"}));
  EXPECT_THAT(search_refusal("engine: native\n  stepper: reference"),
              refused_at({.line = 12, .key = "search/stepper", .value = "reference"}));
  EXPECT_THAT(search_refusal("max_evaluations: 0"),
              refused_at({.line = 11, .key = "search/max_evaluations", .value = "0", .limit = "at least 1"}));
  EXPECT_THAT(search_refusal("seed: -1"),
              refused_at({.line = 11, .key = "search/seed", .value = "-1", .limit = "not negative"}));
  EXPECT_THAT(search_refusal("budget: 10"),
              refused_at({.line = 11, .key = "search/budget", .value = "budget"}));
}

TEST(StudyFile, SearchKeysThatDoNotFitAreRefusedWithTheirLine) {
  const InputError global = search_refusal("global: CRS3");
  EXPECT_THAT(global, refused_at({.line = 11, .key = "search/global", .value = "CRS3"}));
  EXPECT_EQ(test::suggested_by(global), "CRS2");
  EXPECT_EQ(test::suggested_by(search_refusal("algorithm: SLQSP")), "SLSQP");
  EXPECT_THAT(search_refusal("algorithm: MMA"),
              refused_at({.line = 11, .key = "search/algorithm", .value = "MMA", .limit = "SLSQP"}));
  for (const std::string share : {"1.5", "-0.5"}) {
    EXPECT_THAT(search_refusal("global_share: " + share),
                refused_at({.line = 11, .key = "search/global_share", .value = share, .limit = "0 to 1"}));
  }
  const InputError local = search_refusal("algorithm: COBYLA\n  global_share: 0.5");
  EXPECT_THAT(local, refused_at({.line = 12, .key = "search/global_share", .value = "0.5"}));
  EXPECT_THAT(local.what(), HasSubstr("name one with 'global'"));
  for (const std::string starts : {"0", "1000"}) {
    EXPECT_THAT(search_refusal("starts: " + starts),
                refused_at({.line = 11, .key = "search/starts", .value = starts, .limit = "1 .. 256"}));
  }
  EXPECT_THAT(search_refusal("differences: backward"), refused_at({.line = 11,
                                                                   .key = "search/differences",
                                                                   .value = "backward",
                                                                   .limit = "one of: forward, central"}));
  EXPECT_THAT(
      search_refusal("difference_step: 0"),
      refused_at({.line = 11, .key = "search/difference_step", .value = "0", .limit = "1e-06 to 0.5"}));
}

// The default bounds are multiples of the start, so that there is nothing between them.
TEST(StudyFile, AParameterThatStartsAtZeroNeedsBoundsOfItsOwn) {
  const std::string parameter = "parameters:\n  - {name: adaptation_gain, start: 0";
  const InputError error = refusal(parameter + "}\n");
  EXPECT_THAT(error, refused_at({.key = "adaptation_gain", .value = "0"}));
  EXPECT_THAT(error.what(), HasSubstr("'upper'"));
  const ShortStudy bounded(parameter + ", lower: 0, upper: 0.1, scale: linear}\n");
  EXPECT_EQ(load_study(bounded.path()).space.free[0].start, 0.0);
}

// The study names a gain that its gains file sets to zero, as the bundled gains do.
TEST(StudyFile, AGainThatIsZeroInTheGainsFileNeedsBoundsOfItsOwn) {
  const InputError error =
      refusal("parameters:\n  - {name: " + kRx + "}\n  - {name: joint_centering_gain}\n");
  EXPECT_THAT(error, refused_at({.key = "joint_centering_gain", .value = "0"}));
  for (const char* way_out : {"'lower'", "'upper'", "remove"}) EXPECT_THAT(error.what(), HasSubstr(way_out));
}

TEST(StudyFile, EqualBoundsAreRefusedWithTheKeyThatFixesAValue) {
  for (const std::string start : {"", ", start: 4"}) {
    const InputError error =
        refusal("parameters:\n  - {name: " + kRx + ", lower: 4, upper: 4" + start + "}\n");
    EXPECT_THAT(error, refused_at({.key = kRx, .value = "4"}));
    EXPECT_THAT(error.what(), HasSubstr("'fixed: 4'"));
  }
  // What the error advises is accepted.
  const ShortStudy fixed("parameters:\n  - {name: " + kRx +
                         ", fixed: 4}\n  - {name: slerpDurationErrorGain}\n");
  const Study study = load_study(fixed.path());
  EXPECT_EQ(study.space.start.task_space_gains_p[3], 4.0);
  EXPECT_EQ(study.space.free.size(), 1U);
}

TEST(StudyFile, UnknownControllersAndGainsOfOthersAreRefused) {
  EXPECT_THAT(refusal("controller: impedance\n" + test::kShortParameters),
              refused_at({.line = 6, .key = "parameters/0/name", .value = kRx}));
  EXPECT_THAT(refusal("controller: pid\n"),
              refused_at({.line = 4, .key = "controller", .value = "pid", .limit = HasSubstr("joint_pd")}));
}

TEST(StudyFile, AnUnknownScenarioIsRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write(
      "study.yaml",
      "gains: published\nscenarios:\n  - moving_target\n  - moving_tarket\nobjective:\n  - {metric: gaze/rms}\n");
  const InputError error = test::input_error([&] { load_study(path); });
  EXPECT_THAT(error, refused_at({.file = path,
                                 .line = 4,
                                 .key = "scenarios/1",
                                 .value = "moving_tarket",
                                 .limit = HasSubstr("moving_target")}));
  EXPECT_EQ(test::suggested_by(error), "moving_target");
}

TEST(StudyFile, AFileThatIsMissingOrListedTwiceIsRefusedWhereItIsNamed) {
  const ShortStudy files;
  const auto refused = [&](const std::string& gains, const std::string& scenario) {
    const std::string path = files.write("own.yaml", "gains: " + gains + "\nscenarios: [short.yaml, " +
                                                         scenario + "]\nobjective: [{metric: gaze/rms}]\n");
    return test::input_error([&] { load_study(path); });
  };
  EXPECT_THAT(
      refused("gains.yaml", "./none.yaml"),
      refused_at({.file = files / "own.yaml", .line = 2, .key = "scenarios/1", .value = "./none.yaml"}));
  EXPECT_THAT(
      refused("gains.yaml", "short.yaml"),
      refused_at({.file = files / "own.yaml", .line = 2, .key = "scenarios/1", .value = "short.yaml"}));
  EXPECT_THAT(refused("./none.yaml", "short_realistic.yaml"),
              refused_at({.file = files / "own.yaml", .line = 1, .key = "gains", .value = "./none.yaml"}));
}

TEST(StudyFile, ParametersThatDoNotFitAreRefused) {
  const auto parameter = [](const std::string& keys) {
    return refusal("parameters:\n  - {name: " + kRx + ", " + keys + "}\n");
  };
  EXPECT_THAT(parameter("lower: 60, upper: 10"),
              refused_at({.key = kRx, .value = "60", .limit = "below the upper bound 10"}));
  EXPECT_THAT(parameter("lower: 30, upper: 60"),
              refused_at({.key = kRx, .value = "25", .limit = "30 to 60"}));
  EXPECT_THAT(
      parameter("fixed: 1, link: adaptation_gain"),
      refused_at({.line = 5, .key = "parameters/0", .limit = "at most one of the keys: fixed, link"}));
  EXPECT_THAT(parameter("link: task_space_gains_p/ry"),
              refused_at({.line = 5, .key = "parameters/0/link", .value = "task_space_gains_p/ry"}));
  EXPECT_THAT(parameter("fixed: 30"), refused_at({.line = 0, .key = "parameters"}));
  EXPECT_THAT(
      parameter("scale: cubic"),
      refused_at({.line = 5, .key = "parameters/0/scale", .value = "cubic", .limit = "one of: log, linear"}));
}

TEST(StudyFile, ConstraintsAndTermsThatSayNothingAreRefused) {
  EXPECT_THAT(objective_refusal("objective: []\n"),
              refused_at({.line = 7, .key = "objective", .limit = "a weight above zero"}));
  EXPECT_THAT(objective_refusal("objective:\n  - {metric: gaze/rms, weight: 0}\n"),
              refused_at({.line = 7, .key = "objective", .limit = "a weight above zero"}));
  EXPECT_THAT(
      objective_refusal("objective:\n  - {metric: gaze/rms, weight: -1}\n"),
      refused_at({.line = 8, .key = "objective/0/weight", .value = "-1", .limit = StartsWith("0 to ")}));
  for (const std::string bounds : {"", ", at_most: 1, at_least: 0"}) {
    EXPECT_THAT(
        constraint_refusal("metric: joint_velocity/max_ratio" + bounds),
        refused_at({.line = 11, .key = "constraints/0", .limit = "one of the keys: at_most, at_least"}));
  }
}

TEST(StudyFile, EndsThatMakeNoSenseAreRefused) {
  const std::string key = "constraints/0/hopeless";
  EXPECT_THAT(constraint_refusal("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: 0.9"),
              refused_at({.line = 11, .key = key, .value = "0.9", .limit = "above 0.9, or never"}));
  EXPECT_THAT(constraint_refusal("metric: joint_position/min_margin, at_least: 0.2, hopeless: 0.3"),
              refused_at({.line = 11, .key = key, .value = "0.3", .limit = "below 0.2, or never"}));
  EXPECT_THAT(constraint_refusal("metric: error/position/rms, at_most: 1, hopeless: 2"),
              refused_at({.line = 11, .key = key, .value = "2", .limit = HasSubstr("error/position/max")}));
  EXPECT_THAT(
      constraint_refusal("metric: joint_velocity/max_ratio, at_least: 0.2, hopeless: 0.1"),
      refused_at({.line = 11, .key = key, .value = "0.1", .limit = HasSubstr("joint_position/min_margin")}));
  EXPECT_THAT(constraint_refusal("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: soon"),
              refused_at({.line = 11, .key = key, .value = "soon"}));
}

TEST(StudyFile, RefusesToMoveParametersOnceALinkStands) {
  const std::string linked =
      "parameters:\n"
      "  - {name: task_space_gains_p/rx}\n"
      "  - {name: task_space_gains_p/rz}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx}\n";
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/rx, lower: 1}\n"),
              refused_at({.line = 8, .key = "parameters/3/name", .value = kRx}));
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/ry, fixed: 3}\n"),
              refused_at({.line = 8, .key = "parameters/3/name", .value = "task_space_gains_p/ry"}));
}

TEST(StudyFile, RefusesGainsThatNoControllerTakes) {
  const InputError error = refusal(
      "parameters:\n  - {name: slerpDurationErrorGain}\n"
      "  - {name: task_space_gains_p/x, fixed: -80}\n");
  EXPECT_THAT(error, refused_at({.key = "task_space_gains_p", .value = "-80"}));
  EXPECT_THAT(error.what(), HasSubstr("task_space_gains_p/x"));
  EXPECT_THAT(refusal("parameters:\n  - {name: release_radius, start: 0.4, lower: 0.1, upper: 0.5}\n"),
              refused_at({.key = "release_radius", .value = "0.1", .limit = StartsWith("0 or at least ")}));
}

TEST(StudyFile, WeightsFloorsAndLimitsOutsideTheirRangeAreRefusedWhereTheyStand) {
  const auto objective = [](const std::string& weight, const std::string& floor) {
    return "objective:\n  - {metric: error/orientation/rms, weight: 1}\n  - {metric: error/position/max, "
           "weight: " +
           weight + ", floor: " + floor + "}\n";
  };
  for (const std::string number : {"1e308", "1e13", "1e-13", "2.3e-308"}) {
    EXPECT_THAT(objective_refusal(objective(number, "0")),
                refused_at({.line = 9, .key = "objective/1/weight", .value = number}));
    EXPECT_THAT(objective_refusal(objective("1", number)),
                refused_at({.line = 9, .key = "objective/1/floor", .value = number}));
    EXPECT_THAT(constraint_refusal("metric: joint_velocity/max_ratio, at_most: " + number),
                refused_at({.line = 11, .key = "constraints/0/at_most", .value = number}));
  }
  for (const std::string number : {"0", "1e12", "1e-12"}) {
    EXPECT_NO_THROW(load_study(ShortStudy(test::kShortParameters, objective(number, number)).path()))
        << number;
  }
}

TEST(StudyFile, ANameThatNoFileCouldBeCalledAfterIsRefused) {
  const ShortStudy files;
  for (const std::string& name : {std::string(201, 's'), std::string("a\x1b[31m"), std::string("caf\xE9")}) {
    const std::string path = files / (name + ".yaml");
    std::filesystem::copy_file(files.path(), path);
    const InputError error = test::input_error([&] { load_study(path); });
    EXPECT_THAT(error, refused_at({.file = path, .line = 0, .value = name.size() > 200 ? "201" : ""}));
    EXPECT_THAT(error.what(), HasSubstr("rename"));
  }
}

}  // namespace study_refusals_test
}  // namespace armtune::internal
