#include "sim/scenario/gains_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/control/laws/controller_kind.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tests/sim/support/ros_parameters.hpp"

namespace armtune::internal {
namespace gains_file_test {

using test::kRosParameters;
using test::refused_at;
using testing::HasSubstr;

const std::vector<std::string> kJoints = {"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint",
                                          "wrist_1_joint",      "wrist_2_joint",       "wrist_3_joint"};

class GainsFile : public testing::Test {
 protected:
  Gains load(const std::string& text) const { return load_gains(folder_.write("gains.yaml", text), kJoints); }
  /// The error with which the published parameters are refused after a replacement in their text.
  InputError refused(const std::string& from, const std::string& to) const {
    std::string text = kRosParameters;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
    const InputError error = test::input_error([&] { load(text); });
    EXPECT_EQ(error.place().file, folder_ / "gains.yaml");
    return error;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(GainsFile, ThePublishedRosParametersLoadAsTheyAre) {
  EXPECT_EQ(gains_yaml(load(kRosParameters), {}), gains_yaml(load_gains("published", kJoints), {}));
}

TEST_F(GainsFile, TheNamespaceMayHaveAnyNameOrNone) {
  const std::string expected = gains_yaml(load(kRosParameters), {});
  std::string text = kRosParameters;
  text.replace(text.find("simple_effort_ctrl"), 18, "my_controller");
  EXPECT_EQ(gains_yaml(load(text), {}), expected);
  std::string bare = text.substr(text.find('\n', text.find("my_controller")));
  for (std::size_t at = 0; (at = bare.find("\n  ", at)) != std::string::npos; ++at) bare.erase(at + 1, 2);
  EXPECT_EQ(gains_yaml(load(bare), {}), expected);
}

TEST_F(GainsFile, WhatRos2DumpsOfANodeLoads) {
  std::string text = kRosParameters;
  text.replace(text.find("simple_effort_ctrl: "), 20, "/arm/ctrl:\n  ros__parameters:");
  for (std::size_t at = text.find("joint_space_gains_p"); (at = text.find("\n  ", at)) != std::string::npos;
       ++at)
    text.insert(at + 1, "  ");
  text.replace(text.find("  joint_space_gains_p"), 2, "    ");
  text +=
      "\n    use_sim_time: false\n    qos_overrides:\n      /parameter_events:\n        publisher:\n         "
      " depth: 1000\n";
  EXPECT_EQ(gains_yaml(load(text), {}), gains_yaml(load(kRosParameters), {}));
}

TEST_F(GainsFile, ParametersOfSeveralNodesAreRefusedAsThat) {
  const std::string nodes =
      "manager:\n  ros__parameters: {update_rate: 100}\nctrl:\n  ros__parameters: "
      "{slerpDurationErrorGain: 2}\n";
  EXPECT_THAT([&] { load(nodes); },
              refused_at({.file = folder_ / "gains.yaml", .line = 1, .key = "", .limit = "one node"}));
}

TEST_F(GainsFile, AllNumbersReadBackToTheBit) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> exponent(-12.0, 12.0);
  for (int i = 0; i < 20; ++i) {
    Gains gains = load_gains("published", kJoints);
    for (const GainField& field : gain_fields()) {
      for (double& x : numbers(gains, field)) {
        x = std::pow(10.0, exponent(generator));
        if (x >= field.below) x = field.below / (1.0 + x);
      }
    }
    gains.release_radius = gains.obstacleInfluenceRadius * 1.1;
    gains.slerp_start_angle = gains.slerpAngularErrorThreshold * 0.7;
    gains.slerp_reference = i % 2 == 0 ? SlerpReference::kCurrent : SlerpReference::kStart;
    gains.adapt_while_avoiding = i % 3 == 0;
    gains.gaze_feedforward = i % 4 == 0;
    const Gains back = load(gains_yaml(gains, {"a comment", "and another"}));
    for (const GainField& field : gain_fields()) {
      const auto written = numbers(gains, field);
      const auto read = numbers(back, field);
      EXPECT_TRUE(std::equal(written.begin(), written.end(), read.begin(), read.end())) << field.name;
    }
    EXPECT_EQ(back.slerp_reference, gains.slerp_reference);
    EXPECT_EQ(back.adapt_while_avoiding, gains.adapt_while_avoiding);
    EXPECT_EQ(back.gaze_feedforward, gains.gaze_feedforward);
  }
}

TEST_F(GainsFile, GainsOfEveryControllerReadBackToTheBit) {
  for (const ControllerKind* kind : controller_kinds()) {
    Gains gains = load_gains("published", kJoints);
    const auto arm = test::scenario_of("moving_target").robot;
    const RobotModel& robot = *arm;
    gains = convert_gains(*kind, gains, robot, in_si(robot, gains.joint_space_goal));
    double next = 0.7;
    for (JointVector& own : gains.own) {
      for (double& value : own) value = 1.0 / (next += 1.0 / 3.0);  // below 1, as a filter has to be
    }
    const std::string text = gains_yaml(gains, {});
    const Gains back = load(text);
    EXPECT_EQ(back.controller, kind->name);
    EXPECT_EQ(back.own, gains.own);
    EXPECT_EQ(gains_yaml(back, {}), text);
    EXPECT_EQ(text.find("controller:") == std::string::npos, kind->name == "adaptive")
        << "the published file names none";
  }
}

TEST_F(GainsFile, AnOwnGainThatTheFileLeavesOutIsWhatItsDeclarationSays) {
  std::string text = gains_yaml(load_gains("published", kJoints), {});
  text.replace(text.find("simple_effort_ctrl:\n"), 20, "simple_effort_ctrl:\n  controller: joint_pd\n");
  // What the kind does not have stands in the way, by name and line.
  EXPECT_THAT([&] { load(text); }, refused_at({.file = folder_ / "gains.yaml",
                                               .line = testing::Gt(0),
                                               .key = testing::HasSubstr("task_space_gains_d"),
                                               .value = "task_space_gains_d"}));
  for (const char* key :
       {"task_space_gains_d", "adaptation_gain", "adapt_while_avoiding", "adaptation_leakage",
        "adaptation_inertia_leakage", "adaptation_filter", "adaptation_projection"}) {
    const auto at = text.find(std::string("  ") + key);
    ASSERT_NE(at, std::string::npos) << key;
    text.erase(at, text.find('\n', at) + 1 - at);
  }
  EXPECT_EQ(own(load(text), "joint_pd_p"), JointVector::Constant(6, 100.0));
}

TEST_F(GainsFile, AControllerThatThereIsNotIsNamedWithThoseThereAre) {
  EXPECT_THAT(refused("simple_effort_ctrl:", "simple_effort_ctrl:\n  controller: impedence"),
              refused_at({.line = 3,
                          .key = "simple_effort_ctrl/controller",
                          .value = "impedence",
                          .limit = testing::StartsWith("one of: adaptive, joint_pd, ")}));
  EXPECT_THAT(refused("simple_effort_ctrl:", "simple_effort_ctrl:\n  controller: impedence").what(),
              HasSubstr("did you mean"));
}

TEST_F(GainsFile, JointGainsMayStandByJointName) {
  std::string text = kRosParameters;
  const std::string list = "task_space_gains_d: [280, 200, 200, 25, 15, 5]";
  text.replace(text.find(list), list.size(),
               "task_space_gains_d: {wrist_3_joint: 5, elbow_joint: 200, shoulder_pan_joint: 280, "
               "shoulder_lift_joint: 200, wrist_1_joint: 25, wrist_2_joint: 15}");
  EXPECT_EQ(load(text).task_space_gains_d, load(kRosParameters).task_space_gains_d);
}

TEST_F(GainsFile, AWrongCountOfGainsIsRefused) {
  EXPECT_THAT(
      refused("[280, 200, ", "[280, "),
      refused_at(
          {.line = 11, .key = "simple_effort_ctrl/task_space_gains_d", .value = "5", .limit = "6 numbers"}));
  EXPECT_THAT(
      refused("[80, 50, ", "[80, 80, 50, "),
      refused_at(
          {.line = 9, .key = "simple_effort_ctrl/task_space_gains_p", .value = "7", .limit = "6 numbers"}));
  EXPECT_THAT(
      refused("slerpDurationErrorGain: 2.5", "slerpDurationErrorGain: [2.5]"),
      refused_at({.line = 24, .key = "simple_effort_ctrl/slerpDurationErrorGain", .limit = "a number"}));
}

/// "[first, first + 1, ...]".
std::string list_from(int first) {
  std::string text;
  for (int i = 0; i < 6; ++i) text += (i > 0 ? ", " : "[") + std::to_string(first + i);
  return text + "]";
}

TEST_F(GainsFile, AForcePointMayHaveAGainForEveryJoint) {
  const std::string key = "force_control_gains: ";
  const std::string scalar = key + "[100, 4000, 100, 2000, 1500, 100]";
  std::string lists, named, flat;
  for (int i = 0; i < 6; ++i) {
    lists += (i > 0 ? ", " : "[") + list_from(10 * i);
    named += (i > 0 ? ", " : "{") + kJoints[static_cast<std::size_t>(i)] + ": " + list_from(10 * i);
    flat += (i > 0 ? ", " : "[") + list_from(10 * i).substr(1, list_from(10 * i).size() - 2);
  }
  const auto with = [&](const std::string& value) {
    std::string text = kRosParameters;
    text.replace(text.find(scalar), scalar.size(), key + value);
    return load(text);
  };
  for (const std::string& value : {lists + "]", named + "}", flat + "]"}) {
    const Gains gains = with(value);
    ASSERT_EQ(gains.force_control_gains.size(), 36) << value;
    for (int point = 0; point < 6; ++point) {
      for (int joint = 0; joint < 6; ++joint) {
        EXPECT_EQ(force_gain(gains.force_control_gains, 6, point, joint), 10 * point + joint) << value;
      }
    }
    const Gains back = load(gains_yaml(gains, {}));
    EXPECT_EQ(back.force_control_gains, gains.force_control_gains);
    EXPECT_EQ(load(gains_yaml(gains, {}, {"node", kRos2Parameters})).force_control_gains,
              gains.force_control_gains);
  }
  EXPECT_THAT(refused(scalar, key + "[" + list_from(0) + ", 1, 1, 1, 1, 1]"),
              refused_at({.line = 15, .key = "simple_effort_ctrl/force_control_gains/1", .value = "1"}));
  EXPECT_THAT(refused(scalar, key + "[" + list_from(0) + ", " + list_from(0) + "]"),
              refused_at({.line = 15,
                          .key = "simple_effort_ctrl/force_control_gains",
                          .value = "2",
                          .limit = "6 lists (one for each joint), or 6 numbers"}));
  EXPECT_THAT(
      refused(scalar, key + "[1, 2]"),
      refused_at(
          {.line = 15, .key = "simple_effort_ctrl/force_control_gains", .value = "2", .limit = "6 numbers"}));
  EXPECT_THAT(
      refused(scalar, key + named.substr(0, named.rfind(", wrist_3")) + "}"),
      refused_at(
          {.line = 15, .key = "simple_effort_ctrl/force_control_gains", .limit = "the key 'wrist_3_joint'"}));
}

TEST_F(GainsFile, AnUnknownKeyIsRefusedWithTheNearest) {
  EXPECT_THAT(refused("  obstacleInfluenceRadius", "  adaptation_gian: 1\n  obstacleInfluenceRadius"),
              refused_at({.line = 14,
                          .key = "simple_effort_ctrl/adaptation_gian",
                          .value = "adaptation_gian",
                          .limit = testing::StartsWith(
                              "the keys: controller, joint_space_gains_p, joint_space_gains")}));
  EXPECT_EQ(test::suggested_by(
                refused("  obstacleInfluenceRadius", "  adaptation_gian: 1\n  obstacleInfluenceRadius")),
            "adaptation_gain");
}

TEST_F(GainsFile, AMissingKeyIsRefused) {
  EXPECT_THAT(
      refused("  slerpDurationErrorGain: 2.5\n", ""),
      refused_at({.line = 2, .key = "simple_effort_ctrl", .limit = "the key 'slerpDurationErrorGain'"}));
  EXPECT_THAT(
      refused("slerpDurationErrorGain", "slerpDurationErrorGian"),
      refused_at({.line = 2, .key = "simple_effort_ctrl", .limit = "the key 'slerpDurationErrorGain'"}));
}

TEST_F(GainsFile, AFileCutOffAnywhereIsRefused) {
  // YAML itself takes what is left of a block mapping for a whole one.
  // Here a gain is last, and not the circle, which is none.
  const std::string last = "  force_control_gains: [100, 4000, 100, 2000, 1500, 100]";
  std::string text = kRosParameters;
  text.erase(text.find(last), last.size() + 1);
  text += "\n" + last;
  for (std::size_t length = 0; length < text.size(); ++length) {
    SCOPED_TRACE(length);
    EXPECT_THROW(load(text.substr(0, length)), InputError);
  }
  EXPECT_NO_THROW(load(text));
}

TEST_F(GainsFile, GainsThatNoControllerCanUseAreRefused) {
  EXPECT_THAT(refused("[80, 50", "[80, -50"),
              refused_at({.key = "task_space_gains_p", .value = "-50", .limit = "finite and not negative"}));
  EXPECT_THAT(
      refused("[280, 200", "[280, -1e-9"),
      refused_at({.key = "task_space_gains_d", .value = "-1e-09", .limit = "finite and not negative"}));
  EXPECT_THAT(refused("slerpDurationErrorGain: 2.5", "slerpDurationErrorGain: 0"),
              refused_at({.key = "slerpDurationErrorGain", .value = "0", .limit = "finite and above zero"}));
  EXPECT_THAT(refused("slerpDurationErrorGain: 2.5", "slerpDurationErrorGain: .nan"),
              refused_at({.line = 24,
                          .key = "simple_effort_ctrl/slerpDurationErrorGain",
                          .value = ".nan",
                          .limit = "a decimal number with '.' and no unit, such as -1.5 or 1e3"}));
  EXPECT_THAT(refused("slerpDurationErrorGain: 2.5", "slerpDurationErrorGain: fast"),
              refused_at({.line = 24,
                          .key = "simple_effort_ctrl/slerpDurationErrorGain",
                          .value = "fast",
                          .limit = "a decimal number with '.' and no unit, such as -1.5 or 1e3"}));
  EXPECT_THAT(refused("  obstacleInfluenceRadius", "  release_radius: 0.1\n  obstacleInfluenceRadius"),
              refused_at({.key = "release_radius", .value = "0.1", .limit = "0 or at least 0.325"}));
  EXPECT_THAT(refused("  obstacleInfluenceRadius", "  slerp_reference: end\n  obstacleInfluenceRadius"),
              refused_at({.line = 14,
                          .key = "simple_effort_ctrl/slerp_reference",
                          .value = "end",
                          .limit = "one of: start, current"}));
}

}  // namespace gains_file_test
}  // namespace armtune::internal
