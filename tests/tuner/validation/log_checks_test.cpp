#include "tuner/validation/log_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "tests/tuner/validation/validation_rig.hpp"
#include "tuner/record/declaration.hpp"
#include "tuner/validation/torque_slopes.hpp"

namespace armtune::internal {
namespace log_checks_test {

using test::findings_of;
using test::has_finding;
using test::recorded;
using test::Recording;

class WrongLog : public ::testing::TestWithParam<const char*> {
 protected:
  RobotModel model_ = test::validation_arm(GetParam());
  JointLog log_ = recorded(model_, model_.chain);

  /// The finding of a kind; a failure if there is none.
  LogFinding finding(LogFindingKind kind) const {
    const std::vector<LogFinding> all = findings_of(model_, log_);
    for (const LogFinding& one : all) {
      if (one.kind == kind) {
        EXPECT_FALSE(to_text(one, model_).empty());
        return one;
      }
    }
    ADD_FAILURE() << "kind " << static_cast<int>(kind) << " was not found among " << all.size();
    return {};
  }
  LogMistake mistake() const { return finding(LogFindingKind::kMistake).mistake.value_or(LogMistake{}); }
};

TEST_P(WrongLog, GoodOnesAreAccepted) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    Recording how;
    how.seed = seed;
    how.velocities = seed % 2 == 0;
    how.rate = seed % 3 == 0 ? 125.0 : 500.0;
    const TorqueValidation found = validate_torques(model_, recorded(model_, model_.chain, how));
    EXPECT_TRUE(found.model_matches()) << seed;
    for (const LogFinding& one : found.findings) ADD_FAILURE() << seed << ": " << to_text(one, model_);
  }
}

TEST_P(WrongLog, TorquesOfOtherSignOrColumnAreNamed) {
  log_.torque.col(1) *= -1.0;
  EXPECT_EQ(mistake().kind, MistakeKind::kTorqueSign);
  EXPECT_EQ(mistake().joint, 1);
  log_.torque.col(1) *= -1.0;
  log_.torque.col(1).swap(log_.torque.col(3));
  EXPECT_EQ(mistake().kind, MistakeKind::kTorquesSwapped);
}

TEST_P(WrongLog, PositionsOfOtherSignAreNamed) {
  log_.q.col(1) *= -1.0;
  log_.qd.col(1) *= -1.0;
  EXPECT_EQ(mistake().kind, MistakeKind::kPositionSign);
  EXPECT_EQ(mistake().joint, 1);
}

TEST_P(WrongLog, AnArmUpsideDownIsNamed) {
  Chain arm = model_.chain;
  arm.gravity *= -1.0;
  log_ = recorded(model_, arm);
  EXPECT_EQ(mistake().kind, MistakeKind::kMounting);
}

TEST_P(WrongLog, ATiltedArmIsNamedWithTheAngle) {
  Chain arm = model_.chain;
  arm.gravity = 9.81 * Vec3(0.0, std::sin(0.3), -std::cos(0.3));
  log_ = recorded(model_, arm);
  EXPECT_NEAR(finding(LogFindingKind::kTilt).value, 0.3, 0.03);
}

TEST_P(WrongLog, VelocitiesOfOtherSignScaleOrColumnAreNamed) {
  log_.qd.col(2) *= -1.0;
  EXPECT_EQ(finding(LogFindingKind::kVelocitySign).joint, 2);
  log_.qd.col(2) *= -180.0 / M_PI;
  EXPECT_NEAR(finding(LogFindingKind::kVelocityScale).value, 180.0 / M_PI, 1.0);
  log_ = recorded(model_, model_.chain);
  log_.qd.col(0).swap(log_.qd.col(3));
  const LogFinding order = finding(LogFindingKind::kVelocityOrder);
  EXPECT_EQ(std::minmax(order.joint, order.other), std::minmax(0, 3));
}

TEST_P(WrongLog, ARateThatIsWrongIsNamedWithItsFactor) {
  for (double& t : log_.time) t *= 2.0;
  EXPECT_NEAR(finding(LogFindingKind::kRate).value, 0.5, 0.01);
}

