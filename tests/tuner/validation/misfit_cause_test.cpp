#include "tuner/validation/misfit_cause.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/tuner/validation/validation_rig.hpp"
#include "tuner/validation/misfit_text.hpp"

namespace armtune::internal {
namespace misfit_cause_test {

using test::cause_of;
using test::misfit_of;
using test::recorded;
using test::Recording;
using testing::AllOf;
using testing::HasSubstr;

class PlantedMisfit : public ::testing::TestWithParam<const char*> {
 protected:
  RobotModel model_ = test::validation_arm(GetParam());
  Chain arm_ = model_.chain;
  int joint_ = 4;
  double effort_ = model_.joints[4].limits.effort;

  Misfit found() const { return misfit_of(model_, recorded(model_, arm_)); }
};

// Noise of 0.2 % of the effort limit in 5000 samples moves a size by less than 2 %; the rest of the tolerance
// of 10 % is for friction at reversals, which the filters smooth.
TEST_P(PlantedMisfit, FrictionRotorInertiaAndOffsetAreNamedWithTheirSizes) {
  const double coulomb = 0.05 * effort_;
  arm_.coulomb_friction[joint_] += coulomb;
  const Misfit friction = found();
  ASSERT_EQ(friction.causes.size(), 1U);
  EXPECT_NEAR(cause_of(friction, CauseKind::kCoulombFriction, joint_).value, coulomb, 0.1 * coulomb);
  EXPECT_GT(friction.causes[0].share[joint_], 0.8);
  EXPECT_LT(friction.left[joint_], 0.2);

  arm_ = model_.chain;
  arm_.viscous_friction[joint_] += coulomb;
  EXPECT_NEAR(cause_of(found(), CauseKind::kViscousFriction, joint_).value, coulomb, 0.1 * coulomb);

  arm_ = model_.chain;
  arm_.rotor_inertia[joint_] += coulomb;
  EXPECT_NEAR(cause_of(found(), CauseKind::kRotorInertia, joint_).value, coulomb, 0.1 * coulomb);

  JointLog log = recorded(model_, model_.chain);
  log.torque.col(joint_).array() -= coulomb;
  EXPECT_NEAR(cause_of(misfit_of(model_, log), CauseKind::kOffset, joint_).value, -coulomb, 0.1 * coulomb);
}

TEST_P(PlantedMisfit, TooMuchFrictionHasANegativeSize) {
  model_.chain.coulomb_friction[joint_] += 0.05 * effort_;
  EXPECT_NEAR(cause_of(found(), CauseKind::kCoulombFriction, joint_).value, -0.05 * effort_, 0.005 * effort_);
}

TEST_P(PlantedMisfit, APayloadIsNamedWithMassAndCentre) {
  const Payload payload{2.0, Vec3(0.02, -0.03, 0.08)};
  arm_ = with_payload(model_, payload).chain;
  const Misfit misfit = found();
  ASSERT_FALSE(misfit.causes.empty());
  EXPECT_EQ(misfit.causes.front().kind, CauseKind::kPayload);
  const MisfitCause cause = cause_of(misfit, CauseKind::kPayload, -1);
  EXPECT_NEAR(cause.value, payload.mass, 0.1);
  EXPECT_LT((cause.vector - payload.center).norm(), 0.02);
}

TEST_P(PlantedMisfit, ATorqueConstantIsNamedWithItsScale) {
  for (const double scale : {0.8, 1.25}) {
    JointLog log = recorded(model_, model_.chain);
    log.torque.col(1) *= scale;
    EXPECT_NEAR(cause_of(misfit_of(model_, log), CauseKind::kTorqueScale, 1).value, scale, 0.02);
  }
}

TEST_P(PlantedMisfit, ATiltedBaseIsNamedWithTheDirectionOfGravity) {
  const double angle = 20.0 * M_PI / 180.0;
  arm_.gravity = 9.81 * Vec3(std::sin(angle), 0.0, -std::cos(angle));
  const Misfit misfit = found();
  const MisfitCause cause = cause_of(misfit, CauseKind::kGravityDirection, -1);
  EXPECT_NEAR(cause.value, angle, 0.03);
  EXPECT_LT((cause.vector - arm_.gravity).norm(), 0.3);
}

TEST_P(PlantedMisfit, SeveralCausesAreToldApart) {
  arm_ = with_payload(model_, {2.0, Vec3(0.0, 0.0, 0.05)}).chain;
  arm_.coulomb_friction[0] += 4.0;
  arm_.rotor_inertia[joint_] += 0.05 * effort_;
  const Misfit misfit = found();
  EXPECT_NEAR(cause_of(misfit, CauseKind::kPayload, -1).value, 2.0, 0.2);
  EXPECT_NEAR(cause_of(misfit, CauseKind::kCoulombFriction, 0).value, 4.0, 0.4);
  EXPECT_NEAR(cause_of(misfit, CauseKind::kRotorInertia, joint_).value, 0.05 * effort_, 0.01 * effort_);
}

TEST_P(PlantedMisfit, OutliersDoNotChangeTheSize) {
  arm_.coulomb_friction[joint_] += 0.05 * effort_;
  JointLog log = recorded(model_, arm_);
  for (Eigen::Index i = 0; i < log.samples(); i += 997) log.torque.row(i) *= 20.0;
  EXPECT_NEAR(cause_of(misfit_of(model_, log), CauseKind::kCoulombFriction, joint_).value, 0.05 * effort_,
              0.01 * effort_);
}

TEST_P(PlantedMisfit, NothingIsNamedWhereOnlyNoiseIsLeft) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    Recording how;
    how.seed = seed;
    EXPECT_EQ(misfit_of(model_, recorded(model_, model_.chain, how)).causes.size(), 0U) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(BundledArms, PlantedMisfit, ::testing::Values("ur5e", "panda"));

TEST(MisfitText, NamesJointValueAndUnit) {
  const RobotModel model = test::validation_arm("ur5e");
  MisfitCause cause{CauseKind::kCoulombFriction, 5, 1.2, Vec3::Zero(), JointVector::Constant(6, 0.5)};
  JointResidual residual;
  residual.explained = 0.61;
  const std::string text = joint_text(model, 5, residual, {{cause}, JointVector::Zero(6)}, 0.05);
  EXPECT_THAT(text, AllOf(HasSubstr(model.joints[5].name), HasSubstr("61"), HasSubstr("1.2 N m")));
  EXPECT_THAT(joint_text(model, 5, residual, {{cause}, JointVector::Zero(6)}, 0.6),
              testing::Not(HasSubstr("1.2")));
  EXPECT_THAT(joint_text(model, 4, residual, {{cause}, JointVector::Zero(6)}, 0.05),
              testing::Not(HasSubstr("1.2")))
      << "the cause belongs to another joint";
  for (const CauseKind kind : {CauseKind::kOffset, CauseKind::kViscousFriction, CauseKind::kRotorInertia,
                               CauseKind::kTorqueScale, CauseKind::kPayload, CauseKind::kGravityDirection}) {
    cause.kind = kind;
    EXPECT_FALSE(to_text(cause, model).empty());
  }
}

}  // namespace misfit_cause_test
}  // namespace armtune::internal
