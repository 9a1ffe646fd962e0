#include "tuner/calibration/calibration_summary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/document.hpp"
#include "tuner/calibration/calibration_files.hpp"
#include "tuner/calibration/session/calibration_tables.hpp"

namespace armtune::internal {
namespace calibration_summary_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

FittedParameter fitted(ParameterKind kind, int joint, const std::string& name, double spread) {
  FittedParameter p;
  p.prior.kind = kind;
  p.prior.joint = joint;
  p.prior.name = name;
  p.prior.unit = "N m, N";
  p.spread = spread;
  p.told = spread <= 0.5;
  p.kept = spread > 0.9;
  if (!p.told) p.need = CalibrationNeed::kReversals;
  return p;
}

/// A calibration of two joints whose held-out windows reach 1 s.
Calibration calibration(double before, double after) {
  Calibration found;
  found.noise = Eigen::VectorXd::Constant(2, 1e-6);
  for (HeldOutError* error : {&found.before, &found.after}) {
    error->rms.setConstant(4, 2, error == &found.before ? before : after);
    error->rms.row(3).setConstant(kNone);
    error->windows = {9, 8, 7, 0};
  }
  found.fit.converged = true;
  found.parameters = {fitted(ParameterKind::kCoulombFriction, 0, "a/coulomb_friction", 0.1),
                      fitted(ParameterKind::kCoulombFriction, 1, "b/coulomb_friction", 0.1)};
  return found;
}

TEST(CalibrationSummary, JudgesAtTheLongestHorizonThatWindowsReach) {
  const HeldOutGain gain = held_out_gain(calibration(0.2, 0.05));
  EXPECT_EQ(gain.horizon, 1.0);
  EXPECT_EQ(gain.windows, 7);
  EXPECT_NEAR(gain.ratio, 0.25, 1e-6);
  EXPECT_TRUE(gain.better());
  EXPECT_FALSE(held_out_gain(calibration(0.05, 0.2)).better());
}

TEST(CalibrationSummary, ErrorsBelowTheEncoderNoiseDoNotCount) {
  Calibration found = calibration(0.2, 0.1);
  found.before.rms.col(1).setZero();  // a joint that stands still and is simulated exactly
  found.after.rms.col(1).setConstant(1e-9);
  const HeldOutGain gain = held_out_gain(found);
  EXPECT_NEAR(gain.ratio, std::sqrt(0.5 * (0.25 + 1.0)), 1e-3);
}

TEST(CalibrationSummary, HeadlineHasTheChangeAndWhatTheLogDoesNotTell) {
  Calibration found = calibration(0.2, 0.05);
  EXPECT_THAT(headline(found), HasSubstr("75.0 %"));
  EXPECT_THAT(headline(found), Not(HasSubstr("coulomb_friction")));
  found.parameters[1] = fitted(ParameterKind::kCoulombFriction, 1, "b/coulomb_friction", 0.95);
  found.parameters.push_back(fitted(ParameterKind::kDelay, -1, "delay", 0.7));
  EXPECT_THAT(headline(found), HasSubstr("coulomb_friction of b and delay"));
}

TEST(CalibrationSummary, NamesTheMotionThatWouldTellAParameter) {
  Calibration found = calibration(0.2, 0.05);
  EXPECT_TRUE(untold_sentences(found).empty());
  for (FittedParameter& p : found.parameters) p = fitted(p.prior.kind, p.prior.joint, p.prior.name, 0.95);
  found.parameters.push_back(fitted(ParameterKind::kEncoderOffset, 0, "a/encoder_offset", 1.0));
  found.parameters.back().need = CalibrationNeed::kOutside;
  const std::vector<UntoldKind> kinds = untold_kinds(found, CalibrationNeed::kReversals);
  ASSERT_EQ(kinds.size(), 1U);
  EXPECT_EQ(kinds[0].what, "coulomb_friction");
  EXPECT_THAT(kinds[0].joints, ElementsAre("a", "b"));
  EXPECT_TRUE(kinds[0].every_joint);
  EXPECT_THAT(untold_sentences(found), ElementsAre(HasSubstr(meaning(CalibrationNeed::kReversals)),
                                                   HasSubstr(meaning(CalibrationNeed::kOutside))));
}

TEST(CalibrationSummary, IntervalsOfPositionCommandsAreSaidToBeTooNarrow) {
  Calibration found = calibration(0.2, 0.05);
  found.z = Eigen::VectorXd::Zero(2);
  found.covariance = Eigen::MatrixXd::Identity(2, 2);
  EXPECT_THAT(caution_sentences(found), Not(Contains(kNarrowIntervals)));
  EXPECT_THAT(uncertainty_yaml(found), Not(HasSubstr(kNarrowIntervals)));
  found.commands = CommandKind::kPosition;
  EXPECT_THAT(caution_sentences(found), Contains(kNarrowIntervals));
  const std::string text = uncertainty_yaml(found);
  EXPECT_THAT(text, HasSubstr(kNarrowIntervals));
  EXPECT_EQ(yaml::parse_text(text, "uncertainty.yaml").find("parameters")->items().size(), 2U);
}

TEST(CalibrationSummary, ValuesOfAnArmThatIsNotBetterAreSaidToBeUnreliable) {
  EXPECT_THAT(caution_sentences(calibration(0.05, 0.2)), ElementsAre(HasSubstr("not reliable")));
}

TEST(CalibrationSummary, FewWindowsAndAFitThatDidNotConvergeAreSaid) {
  Calibration found = calibration(0.2, 0.05);
  EXPECT_TRUE(caution_sentences(found).empty());
  found.fit.converged = false;
  found.fit.iterations = 40;
  found.before.windows[2] = 2;
  EXPECT_THAT(caution_sentences(found), ElementsAre(HasSubstr("40"), HasSubstr("2")));
}

TEST(CalibrationSummary, WhatARobotFileCannotContainIsSaidUnlessItIsKept) {
  Calibration found = calibration(0.2, 0.05);
  found.parameters.push_back(fitted(ParameterKind::kDelay, -1, "delay", 0.95));
  EXPECT_TRUE(caution_sentences(found).empty());
  found.parameters.back() = fitted(ParameterKind::kDelay, -1, "delay", 0.1);
  EXPECT_THAT(caution_sentences(found), ElementsAre(HasSubstr("robot.yaml")));
}

TEST(CalibratedModel, KeepsTheMarksOfValuesThatWereNotFitted) {
  RobotModel model = *load_robot("ur10");
  model.rotor_source = ValueSource::kPublished;
  model.coulomb_source = ValueSource::kPublished;
  Calibration found;
  found.arm = shooting_arm(model);
  found.parameters = {fitted(ParameterKind::kCoulombFriction, 0, "a/coulomb_friction", 0.1),
                      fitted(ParameterKind::kRotorInertia, 0, "a/rotor_inertia", 0.95)};
  const RobotModel calibrated = calibrated_model(model, found);
  EXPECT_EQ(calibrated.coulomb_source, ValueSource::kGiven);
  EXPECT_EQ(calibrated.rotor_source, ValueSource::kPublished);
}

TEST(CalibrationTables, UnitsAreThoseOfTheJoint) {
  RobotModel model = *load_robot("ur10");
  model.chain.motion[1] = JointMotion::kPrismatic;
  CalibrationParameter p;
  p.unit = "N m, N";
  p.joint = 0;
  EXPECT_EQ(unit_of(model, p), "N m");
  p.joint = 1;
  EXPECT_EQ(unit_of(model, p), "N");
  p.joint = -1;
  p.unit = "kg";
  EXPECT_EQ(unit_of(model, p), "kg");
}

}  // namespace calibration_summary_test
}  // namespace armtune::internal
