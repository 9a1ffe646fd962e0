#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <filesystem>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace {

using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Message with which a study of these parts is refused.
std::string refusal(const std::string& parameters, const std::string& objective = test::kShortObjective,
                    const std::string& constraints = test::kShortConstraints,
                    const std::string& search = test::kShortSearch) {
  const ShortStudy files(parameters, objective, constraints, search);
  std::string message = test::refusal([&] { load_study(files.path()); });
  EXPECT_THAT(message, testing::StartsWith(files.path()));
  return message;
}

Study parameters_study(const std::string& parameters) {
  return load_study(ShortStudy(parameters).path());
}

TEST(StudyFile, TheBundledStudyTunesTwentyGainsOnSeveralRealisticArmsWithMargins) {
  const Study study = load_study("ur10_gaze");
  EXPECT_EQ(study.space.free.size(), 20U);
  std::vector<std::string> scenarios;
  for (const Scenario& s : study.scenarios) scenarios.push_back(s.name);
  EXPECT_THAT(scenarios, testing::ElementsAre("realistic_moving_target", "realistic_target_switch",
                                              "realistic_obstacle_pass"));
  for (const Parameter& p : study.space.free) {
    EXPECT_LT(p.lower, p.start) << p.entry.name;
    EXPECT_GT(p.upper, p.start) << p.entry.name;
  }
  ASSERT_FALSE(study.constraints.empty());
  EXPECT_EQ(study.constraints[0].metric, Metric::kJointVelocityMaxRatio);
  EXPECT_EQ(study.constraints[0].limit, 0.9);
  EXPECT_GT(study.space.start.adaptation_filter, 0.0);
  EXPECT_GT(study.space.start.adaptation_leakage, 0.0);
  EXPECT_GT(study.space.start.roll_centering_gain, 0.0);
  EXPECT_TRUE(study.sweep.empty()) << "a sweep would spend a short budget before anything is searched";
}

TEST(StudyFile, EveryBundledStudyTunesOnSeveralArmsWithMarginsAndSearchesInTheNativeEngine) {
  for (const std::string& name : bundled_names("studies")) {
    const Study study = load_study(name);
    ASSERT_TRUE(study.robust) << name;
    EXPECT_GE(study.robust->samples, 6U) << name;
    EXPECT_EQ(study.robust->measure, RiskMeasure::kWorst) << name;
    EXPECT_EQ(study.margins.size(), kMarginCount) << name;
    EXPECT_EQ(study.engine, Engine::kNative) << name;
    double payload = 0.0;
    for (const Scenario& s : study.scenarios) {
      EXPECT_GT(s.plant.velocity_noise, 0.0) << name << ": a realistic arm";
      payload = std::max(payload, s.plant.payload.mass);
    }
    EXPECT_DOUBLE_EQ(study.robust->perturbation.payload, 3.0 * payload) << name;
    EXPECT_EQ(rollouts_per_evaluation(study), study.scenarios.size() * (arms(*study.robust) + kMarginCount));
  }
}

TEST(StudyFile, OfAnotherControllerTunesThatOnesGainsFromTheirStart) {
  const ShortStudy files;
  const Study as_it_is = load_study(files.path());
  for (const ControllerKind* kind : controller_kinds()) {
    const Study study = load_study(files.path(), kind->name);
    EXPECT_EQ(study.space.start.controller, kind->name);
    if (kind->name == "adaptive") {
      EXPECT_EQ(study_yaml(study, "gains.yaml"), study_yaml(as_it_is, "gains.yaml"));
      continue;
    }
    std::vector<std::string> tuned;
    for (const Parameter& p : study.space.free) tuned.emplace_back(p.entry.field->name);
    for (const GainField& field : kind->own) {
      // Factors on a start of zero are none.
      const bool searched =
          field.search != SearchRange::kNone && !own(study.space.start, field.name).isZero(0.0);
      EXPECT_EQ(std::count(tuned.begin(), tuned.end(), field.name) > 0, searched) << kind->name << field.name;
    }
    EXPECT_THAT(tuned, testing::Not(testing::Contains("task_space_gains_d")));
    // Its resolved form names it by the gains it is kept beside.
    files.write("start.yaml", gains_yaml(study.space.start, {}));
    const std::string text = study_yaml(study, "start.yaml");
    const Study again = load_study(files.write("resolved.yaml", text));
    EXPECT_EQ(again.space.start.controller, kind->name);
    EXPECT_EQ(study_yaml(again, "start.yaml"), text);
  }
}

