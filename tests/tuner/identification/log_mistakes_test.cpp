#include "tuner/identification/log_mistakes.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <tuple>

#include "core/robot/slotine_li.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/identification/log_extremes.hpp"
#include "tuner/record/declaration.hpp"

namespace armtune::internal {
namespace log_mistakes_test {

using test::refused_at;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

constexpr double kDegree = M_PI / 180.0;

/// An arm that differs from the model as real ones do: links by up to 30 %, rotor inertia and friction
/// unknown.
Chain differing(const RobotModel& model, unsigned seed) {
  std::mt19937 generator(seed);
  Chain chain = model.chain;
  for (int i = 0; i < model.n(); ++i) {
    LinkInertia& link = chain.link[static_cast<std::size_t>(i)];
    const double factor = 1.0 + test::random_number(generator, -0.3, 0.3);
    link.mass *= factor;
    link.first_moment *= factor;
    link.inertia *= factor;
    const double effort = model.joints[static_cast<std::size_t>(i)].limits.effort;
    chain.rotor_inertia[i] = test::random_number(generator, 0.0, 1e-3) * effort;
    chain.viscous_friction[i] = test::random_number(generator, 0.005, 0.02) * effort;
    chain.coulomb_friction[i] = test::random_number(generator, 0.005, 0.02) * effort;
  }
  return chain;
}

/// Instants of a smooth motion of every joint inside its limits, with the torques that it takes, 2 % wrong.
std::vector<LogInstant> log_of(const RobotModel& model, const Chain& arm, unsigned seed) {
  std::mt19937 generator(seed);
  const int n = model.n();
  const ParameterVector theta = theta_of(arm);
  Poses poses;
  SlotineLi motion;
  std::vector<LogInstant> log;
  for (int k = 0; k < 200; ++k) {
    LogInstant at;
    at.q = test::random_vector(generator, n, 1.0);
    at.qd = test::random_vector(generator, n, 1.0);
    at.qdd = test::random_vector(generator, n, 3.0);
    forward_kinematics(arm, at.q, poses);
    slotine_li_forward(arm, poses, at.qd, at.qd, at.qdd, motion);
    slotine_li_torque(arm, poses, motion, theta, at.torque);
    for (double& torque : at.torque) torque *= 1.0 + test::random_number(generator, -0.02, 0.02);
    log.push_back(at);
  }
  return log;
}

class LogMistakes : public ::testing::Test {
 protected:
  RobotModel model_ = test::ur10();
  JointVector none_ = JointVector::Zero(6);  ///< no noise
  std::vector<LogInstant> log_ = log_of(model_, differing(model_, 11), 12);

  /// What is found of the log after every instant was changed.
  LogMistake found(const std::function<void(LogInstant&)>& change) const {
    std::vector<LogInstant> changed = log_;
    for (LogInstant& at : changed) change(at);
    const LogComparison comparison = compare_with_robot_file(model_, changed, none_);
    EXPECT_TRUE(comparison.mistake.has_value()) << "not noticed";
    return comparison.mistake.value_or(LogMistake{});
  }
};

void negate(LogInstant& at, int joint) {
  for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[joint] *= -1.0;
}

TEST_F(LogMistakes, ARightLogHasNoneWhateverItsLinksFrictionAndTool) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Chain arm = differing(model_, seed);
    if (seed % 2 == 0) {
      RobotModel carrying = model_;
      carrying.chain = arm;
      arm = with_payload(carrying, {3.0, Vec3(0.0, 0.0, 0.1)}).chain;
    }
    const LogComparison comparison = compare_with_robot_file(model_, log_of(model_, arm, seed + 100), none_);
    EXPECT_FALSE(comparison.mistake.has_value()) << seed << ": " << to_text(*comparison.mistake, model_);
  }
}

