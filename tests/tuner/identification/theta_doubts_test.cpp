#include "tuner/identification/theta_doubts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace theta_doubts_test {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A result that leaves a twentieth of each torque, of an arm that is the robot file's, with friction that it
/// lacks.
Identification plausible(const RobotModel& model) {
  Identification found;
  found.theta = theta_of(model.chain);
  found.torque_noise = JointVector::Zero(model.n());
  for (Unexplained* rows : {&found.fitted, &found.held_out}) {
    rows->rows = 100;
    rows->torque = 0.1 * model.effort_limits();
    rows->by_theta = 0.05 * rows->torque;
    rows->by_file = 0.3 * rows->torque;
    rows->file = rows->torque;
  }
  return found;
}

class ThetaDoubts : public ::testing::Test {
 protected:
  RobotModel model_ = test::ur10();
  Identification found_ = plausible(model_);
};

TEST_F(ThetaDoubts, APlausibleResultHasNone) {
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
}

TEST_F(ThetaDoubts, AJointWhoseTorqueIsNotExplainedIsNamed) {
  found_.fitted.by_theta[2] = 0.6 * found_.fitted.torque[2];
  EXPECT_THAT(theta_doubts(model_, found_), ElementsAre(HasSubstr(model_.joints[2].name)));
  found_ = plausible(model_);
  found_.held_out.by_theta[4] = 0.6 * found_.held_out.torque[4];
  EXPECT_THAT(theta_doubts(model_, found_),
              ElementsAre(AllOf(HasSubstr(model_.joints[4].name), HasSubstr("held out"))));
}

TEST_F(ThetaDoubts, AJointThatTheRobotFileExplainsBetterIsNamed) {
  found_.fitted.by_theta[1] = 0.25 * found_.fitted.torque[1];
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
  found_.fitted.by_file[1] = 0.1 * found_.fitted.torque[1];
  EXPECT_THAT(theta_doubts(model_, found_), ElementsAre(HasSubstr(model_.joints[1].name)));
  // A doubled torque of the elbow made the joint before it so.
  found_ = plausible(model_);
  found_.held_out.by_theta[1] = 0.187 * found_.held_out.torque[1];
  found_.held_out.by_file[1] = 0.142 * found_.held_out.torque[1];
  EXPECT_THAT(theta_doubts(model_, found_), ElementsAre(HasSubstr(model_.joints[1].name)));
}

TEST_F(ThetaDoubts, NoiseAndTorquesNextToNothingDoNotCount) {
  found_.torque_noise[5] = 0.6 * found_.fitted.torque[5];
  found_.fitted.by_theta[5] = found_.held_out.by_theta[5] = 0.6 * found_.fitted.torque[5];
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
  found_ = plausible(model_);
  found_.fitted.torque[3] = found_.held_out.torque[3] = 1e-3 * model_.effort_limits()[3];
  found_.fitted.by_theta[3] = found_.held_out.by_theta[3] = 0.99 * found_.fitted.torque[3];
  found_.fitted.by_file[3] = found_.held_out.by_file[3] = 0.99 * found_.fitted.torque[3];
  found_.fitted.file[3] = found_.held_out.file[3] = found_.fitted.torque[3];
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
}

TEST_F(ThetaDoubts, ADeadColumnIsNamedWhateverItsNoise) {
  for (Unexplained* rows : {&found_.fitted, &found_.held_out}) {
    rows->torque[3] = 1e-5 * model_.effort_limits()[3];
    rows->by_theta[3] = 100.0 * rows->torque[3];
    rows->by_file[3] = 0.1 * model_.effort_limits()[3];
  }
  found_.torque_noise[3] = found_.fitted.by_theta[3];
  EXPECT_THAT(theta_doubts(model_, found_),
              ElementsAre(AllOf(HasSubstr(model_.joints[3].name), HasSubstr("may be dead"))));
}

TEST_F(ThetaDoubts, ALogThatNeitherParametersExplainMayBeOfAnotherArm) {
  found_.fitted.by_file = 0.6 * found_.fitted.torque;
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty()) << "the robot file may have no real masses";
  found_.fitted.by_theta[2] = 0.18 * found_.fitted.torque[2];
  EXPECT_THAT(theta_doubts(model_, found_),
              ElementsAre(AllOf(HasSubstr("another arm"), HasSubstr(model_.joints[2].name))));
  found_.fitted.by_file[4] = 0.3 * found_.fitted.torque[4];
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
}