TEST(StudyFile, NamesItsController) {
  const std::string named = "controller: impedance\nparameters: [{name: impedance_k/x}]\n";
  const Study study = parameters_study(named);
  ASSERT_EQ(study.space.free.size(), 1U);
  EXPECT_EQ(study.space.free[0].entry.name, "impedance_k/x");
  EXPECT_GT(study.space.free[0].start, 0.0);
  EXPECT_THAT(refusal("controller: impedance\n" + test::kShortParameters),
              AllOf(HasSubstr("task_space_gains_p/rx"), HasSubstr("is not a gain")));
  EXPECT_THAT(refusal("controller: pid\n"),
              AllOf(HasSubstr(":4"), HasSubstr("'pid'"), HasSubstr("joint_pd")));
}

TEST(StudyFile, ReadsBackFromItsResolvedForm) {
  const ShortStudy files(
      "parameters:\n"
      "  - {name: adaptation_gain, fixed: 0.125}\n"
      "  - {name: task_space_gains_p}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx, factor: 0.7}\n"
      "  - {name: slerpDurationErrorGain, start: 2.2, lower: 1, upper: 4, scale: linear}\n",
      "objective:\n"
      "  - {metric: error/orientation/rms, weight: 2, floor: 1e-3}\n"
      "  - {metric: error/position/max, scenarios: [short]}\n",
      "constraints:\n"
      "  - {metric: joint_velocity/max_ratio, at_most: 0.87}\n"
      "  - {metric: joint_position/min_margin, at_least: start, scenarios: [short_realistic]}\n"
      "sweep:\n  - {parameters: [task_space_gains_p/rx], factors: [0.5, 2]}\n",
      "search: {algorithm: ISRES, max_evaluations: 77, max_minutes: 3, initial_step: 0.2, x_tolerance: "
      "0.002,\n"
      "         objective_tolerance: 0.003, seed: 9, stepper: rk4, engine: native, verify_share: 0.25}\n");
  const Study study = load_study(files.path());
  EXPECT_EQ(study.space.start.adaptation_gain, 0.125);
  EXPECT_EQ(study.space.start.slerpDurationErrorGain, 2.2);
  EXPECT_EQ(study.space.free.size(), 6U) << "five of Kp, one time gain";
  ASSERT_EQ(study.space.links.size(), 1U);

  files.write("start.yaml", gains_yaml(study.space.start, {}));
  const std::string text = study_yaml(study, "start.yaml");
  const Study again = load_study(files.write("resolved.yaml", text));
  EXPECT_EQ(study_yaml(again, "start.yaml"), text);
  EXPECT_EQ(again.space.start_point(), study.space.start_point());
  ASSERT_EQ(again.space.free.size(), study.space.free.size());
  for (std::size_t i = 0; i < study.space.free.size(); ++i) {
    EXPECT_EQ(again.space.free[i].entry.name, study.space.free[i].entry.name);
    EXPECT_EQ(again.space.free[i].lower, study.space.free[i].lower);
    EXPECT_EQ(again.space.free[i].upper, study.space.free[i].upper);
    EXPECT_EQ(again.space.free[i].scale, study.space.free[i].scale);
  }
  // Any point gives the same gains, links and fixed values included.
  const std::vector<double> x(study.space.free.size(), 0.3);
  EXPECT_EQ(gains_yaml(again.space.gains_at(x), {}), gains_yaml(study.space.gains_at(x), {}));
  EXPECT_EQ(again.constraints.size(), 2U);
  EXPECT_FALSE(again.constraints[1].limit.has_value());
  EXPECT_FALSE(again.constraints[1].upper);
  EXPECT_EQ(again.solver.algorithm, "ISRES");
  EXPECT_EQ(again.max_evaluations, 77);
  EXPECT_EQ(again.stepper, Stepper::kRungeKutta4);
  EXPECT_EQ(again.engine, Engine::kNative);
  EXPECT_EQ(again.verify_share, 0.25);
}