TEST_F(LogMistakes, TorquesThatHaveAnotherUnitSignOrColumnAreNamed) {
  const LogMistake scale = found([](LogInstant& at) { at.torque *= 1e-3; });
  EXPECT_EQ(scale.kind, MistakeKind::kTorqueScale);
  EXPECT_EQ(scale.value, 1e3);
  EXPECT_EQ(found([](LogInstant& at) { at.torque *= -1.0; }).kind, MistakeKind::kAllTorqueSigns);
  for (const int j : {0, 2, 5}) {
    const LogMistake sign = found([j](LogInstant& at) { at.torque[j] *= -1.0; });
    EXPECT_EQ(sign.kind, MistakeKind::kTorqueSign) << j;
    EXPECT_EQ(sign.joint, j);
    const int other = (j + 2) % model_.n();
    const LogMistake swapped =
        found([j, other](LogInstant& at) { std::swap(at.torque[j], at.torque[other]); });
    EXPECT_EQ(swapped.kind, MistakeKind::kTorquesSwapped) << j;
    EXPECT_EQ(std::min(swapped.joint, swapped.other), std::min(j, other));
    EXPECT_EQ(std::max(swapped.joint, swapped.other), std::max(j, other));
  }
}

TEST_F(LogMistakes, PositionsThatHaveAnotherUnitSignOrColumnAreNamed) {
  EXPECT_EQ(found([](LogInstant& at) {
              for (JointVector* x : {&at.q, &at.qd, &at.qdd}) *x *= 1.0 / kDegree;
            }).kind,
            MistakeKind::kDegrees);
  const LogMistake sign = found([](LogInstant& at) { negate(at, 2); });
  EXPECT_EQ(sign.kind, MistakeKind::kPositionSign);
  EXPECT_EQ(sign.joint, 2);
  const LogMistake joint = found([](LogInstant& at) {
    negate(at, 1);
    at.torque[1] *= -1.0;
  });
  EXPECT_EQ(joint.kind, MistakeKind::kJointSign);
  EXPECT_EQ(joint.joint, 1);
  const LogMistake swapped = found([](LogInstant& at) {
    for (JointVector* x : {&at.q, &at.qd, &at.qdd}) std::swap((*x)[1], (*x)[3]);
  });
  EXPECT_EQ(swapped.kind, MistakeKind::kPositionsSwapped);
  EXPECT_EQ(swapped.joint, 1);
  EXPECT_EQ(swapped.other, 3);
}

TEST_F(LogMistakes, AnotherZeroPositionIsNamedWithWhatHasToBeAdded) {
  for (const double offset : {-0.5 * M_PI, M_PI}) {
    const LogMistake zero = found([offset](LogInstant& at) { at.q[1] += offset; });
    EXPECT_EQ(zero.kind, MistakeKind::kPositionOffset);
    EXPECT_EQ(zero.joint, 1);
    EXPECT_NEAR(std::remainder(zero.value + offset, 2.0 * M_PI), 0.0, 1e-12);
  }
}

TEST_F(LogMistakes, AWrongGearRatioIsNamedWithItsFactor) {
  for (const int j : {1, 2}) {  // joints that bear the weight of others
    for (const double ratio : {0.7, 1.3, 1.8}) {
      const LogMistake gear = found([j, ratio](LogInstant& at) {
        for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[j] /= ratio;
        at.torque[j] *= ratio;
      });
      EXPECT_EQ(gear.kind, MistakeKind::kGearRatio) << j << ", " << ratio;
      EXPECT_EQ(gear.joint, j);
      // Masses that differ by up to 30 % hide the last percent.
      EXPECT_NEAR(gear.value, ratio, 0.1 * ratio) << j << ", " << ratio;
    }
  }
}

TEST_F(LogMistakes, ATorqueInAnotherUnitThanTheOthersIsNamed) {
  for (const int j : {1, 2}) {  // a torque of a wrist is too small to tell
    for (const double scale : {1e-3, 1e3}) {
      if (j == 2 && scale < 1.0) continue;  // a forearm without weight explains it as well
      const LogMistake unit = found([j, scale](LogInstant& at) { at.torque[j] *= scale; });
      EXPECT_EQ(unit.kind, MistakeKind::kTorqueScale) << j;
      EXPECT_EQ(unit.joint, j);
      EXPECT_EQ(unit.value, 1.0 / scale);
    }
  }
}