TEST_F(ThetaDoubts, AnotherArmAlsoShowsOnHeldOutRowsAndInLinksThatWeighNothing) {
  found_.fitted.by_file = 0.6 * found_.fitted.torque;
  found_.held_out.by_theta[2] = 0.14 * found_.held_out.torque[2];
  EXPECT_THAT(theta_doubts(model_, found_),
              ElementsAre(AllOf(HasSubstr("another arm"), HasSubstr("14 %"), HasSubstr("held out"))));
  found_ = plausible(model_);
  found_.theta[5 * kLinkParameters] *= 0.02;
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty()) << "the robot file explains the log";
  found_.fitted.by_file = 0.6 * found_.fitted.torque;
  EXPECT_THAT(
      theta_doubts(model_, found_),
      ElementsAre(AllOf(HasSubstr("another arm"), HasSubstr(model_.joints[5].link), HasSubstr("0.02"))));
  found_.theta[5 * kLinkParameters] *= 10.0;
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
  found_.theta[joint_parameter_index(model_.n(), 2)] *= 5.0;
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty()) << "an estimated rotor inertia may be wrong";
  found_.theta[joint_parameter_index(model_.n(), 2)] *= 2.0;
  EXPECT_THAT(
      theta_doubts(model_, found_),
      ElementsAre(AllOf(HasSubstr("another arm"), HasSubstr(model_.joints[2].name), HasSubstr("10 times"))));
}

TEST_F(ThetaDoubts, AnArmThatIsMuchLighterThanTheRobotFilesIsNamed) {
  // Joint 1 bears a good part of its limit. Its torque is a share of the predicted one, and a part that does
  // not follow it.
  const auto scaled = [this](double share, double other) {
    found_ = plausible(model_);
    Unexplained& rows = found_.fitted;
    rows.file[1] = 0.3 * model_.effort_limits()[1];
    rows.torque[1] = std::hypot(share, other) * rows.file[1];
    rows.by_file[1] = std::hypot(1.0 - share, other) * rows.file[1];
    rows.by_theta[1] = 0.05 * rows.torque[1];
    return theta_doubts(model_, found_);
  };
  EXPECT_THAT(scaled(0.5, 0.2), ElementsAre(AllOf(HasSubstr("lighter arm"), HasSubstr(model_.joints[1].name),
                                                  HasSubstr("0.5 times"))));
  EXPECT_THAT(scaled(0.65, 0.2), IsEmpty()) << "a robot file may be that wrong";
  EXPECT_THAT(scaled(0.5, 0.45), IsEmpty()) << "the torque does not follow the predicted one";
  EXPECT_THAT(scaled(2.0, 0.2), IsEmpty()) << "a payload";
  EXPECT_THAT(scaled(-1.0, 0.5),
              Contains(AllOf(HasSubstr("opposite sign"), HasSubstr(model_.joints[1].name))));
  EXPECT_THAT(scaled(-1.0, 1.5), Not(Contains(HasSubstr("opposite sign")))) << "hardly related";
}

TEST_F(ThetaDoubts, MassesThatAreNotTheRobotFilesAreNamed) {
  double arm = 0.0;
  for (int i = 0; i < model_.n(); ++i) arm += found_.theta[i * kLinkParameters];
  found_.theta[5 * kLinkParameters] += 0.6 * arm;
  EXPECT_THAT(theta_doubts(model_, found_), ElementsAre(HasSubstr(model_.joints[5].link)));
  // A tool of a quarter of the arm may well be missing in the robot file.
  found_ = plausible(model_);
  found_.theta[5 * kLinkParameters] += 0.25 * arm;
  EXPECT_THAT(theta_doubts(model_, found_), IsEmpty());
  for (const double factor : {2.0, 0.5}) {
    found_ = plausible(model_);
    for (int i = 0; i < model_.n(); ++i) found_.theta[i * kLinkParameters] *= factor;
    EXPECT_THAT(theta_doubts(model_, found_), ElementsAre(HasSubstr("moved links")));
  }
}

}  // namespace theta_doubts_test
}  // namespace armtune::internal