// Run folders of earlier versions have the key, and it changed no result.
TEST(StudyFile, AStudyThatNamesTheEarlyEndThatWasCutIsTheSameStudy) {
  const ShortStudy files;
  const std::string without = study_yaml(load_study(files.path()), "gains.yaml");
  EXPECT_THAT(without, Not(HasSubstr("end_outdone")));
  std::string text = test::read_text(files.path());
  const std::string place = "seed: 1}";
  text.replace(text.rfind(place), place.size(), "seed: 1, end_outdone: false}");
  EXPECT_EQ(study_yaml(load_study(files.write("study.yaml", text)), "gains.yaml"), without);
}

TEST(StudyFile, TheBundledStudyReadsBackFromItsResolvedForm) {
  const Study study = load_study("ur10_gaze");
  const test::TemporaryFolder folder;
  folder.write("start.yaml", gains_yaml(study.space.start, {}));
  const std::string text = study_yaml(study, "start.yaml");
  const Study again = load_study(folder.write("study.yaml", text));
  EXPECT_EQ(study_yaml(again, "start.yaml"), text);
  EXPECT_EQ(again.space.start_point(), study.space.start_point());
}

TEST(StudyFile, AFieldNameStandsForAllItsNumbers) {
  EXPECT_EQ(parameters_study("parameters:\n  - {name: task_space_gains_d}\n").space.free.size(), 6U);
}

TEST(StudyFile, SelectsForceGainsInEitherForm) {
  const ShortStudy files("parameters:\n  - {name: force_control_gains}\n");
  EXPECT_EQ(load_study(files.path()).space.free.size(), 6U);
  Gains lists = load_study(files.path()).space.start;
  lists.force_control_gains = ForceGains::LinSpaced(36, 1.0, 36.0);
  files.write("lists.yaml", gains_yaml(lists, {}));
  const auto selected = [&](const std::string& name) {
    std::string text = test::read_text(files.path());
    const auto at = text.find("gains: ");
    text.replace(at, text.find('\n', at) - at, "gains: lists.yaml");
    text.replace(text.find("{name: force_control_gains}"), 27, "{name: " + name + "}");
    return load_study(files.write("selected.yaml", text)).space;
  };
  EXPECT_EQ(selected("force_control_gains").free.size(), 36U);
  EXPECT_EQ(selected("force_control_gains/elbow_joint").free.size(), 6U);
  const ParameterSpace one = selected("force_control_gains/elbow_joint/shoulder_lift_joint");
  ASSERT_EQ(one.free.size(), 1U);
  const Gains high = one.gains_at({1.0});
  for (Eigen::Index i = 0; i < 36; ++i) {
    EXPECT_EQ(high.force_control_gains[i] != lists.force_control_gains[i], i == 2 * 6 + 1) << i;
  }
}

TEST(StudyFile, UnknownNamesAreRefusedWithTheNearest) {
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gain_p/rx}\n"),
              AllOf(HasSubstr("is not a gain"), HasSubstr("did you mean 'task_space_gains_p/rx'")));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: error/orientaton/rms}\n"),
              AllOf(HasSubstr("is not a metric"), HasSubstr("did you mean 'error/orientation/rms'")));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocty/max_ratio, at_most: 1}\n"),
              HasSubstr("did you mean 'joint_velocity/max_ratio'"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, scenarios: [shirt]}\n"),
              HasSubstr("'shirt' is not one of the study's scenarios"));
}