TEST_F(LogMistakes, APositionInDegreesBesideRadiansIsNamed) {
  // All were converted from degrees by whoever read the log, as the first one is too large for radians.
  const int in_degrees = 2;
  for (LogInstant& at : log_) at.q[in_degrees] += 1.0;
  const ParameterVector theta = theta_of(differing(model_, 11));
  Poses poses;
  SlotineLi motion;
  for (LogInstant& at : log_) {
    forward_kinematics(model_.chain, at.q, poses);
    slotine_li_forward(model_.chain, poses, at.qd, at.qd, at.qdd, motion);
    slotine_li_torque(model_.chain, poses, motion, theta, at.torque);
  }
  const LogMistake mixed = found([](LogInstant& at) {
    for (int j = 0; j < 6; ++j) {
      for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[j] *= j == in_degrees ? 1.0 : kDegree;
    }
  });
  EXPECT_EQ(mixed.kind, MistakeKind::kMixedUnits);
  EXPECT_EQ(mixed.joint, in_degrees);
}

TEST_F(LogMistakes, TorquesWithoutTheWeightAreNamed) {
  Chain arm = differing(model_, 13);
  arm.gravity.setZero();
  const LogComparison comparison = compare_with_robot_file(model_, log_of(model_, arm, 14), none_);
  ASSERT_TRUE(comparison.mistake.has_value());
  EXPECT_EQ(comparison.mistake->kind, MistakeKind::kNoWeight);
}