TEST_P(WrongLog, TimeOffsetsAreNamedWithTheirSize) {
  for (const double offset : {0.03, -0.05, 0.1}) {
    Recording how;
    how.torque_delay = offset;
    log_ = recorded(model_, model_.chain, how);
    EXPECT_NEAR(finding(LogFindingKind::kTorqueOffset).value, offset, 0.006) << offset;
    how.torque_delay = 0.0;
    how.velocity_delay = offset;
    log_ = recorded(model_, model_.chain, how);
    EXPECT_NEAR(finding(LogFindingKind::kVelocityOffset).value, offset, 0.003) << offset;
  }
}

TEST_P(WrongLog, FilteredTorquesAreNamedWithTheTimeConstant) {
  const double constant = 0.15;
  const double keep = std::exp(-1.0 / (250.0 * constant));
  for (Eigen::Index i = 1; i < log_.samples(); ++i)
    log_.torque.row(i) = keep * log_.torque.row(i - 1) + (1.0 - keep) * log_.torque.row(i).eval();
  EXPECT_NEAR(finding(LogFindingKind::kTorqueFiltered).value, constant, 0.25 * constant);
}

TEST_P(WrongLog, AFilterThatIsFasterThanThoseOfTheComparisonIsNotNamed) {
  const double keep = std::exp(-1.0 / (250.0 * 0.015));
  for (Eigen::Index i = 1; i < log_.samples(); ++i)
    log_.torque.row(i) = keep * log_.torque.row(i - 1) + (1.0 - keep) * log_.torque.row(i).eval();
  EXPECT_FALSE(has_finding(findings_of(model_, log_), LogFindingKind::kTorqueFiltered));
}

TEST_P(WrongLog, ClippedTorquesAreNamedWithTheLimit) {
  const double high = 0.5 * log_.torque.col(1).maxCoeff() + 0.5 * log_.torque.col(1).mean();
  log_.torque.col(1) = log_.torque.col(1).cwiseMin(high);
  const LogFinding clipped = finding(LogFindingKind::kTorqueClipped);
  EXPECT_EQ(clipped.joint, 1);
  EXPECT_EQ(clipped.value, high);
  EXPECT_FALSE(has_finding(findings_of(model_, log_), LogFindingKind::kTorqueFrozen))
      << "a clipped torque is not frozen";
}

TEST_P(WrongLog, FrozenChannelsAreNamedWithTheirTime) {
  log_.torque.col(2).segment(2000, 500).setConstant(log_.torque(2000, 2));
  const LogFinding torque = finding(LogFindingKind::kTorqueFrozen);
  EXPECT_EQ(torque.joint, 2);
  EXPECT_NEAR(torque.value, 2.0, 0.01);
  EXPECT_NEAR(torque.time, 8.0, 0.01);
  log_.qd.col(0).segment(2000, 500).setConstant(log_.qd(2000, 0));
  EXPECT_EQ(finding(LogFindingKind::kVelocityFrozen).joint, 0);
  log_.q.col(4).segment(1000, 500).setConstant(log_.q(1000, 4));
  EXPECT_EQ(finding(LogFindingKind::kPositionFrozen).joint, 4);
}

TEST_P(WrongLog, ARestartInTheMiddleIsNamedWithItsTime) {
  JointLog other = log_;
  Recording how;
  how.seed = 77;
  other = recorded(model_, model_.chain, how);
  log_.q.bottomRows(2500) = other.q.bottomRows(2500);
  log_.qd.bottomRows(2500) = other.qd.bottomRows(2500);
  log_.torque.bottomRows(2500) = other.torque.bottomRows(2500);
  EXPECT_NEAR(finding(LogFindingKind::kJump).time, 10.0, 1e-9);
}