TEST(StudyFile, AnAlgorithmOrStepperThatIsNotOfferedIsRefused) {
  const auto search = [](const std::string& text) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "", "search: {" + text + "}\n");
    return test::refusal([&] { load_study(files.path()); });
  };
  EXPECT_THAT(search("algorithm: COBYLLA"), AllOf(HasSubstr("COBYLLA"), HasSubstr("did you mean 'COBYLA'")));
  EXPECT_THAT(search("stepper: euler"), AllOf(HasSubstr("euler"), HasSubstr("midpoint")));
  EXPECT_THAT(search("engine: mujoco"), AllOf(HasSubstr("mujoco"), HasSubstr("native")));
  EXPECT_THAT(search("verify_share: 0.2"), HasSubstr("engine: native"));
  EXPECT_THAT(search("engine: native, verify_share: 1.5"), HasSubstr("1.5"));
  EXPECT_THAT(search("engine: native, stepper: reference"), HasSubstr("'reference'"));
  EXPECT_THAT(search("max_evaluations: 0"), HasSubstr("max_evaluations"));
  EXPECT_THAT(search("seed: -1"), HasSubstr("negative"));
  EXPECT_THAT(search("budget: 10"), HasSubstr("unknown key 'budget'"));
}

TEST(StudyFile, SearchKeysThatDoNotFitAreRefusedWithTheirLine) {
  const auto search = [](const std::string& text) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, "", "search:\n  " + text + "\n");
    std::string message = test::refusal([&] { load_study(files.path()); });
    // Line 10 is `search:`, after description, gains, scenarios, three lines of parameters and of objective.
    EXPECT_THAT(message, testing::StartsWith(files.path() + ":11: key 'search/"));
    return message;
  };
  EXPECT_THAT(search("global: CRS3"), AllOf(HasSubstr("global"), HasSubstr("did you mean 'CRS2'")));
  EXPECT_THAT(search("algorithm: SLQSP"), HasSubstr("did you mean 'SLSQP'"));
  EXPECT_THAT(search("global_share: 1.5"), AllOf(HasSubstr("1.5"), HasSubstr("1")));
  EXPECT_THAT(search("global_share: -0.5"), HasSubstr("-0.5"));
  EXPECT_THAT(search("global_share: 0.5\n  algorithm: COBYLA"), HasSubstr("name one with 'global'"));
  EXPECT_THAT(search("starts: 0"), AllOf(HasSubstr("0 searches"), HasSubstr("1 .. 256")));
  EXPECT_THAT(search("starts: 1000"), HasSubstr("1 .. 256"));
  EXPECT_THAT(search("differences: backward"), HasSubstr("forward, central"));
  EXPECT_THAT(search("difference_step: 0"), HasSubstr("difference_step"));
}

TEST(StudyFile, AnUnknownScenarioIsRefused) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write(
      "study.yaml", "gains: published\nscenarios: [moving_tarket]\nobjective:\n  - {metric: gaze/rms}\n");
  EXPECT_THAT(test::refusal([&] { load_study(path); }),
              AllOf(HasSubstr("moving_tarket"), HasSubstr("did you mean 'moving_target'")));
}

TEST(StudyFile, ParametersThatDoNotFitAreRefused) {
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, lower: 60, upper: 10}\n"),
              AllOf(HasSubstr("task_space_gains_p/rx"), HasSubstr("not below")));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, lower: 30, upper: 60}\n"),
              HasSubstr("start 25 lies outside its bounds 30 .. 60"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, fixed: 1, link: adaptation_gain}\n"),
              HasSubstr("at most one of"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, link: task_space_gains_p/ry}\n"),
              HasSubstr("'task_space_gains_p/ry' is not a tuned parameter"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, fixed: 30}\n"),
              HasSubstr("no parameter"));
  EXPECT_THAT(refusal("parameters:\n  - {name: task_space_gains_p/rx, scale: cubic}\n"), HasSubstr("cubic"));
}

TEST(StudyFile, ConstraintsAndTermsThatSayNothingAreRefused) {
  EXPECT_THAT(refusal(test::kShortParameters, "objective: []\n"), HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, weight: 0}\n"),
              HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, "objective:\n  - {metric: gaze/rms, weight: -1}\n"),
              HasSubstr("weight"));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocity/max_ratio}\n"),
              HasSubstr("at_most"));
  EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                      "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: 1, at_least: 0}\n"),
              HasSubstr("at_most"));
}