TEST(MistakeKinds, HaveDifferentNamesForFiles) {
  const std::vector<std::string> names = record::names_of<MistakeKind>();
  EXPECT_EQ(names.size(), static_cast<std::size_t>(MistakeKind::kAnotherArm) + 1);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST_F(LogMistakes, AnotherMountingIsNamedWithTheDirectionOfGravity) {
  for (const Vec3& direction : {Vec3(0.0, 0.0, 1.0), Vec3(0.0, -1.0, 0.0)}) {
    Chain arm = differing(model_, 13);
    arm.gravity = 9.81 * direction;
    const LogComparison comparison = compare_with_robot_file(model_, log_of(model_, arm, 14), none_);
    ASSERT_TRUE(comparison.mistake.has_value());
    EXPECT_EQ(comparison.mistake->kind, MistakeKind::kMounting);
    EXPECT_LT((comparison.mistake->direction - direction).norm(), 1e-12);
  }
}

TEST_F(LogMistakes, ALogOfAnArmOfOtherLengthsAndMassesIsNoticed) {
  RobotModel other = model_;
  for (Vec3& p : other.chain.p_PB0) p *= 0.7;
  for (LinkInertia& link : other.chain.link) {
    link.mass *= 0.4;
    link.first_moment *= 0.3;
    link.inertia *= 0.2;
  }
  const LogComparison comparison =
      compare_with_robot_file(model_, log_of(other, differing(other, 15), 16), none_);
  ASSERT_TRUE(comparison.mistake.has_value());
  EXPECT_EQ(comparison.mistake->kind, MistakeKind::kAnotherArm);
}

TEST_F(LogMistakes, SentencesNameTheJoints) {
  LogMistake swapped;
  swapped.kind = MistakeKind::kTorquesSwapped;
  swapped.joint = 1;
  swapped.other = 4;
  EXPECT_THAT(to_text(swapped, model_),
              AllOf(HasSubstr(model_.joints[1].name), HasSubstr(model_.joints[4].name)));
  LogMistake zero;
  zero.kind = MistakeKind::kPositionOffset;
  zero.joint = 2;
  zero.value = -0.5 * M_PI;
  EXPECT_THAT(to_text(zero, model_), AllOf(HasSubstr(model_.joints[2].name), HasSubstr("-90")));
}

TEST_F(LogMistakes, SentencesHaveTheUnitsOfTheJointsKind) {
  LogMistake scale;
  scale.kind = MistakeKind::kTorqueScale;
  LogMistake sign;
  sign.kind = MistakeKind::kTorqueSign;
  sign.joint = 0;
  LogMistake swapped;
  swapped.kind = MistakeKind::kTorquesSwapped;
  swapped.joint = 0;
  swapped.other = 1;
  for (const auto& [value, torque, force] :
       {std::tuple(1e-3, " N mm", " mN"), std::tuple(1e3, " kN m", " kN")}) {
    scale.value = value;
    RobotModel model = model_;
    EXPECT_THAT(to_text(scale, model), AllOf(HasSubstr(torque), Not(HasSubstr(force + std::string(";")))));
    model.chain.motion[0] = JointMotion::kPrismatic;
    EXPECT_THAT(to_text(scale, model), AllOf(HasSubstr(torque), HasSubstr(force + std::string(";"))));
    EXPECT_THAT(to_text(sign, model), HasSubstr("force of " + model.joints[0].name));
    EXPECT_THAT(to_text(swapped, model), AllOf(HasSubstr("force of " + model.joints[0].name),
                                               HasSubstr("torque of " + model.joints[1].name)));
    for (JointMotion& motion : model.chain.motion) motion = JointMotion::kPrismatic;
    EXPECT_THAT(to_text(scale, model), AllOf(HasSubstr(force + std::string(";")), Not(HasSubstr(torque))));
  }
}

TEST_F(LogMistakes, AUnitIsNamedOnlyWhereTheTorquesAreThoseOfAnArmInIt) {
  const auto refused = [this](double scale) {
    std::vector<LogInstant> log = log_;
    for (LogInstant& at : log) at.torque *= scale;
    InputError error = test::input_error([&] { check_units(model_, log, "log.csv"); });
    EXPECT_THAT(error, refused_at({.file = "log.csv",
                                   .key = EndsWith("/torque"),
                                   .value = Not(testing::IsEmpty()),
                                   .limit = EndsWith(" N m")}));
    return std::string(error.what());
  };
  EXPECT_THAT(refused(1000.0), AllOf(HasSubstr("in N mm,"), HasSubstr("scale: 0.001")));
  for (const double scale : {10.0, 30.0})
    EXPECT_THAT(refused(scale), AllOf(HasSubstr("--robot"), Not(HasSubstr("N mm")))) << scale;
}

TEST_F(LogMistakes, ALogWithoutMotionIsRefused) {
  for (LogInstant& at : log_) at = log_.front();
  EXPECT_THAT([&] { check_motion(model_, log_, "log.csv"); },
              refused_at({.file = "log.csv", .value = "0", .limit = "above 0.01 rad or m"}));
  log_.back().q[3] += 0.02;
  EXPECT_NO_THROW(check_motion(model_, log_, "log.csv"));
}

TEST_F(LogMistakes, LimitsOfASlidingJointAreForces) {
  model_.chain.motion[1] = JointMotion::kPrismatic;
  for (LogInstant& at : log_) {
    at.q *= 0.1;
    at.qd *= 0.1;
    at.torque = JointVector::Ones(model_.n()) + at.qd;
    at.torque[1] = (1000.0 + at.q[1]) * model_.joints[1].limits.effort;
  }
  const InputError error = test::input_error([&] { check_units(model_, log_, "log.csv"); });
  EXPECT_THAT(error, refused_at({.file = "log.csv",
                                 .key = model_.joints[1].name + "/torque",
                                 .limit = fmt::format("{:.4g} N", model_.joints[1].limits.effort)}));
  EXPECT_THAT(error.what(), AllOf(HasSubstr(" mN,"), Not(HasSubstr("N mm")), Not(HasSubstr("N m,"))));
}

TEST(ArmFitter, LeavesNothingOfTheRobotFilesOwnTorquesUnexplained) {
  const RobotModel model = test::seven_joint_arm();
  const std::vector<LogInstant> log = [&] {
    std::vector<LogInstant> own = log_of(model, model.chain, 17);
    // Without the 2 % that log_of puts on the torques.
    const ParameterVector theta = theta_of(model.chain);
    Poses poses;
    SlotineLi motion;
    for (LogInstant& at : own) {
      forward_kinematics(model.chain, at.q, poses);
      slotine_li_forward(model.chain, poses, at.qd, at.qd, at.qdd, motion);
      slotine_li_torque(model.chain, poses, motion, theta, at.torque);
    }
    return own;
  }();
  const ArmMoments moments = arm_moments(model.chain, log);
  const ArmFit fit =
      ArmFitter(model, JointVector::Zero(model.n())).fit(moments, TorqueReading::as_logged(model.n()));
  EXPECT_LT(fit.unexplained.maxCoeff(), 1e-6);
  EXPECT_LT(fit.cost, 1e-10);
  // Turned in sign nothing of it fits.
  TorqueReading turned = TorqueReading::as_logged(model.n());
  turned.factor *= -1.0;
  EXPECT_GT(ArmFitter(model, JointVector::Zero(model.n())).fit_joints_only(moments, turned).residual.norm(),
            1.9 * std::sqrt(moments.torque_squares.sum()));
}

}  // namespace log_mistakes_test
}  // namespace armtune::internal