TEST_P(WrongLog, PositionsInDegreesAreNamed) {
  log_.q *= 180.0 / M_PI;
  log_.qd *= 180.0 / M_PI;
  const std::vector<LogFinding> all = findings_of(model_, log_);
  EXPECT_TRUE(has_finding(all, LogFindingKind::kPositionUnit) ||
              std::any_of(all.begin(), all.end(), [](const LogFinding& one) {
                return one.mistake && one.mistake->kind == MistakeKind::kDegrees;
              }));
}

TEST_P(WrongLog, ATorqueThatNeverChangesIsNotTakenForAnotherArm) {
  log_.torque.col(1).setConstant(1.0);
  EXPECT_EQ(finding(LogFindingKind::kTorqueFrozen).joint, 1);
  EXPECT_FALSE(has_finding(findings_of(model_, log_), LogFindingKind::kMistake));
}

TEST_P(WrongLog, AGearRatioIsNamedWithItsJoint) {
  log_.q.col(1) *= 1.25;
  log_.qd.col(1) *= 1.25;
  log_.torque.col(1) /= 1.25;
  EXPECT_EQ(mistake().kind, MistakeKind::kGearRatio);
  EXPECT_EQ(mistake().joint, 1);
  EXPECT_NEAR(mistake().value, 0.8, 0.02);
}

INSTANTIATE_TEST_SUITE_P(BundledArms, WrongLog, ::testing::Values("ur5e", "panda"));

TEST(LogOfAnotherArm, IsNotExplainedByAnySignOrColumn) {
  for (const auto& [file, arm] : {std::pair("ur10", "ur3e"), std::pair("ur10", "ur5e"),
                                  std::pair("ur5e", "ur3e"), std::pair("ur5e", "ur10")}) {
    const RobotModel model = test::validation_arm(file);
    const RobotModel other = test::validation_arm(arm);
    const TorqueValidation found = validate_torques(model, recorded(model, other.chain));
    EXPECT_FALSE(found.model_matches());
    ASSERT_TRUE(has_finding(found.findings, LogFindingKind::kMistake)) << file << ", " << arm;
    EXPECT_STREQ(kind_of(found.findings.back()), "another_arm") << file << ", " << arm;
  }
}

TEST(LogOfAnotherArm, IsNotFoundWhereTheArmCarriesAPayload) {
  const RobotModel model = test::validation_arm("ur5e");
  const RobotModel carrying = with_payload(model, {4.0, Vec3(0.0, 0.0, 0.1)});
  for (const LogFinding& one : findings_of(model, recorded(model, carrying.chain)))
    ADD_FAILURE() << to_text(one, model);
}

TEST(TorqueSlopes, AreTheFactorsOfTheTorques) {
  const RobotModel model = test::validation_arm("ur5e");
  JointLog log = recorded(model, model.chain);
  log.torque.col(1) *= 1.5;
  log.torque.col(2) *= 0.5;
  const JointVector slopes = torque_slopes(torque_rows(model, joint_motion(model, log)));
  EXPECT_NEAR(slopes[1], 1.5, 0.01);
  EXPECT_NEAR(slopes[2], 0.5, 0.01);
}

TEST(LogFindingKinds, HaveDifferentNamesForFiles) {
  const std::vector<std::string> names = record::names_of<LogFindingKind>();
  EXPECT_EQ(names.size(), static_cast<std::size_t>(LogFindingKind::kMistake) + 1);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  LogFinding finding;
  finding.mistake = LogMistake{.kind = MistakeKind::kMounting};
  EXPECT_STREQ(kind_of(finding), name(MistakeKind::kMounting));
  EXPECT_STREQ(name(CauseKind::kGravityDirection), "gravity_direction");
}

TEST(ValidationThresholdFields, NameEveryMemberOnce) {
  ValidationThresholds thresholds;
  double* const first = &thresholds.explained;
  const auto& fields = validation_threshold_fields();
  EXPECT_EQ(sizeof(ValidationThresholds), fields.size() * sizeof(double));
  for (std::size_t i = 0; i < fields.size(); ++i) EXPECT_EQ(&(thresholds.*fields[i].value), first + i);
}

}  // namespace log_checks_test
}  // namespace armtune::internal