/// short, and short with an obstacle and a switch of targets added.
class StudyOfTwoKindsOfScenario : public testing::Test {
 protected:
  StudyOfTwoKindsOfScenario() {
    files_.write("short.yaml", "base: moving_target\nduration: 8\n");
    files_.write("with_obstacle.yaml", "base: obstacle_pass\nduration: 8\n");
  }
  std::string write(const std::string& scenarios, const std::string& rest) const {
    return files_.write("study.yaml", "gains: published\nscenarios: [" + scenarios +
                                          "]\nparameters: [{name: task_space_gains_p/rx}]\n" + rest);
  }
  Study study(const std::string& rest) const {
    return load_study(write("short.yaml, with_obstacle.yaml", rest));
  }
  std::string refusal(const std::string& scenarios, const std::string& rest) const {
    const std::string path = write(scenarios, rest);
    std::string message = test::refusal([&] { load_study(path); });
    EXPECT_THAT(message, testing::StartsWith(path + ":5: key '"));
    return message;
  }

  const test::TemporaryFolder files_;
};

TEST_F(StudyOfTwoKindsOfScenario, ATermWithoutScenariosCountsWhereItsMetricApplies) {
  const Study both = study("objective:\n  - {metric: obstacle/min_clearance}\n  - {metric: gaze/rms}\n");
  EXPECT_THAT(both.terms[0].scenarios, testing::ElementsAre(1U));
  EXPECT_THAT(both.terms[1].scenarios, testing::ElementsAre(0U, 1U));
  // The resolved form says so.
  EXPECT_THAT(study_yaml(both, "published"),
              HasSubstr("{metric: obstacle/min_clearance, weight: 1, floor: 0, scenarios: [with_obstacle]}"));
}

TEST_F(StudyOfTwoKindsOfScenario, ATermThatAppliesNowhereIsRefusedWithTheScenario) {
  for (const std::string floor : {"", ", floor: 0.1"}) {
    EXPECT_THAT(refusal("short.yaml", "objective:\n  - {metric: obstacle/min_clearance" + floor + "}\n"),
                AllOf(HasSubstr("objective/0/metric"),
                      HasSubstr("obstacle/min_clearance does not apply to short"), HasSubstr("'scenarios'")));
  }
}

TEST_F(StudyOfTwoKindsOfScenario, AListedScenarioThatATermDoesNotApplyToIsRefused) {
  EXPECT_THAT(
      refusal("short.yaml, with_obstacle.yaml",
              "objective:\n  - {metric: obstacle/min_clearance, scenarios: [with_obstacle, short]}\n"),
      AllOf(HasSubstr("objective/0/scenarios"), HasSubstr("does not apply to short;")));
}

TEST_F(StudyOfTwoKindsOfScenario, AConstraintMustApplySomewhere) {
  const std::string objective = "objective: [{metric: gaze/rms}]\nconstraints: ";
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1}]\n"));
  EXPECT_NO_THROW(study(objective + "[{metric: obstacle/min_clearance, at_least: 0.1, "
                                    "scenarios: [short, with_obstacle]}]\n"));
  const std::string both = "short.yaml, with_obstacle.yaml";
  EXPECT_THAT(refusal(both, objective + "[{metric: response/bandwidth, at_least: 5}]\n"),
              AllOf(HasSubstr("constraints/0/metric"),
                    HasSubstr("response/bandwidth does not apply to short, with_obstacle")));
  EXPECT_THAT(
      refusal(both, objective + "[{metric: obstacle/min_clearance, at_least: 0.1, scenarios: [short]}]\n"),
      AllOf(HasSubstr("constraints/0/scenarios"), HasSubstr("does not apply to short")));
}

TEST_F(StudyOfTwoKindsOfScenario, AMetricWithoutADirectionIsNoTermButMayBeBounded) {
  EXPECT_THAT(refusal("short.yaml", "objective:\n  - {metric: joint_velocity/max_ratio_time}\n"),
              AllOf(HasSubstr("joint_velocity/max_ratio_time cannot be an objective")));
  EXPECT_NO_THROW(
      study("objective: [{metric: gaze/rms}, {metric: samples}]\n"
            "constraints: [{metric: joint_velocity/max_ratio_time, at_least: 1}]\n"));
}

