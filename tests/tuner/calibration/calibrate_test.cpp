#include "tuner/calibration/calibrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/document.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/tuner/calibration/hidden_arm.hpp"
#include "tuner/calibration/calibration_files.hpp"

namespace armtune::internal::calibrate_test {
namespace {

using test::HiddenArm;
using test::HiddenRecording;

HiddenRecording short_recording(CommandKind kind, unsigned seed) {
  HiddenRecording how;
  how.kind = kind;
  how.seed = seed;
  how.rate = 250.0;
  how.duration = 13.0;
  return how;
}

/// An arm that was calibrated from a short log of torque commands.
struct Calibrated {
  HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 11, 250.0);
  CommandedLog log = test::record(arm, short_recording(CommandKind::kTorque, 12));
  Calibration found = calibrate(arm.model, {&log, 1});
};
const Calibrated& calibrated() {
  static const Calibrated once;
  return once;
}

TEST(Calibrate, TheErrorOnUnseenMotionIsAtMostAFifth) {
  const Calibrated& c = calibrated();
  const CommandedLog unseen = test::record(c.arm, short_recording(CommandKind::kTorque, 99));
  const HeldOutError before =
      horizon_error(c.arm.model, shooting_arm(c.arm.model), {&unseen, 1}, c.found.noise, HorizonPart::kWhole);
  const HeldOutError after =
      horizon_error(c.arm.model, c.found.arm, {&unseen, 1}, c.found.noise, HorizonPart::kWhole);
  EXPECT_GT(after.windows.back(), 0);
  EXPECT_LE(after.ratio_to(before, kReportedHorizons.size() - 1), 0.2);
  EXPECT_LE(c.found.after.ratio_to(c.found.before, kReportedHorizons.size() - 1), 0.2);
}

TEST(Calibrate, IntervalsHoldTheTrueValues) {
  const Calibrated& c = calibrated();
  int told = 0;
  int held = 0;
  for (const FittedParameter& p : c.found.parameters) {
    if (!p.told) continue;
    const double truth = test::true_value(c.arm, p.prior);
    ++told;
    if (truth >= p.low && truth <= p.high) ++held;
    EXPECT_LE(p.low, p.value) << p.prior.name;
    EXPECT_GE(p.high, p.value) << p.prior.name;
  }
  EXPECT_GE(told, 15);
  // With 95 % intervals, fewer than 80 % of 15 or more hold in less than one log of a hundred.
  EXPECT_GE(held, 0.8 * told);
}

TEST(Calibrate, TheOffsetOfAJointAboutTheVerticalIsNotToldByAnyMotion) {
  const auto& parameters = calibrated().found.parameters;
  const auto offset = std::find_if(parameters.begin(), parameters.end(), [](const FittedParameter& p) {
    return p.prior.kind == ParameterKind::kEncoderOffset && p.prior.joint == 0;
  });
  ASSERT_NE(offset, parameters.end());
  EXPECT_FALSE(offset->told);
  EXPECT_EQ(offset->need, CalibrationNeed::kOutside);
}

TEST(Calibrate, OnlyParametersThatAreNotToldHaveANeed) {
  for (const FittedParameter& p : calibrated().found.parameters)
    EXPECT_EQ(p.told, p.need == CalibrationNeed::kNone) << p.prior.name;
}

TEST(Calibrate, FilesHoldTheFittedValues) {
  const Calibrated& c = calibrated();
  const yaml::Node uncertainty = yaml::parse_text(uncertainty_yaml(c.found), "uncertainty.yaml");
  for (const char* key : {"parameters", "covariance"}) {
    ASSERT_NE(uncertainty.find(key), nullptr);
    EXPECT_EQ(uncertainty.find(key)->items().size(), c.found.parameters.size());
  }
  const yaml::Node robot =
      yaml::parse_text(calibrated_robot_yaml(c.arm.model, c.found, "robot.urdf"), "robot.yaml");
  EXPECT_NE(robot.find("coulomb_friction"), nullptr);
  EXPECT_TRUE(calibrated_model(c.arm.model, c.found).chain.coulomb_friction ==
              c.found.arm.model.chain.coulomb_friction);
}

TEST(Calibrate, LogsWithoutCommandsAreRefused) {
  CommandedLog log = calibrated().log;
  log.commands.kind = CommandKind::kReference;
  EXPECT_THAT([&] { return calibrate(calibrated().arm.model, {}); },
              (test::refused_at({.key = "logs", .value = "0"})));
  CommandedLog other = calibrated().log;
  other.commands.kind = CommandKind::kVelocity;
  const std::vector<CommandedLog> mixed{calibrated().log, other};
  EXPECT_THAT(
      [&] { return calibrate(calibrated().arm.model, mixed); },
      (test::refused_at({.file = "hidden arm", .key = "commands", .value = "velocity", .limit = "torque"})));
}

}  // namespace
}  // namespace armtune::internal::calibrate_test
