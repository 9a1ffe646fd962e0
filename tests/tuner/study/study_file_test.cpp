#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include <filesystem>

#include "core/control/laws/controller_kind.hpp"
#include "sim/scenario/data_files.hpp"
#include "tests/core/support/source_dir.hpp"
#include "tests/tuner/support/short_study.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace study_file_test {

using test::ShortStudy;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

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
      const bool searched = field.search != SearchRange::kNone && field.search != SearchRange::kBounded &&
                            !own(study.space.start, field.name).isZero(0.0);
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

TEST(StudyFile, GainsOfTheToolsMotionAreNotTunedWhereJointMotionsAreFollowedAlone) {
  for (const ControllerKind* kind : controller_kinds()) {
    const std::string path = test::source_dir() + "/examples/joint_trajectory/study.yaml";
    if (kind->name == "cartesian_impedance") {  // it has no others
      EXPECT_THAT([&] { return load_study(path, kind->name); },
                  test::refused_at({.file = path, .line = 0, .key = "parameters"}));
      continue;
    }
    const Study study = load_study(path, kind->name);
    EXPECT_FALSE(study.space.free.empty()) << kind->name;
    for (const Parameter& p : study.space.free) {
      EXPECT_THAT(p.entry.name, AllOf(Not(HasSubstr("DurationErrorGain")), Not(testing::EndsWith("/rx")),
                                      Not(testing::EndsWith("/x"))))
          << kind->name;
    }
  }
}

TEST(StudyFile, NamesItsController) {
  const std::string named = "controller: impedance\nparameters: [{name: impedance_k/x, upper: 1e5}]\n";
  const Study study = parameters_study(named);
  ASSERT_EQ(study.space.free.size(), 1U);
  EXPECT_EQ(study.space.free[0].entry.name, "impedance_k/x");
  EXPECT_GT(study.space.free[0].start, 0.0);
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

TEST(StudyFile, EveryBundledAndCommittedStudyLoads) {
  const std::string results = test::source_dir() + "/results";
  std::vector<std::string> studies = bundled_names("studies");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(results)) {
    if (entry.path().filename().string().ends_with("study.yaml")) studies.push_back(entry.path().string());
  }
  EXPECT_GE(studies.size(), 12U);
  for (const std::string& name : studies) EXPECT_NO_THROW(load_study(name)) << name;
}

TEST(StudyFile, TheStartIncludesLinkedGains) {
  const Study study = parameters_study(
      "parameters:\n"
      "  - {name: task_space_gains_p/rx}\n"
      "  - {name: task_space_gains_p/ry, link: task_space_gains_p/rx, factor: 0.1}\n");
  EXPECT_DOUBLE_EQ(study.space.start.task_space_gains_p[4], 0.1 * study.space.start.task_space_gains_p[3]);
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
}  // namespace study_file_test
}  // namespace armtune::internal