TEST(StudyFile, EveryBundledAndCommittedStudyLoads) {
  const std::string results = ARMTUNE_SOURCE_DIR "/results";
  std::vector<std::string> studies = bundled_names("studies");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(results)) {
    if (entry.path().filename().string().ends_with("study.yaml")) studies.push_back(entry.path().string());
  }
  EXPECT_GE(studies.size(), 12U);
  for (const std::string& name : studies) EXPECT_NO_THROW(load_study(name)) << name;
}

const std::string kEnds =
    "constraints:\n"
    "  - {metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: 1.5}\n"
    "  - {metric: joint_velocity/max_ratio, at_most: start, hopeless: auto}\n"
    "  - {metric: joint_effort/max_ratio, at_most: 1, hopeless: never}\n"
    "  - {metric: joint_position/min_margin, at_least: 0}\n"
    "  - {metric: error/position/rms, at_most: 1}\n";

TEST(StudyFile, ReadsAndWritesFromWhereOnAConstraintIsHopeless) {
  const ShortStudy files(test::kShortParameters, test::kShortObjective, kEnds);
  const Study study = load_study(files.path());
  const auto expect_same_ends = [](const Study& s) {
    EXPECT_EQ(s.constraints[0].hopeless.kind, Hopeless::Kind::kFrom);
    EXPECT_EQ(s.constraints[0].hopeless.value, 1.5);
    EXPECT_EQ(s.constraints[1].hopeless.kind, Hopeless::Kind::kAuto);
    EXPECT_EQ(s.constraints[2].hopeless.kind, Hopeless::Kind::kNever);
    EXPECT_EQ(s.constraints[3].hopeless.kind, Hopeless::Kind::kAuto);
    EXPECT_EQ(s.constraints[4].hopeless.kind, Hopeless::Kind::kAuto);
  };
  expect_same_ends(study);
  const std::string text = study_yaml(study, "gains.yaml");
  EXPECT_THAT(text, AllOf(HasSubstr("hopeless from -0.1 on"), HasSubstr("twice the start")));
  const Study again = load_study(files.write("again.yaml", text));
  expect_same_ends(again);
  EXPECT_EQ(study_yaml(again, "gains.yaml"), text);
}

TEST(StudyFile, EndsThatMakeNoSenseAreRefused) {
  const auto constraint = [](const std::string& text) {
    return refusal(test::kShortParameters, test::kShortObjective, "constraints:\n  - {" + text + "}\n");
  };
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: 0.9"),
              AllOf(HasSubstr("hopeless"), HasSubstr("at_most 0.9"), HasSubstr("above")));
  EXPECT_THAT(constraint("metric: joint_position/min_margin, at_least: 0.2, hopeless: 0.3"),
              AllOf(HasSubstr("at_least 0.2"), HasSubstr("below")));
  EXPECT_THAT(constraint("metric: error/position/rms, at_most: 1, hopeless: 2"),
              AllOf(HasSubstr("can recover"), HasSubstr("error/position/max")));
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_least: 0.2, hopeless: 0.1"),
              AllOf(HasSubstr("can recover"), HasSubstr("joint_position/min_margin")));
  EXPECT_THAT(constraint("metric: joint_velocity/max_ratio, at_most: 0.9, hopeless: soon"),
              HasSubstr("soon"));
}

TEST(StudyFile, OnManyArmsOnlyTheWorstMakesACandidateHopeless) {
  const auto with_measure = [](const std::string& measure, const std::string& constraints) {
    const ShortStudy files(test::kShortParameters, test::kShortObjective, constraints,
                           "robust: {samples: 2, measure: " + measure + "}\n");
    return load_study(files.path());
  };
  EXPECT_EQ(with_measure("worst", kEnds).constraints[0].hopeless.kind, Hopeless::Kind::kFrom);
  for (const char* measure : {"mean", "quantile", "cvar"}) {
    for (const Constraint& c : with_measure(measure, test::kShortConstraints).constraints) {
      EXPECT_EQ(c.hopeless.kind, Hopeless::Kind::kNever) << measure;
    }
    EXPECT_THAT(test::refusal([&] { with_measure(measure, kEnds); }),
                AllOf(HasSubstr("study.yaml:"), HasSubstr("hopeless"), HasSubstr("worst")));
  }
}

TEST(StudyFile, RefusesToMoveParametersOnceALinkStands) {
  const std::string linked =
      "parameters:\n"
      "  - {name: task_space_gains_p/rx}\n"
      "  - {name: task_space_gains_p/rz}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx}\n";
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/rx, lower: 1}\n"),
              HasSubstr("task_space_gains_p/rx"));
  EXPECT_THAT(refusal(linked + "  - {name: task_space_gains_p/ry, fixed: 3}\n"),
              HasSubstr("task_space_gains_p/ry"));
}

TEST(StudyFile, TheStartIncludesLinkedGains) {
  const Study study = parameters_study(
      "parameters:\n"
      "  - {name: task_space_gains_p/rx}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx, factor: 0.1}\n");
  EXPECT_DOUBLE_EQ(study.space.start.task_space_gains_p[4], 0.1 * study.space.start.task_space_gains_p[3]);
}

TEST(StudyFile, RefusesGainsThatNoControllerTakes) {
  EXPECT_THAT(refusal("parameters:\n  - {name: slerpDurationErrorGain}\n"
                      "  - {name: task_space_gains_p/x, fixed: -80}\n"),
              AllOf(HasSubstr("task_space_gains_p/x"), HasSubstr("-80")));
  EXPECT_THAT(refusal("parameters:\n  - {name: release_radius, start: 0.4, lower: 0.1, upper: 0.5}\n"),
              HasSubstr("release_radius"));
}

TEST(StudyFile, WeightsFloorsAndLimitsOutsideTheirRangeAreRefusedWhereTheyStand) {
  const auto objective = [](const std::string& weight, const std::string& floor) {
    return "objective:\n  - {metric: error/orientation/rms, weight: 1}\n  - {metric: error/position/max, "
           "weight: " +
           weight + ", floor: " + floor + "}\n";
  };
  for (const std::string number : {"1e308", "1e13", "1e-13", "2.3e-308"}) {
    EXPECT_THAT(refusal(test::kShortParameters, objective(number, "0")), HasSubstr("objective/1/weight"));
    EXPECT_THAT(refusal(test::kShortParameters, objective("1", number)), HasSubstr("objective/1/floor"));
    EXPECT_THAT(refusal(test::kShortParameters, test::kShortObjective,
                        "constraints:\n  - {metric: joint_velocity/max_ratio, at_most: " + number + "}\n"),
                HasSubstr("constraints/0/at_most"));
  }
  for (const std::string number : {"0", "1e12", "1e-12"}) {
    EXPECT_NO_THROW(load_study(ShortStudy(test::kShortParameters, objective(number, number)).path()))
        << number;
  }
}

TEST(StudyFile, WhatARunWritesNamesTheScenariosThatWereReadThroughLinksToo) {
  const ShortStudy files;
  std::filesystem::create_directories(files / "real/below");
  std::filesystem::create_directory_symlink(files / "real/below", files / "sub");
  files.write("real/twin.yaml", "base: moving_target\nduration: 5\n");
  files.write("twin.yaml", "base: moving_target\nduration: 7\n");
  Study study = load_study(files.path());
  study.scenarios = {load_scenario(files / "sub/../twin.yaml")};
  ASSERT_EQ(study.scenarios.front().duration, 5.0);
  study.terms.front().scenarios = {0};
  study.terms.resize(1);
  study.constraints.clear();
  const Study again = load_study(files.write("written.yaml", study_yaml(study, "gains.yaml", "")));
  EXPECT_EQ(again.scenarios.front().duration, 5.0);
}

TEST(StudyFile, ANameThatNoFileCouldBeCalledAfterIsRefused) {
  const ShortStudy files;
  for (const std::string& name : {std::string(201, 's'), std::string("a\x1b[31m"), std::string("caf\xE9")}) {
    const std::string path = files / (name + ".yaml");
    std::filesystem::copy_file(files.path(), path);
    EXPECT_THAT(test::refusal([&] { load_study(path); }), HasSubstr("rename"));
  }
}

}  // namespace
}  // namespace armtune::internal
