#include "tuner/calibration/calibration_parameters.hpp"

#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "tests/tuner/calibration/hidden_arm.hpp"

namespace armtune::internal::calibration_parameters_test {
namespace {

TEST(CalibrationParameters, AtTheMeansOfThePriorsTheArmIsThatOfTheRobotFile) {
  const RobotModel model = test::hidden_arm(*load_robot("ur5e"), 1).model;
  const ShootingArm nominal = shooting_arm(model);
  const auto parameters = calibration_parameters(model, CommandKind::kPosition, {});
  const ShootingArm arm =
      arm_at(nominal, parameters, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(parameters.size())));
  for (const CalibrationParameter& p : parameters)
    EXPECT_NEAR(p.value(0.0), p.nominal, 1e-12 * (1.0 + p.nominal)) << p.name;
  EXPECT_TRUE(arm.model.chain.viscous_friction.isApprox(model.chain.viscous_friction));
  EXPECT_TRUE(arm.model.chain.link[5].inertia.isApprox(model.chain.link[5].inertia));
  EXPECT_TRUE(arm.model.chain.gravity.isApprox(model.chain.gravity));
  EXPECT_EQ(arm.delay, 0.0);
}

TEST(CalibrationParameters, TheTrueValuesMakeTheHiddenArm) {
  const test::HiddenArm hidden = test::hidden_arm(*load_robot("ur5e"), 2);
  const auto parameters = calibration_parameters(hidden.model, CommandKind::kPosition, {});
  Eigen::VectorXd z(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const CalibrationParameter& p = parameters[i];
    const double value = test::true_value(hidden, p);
    z[static_cast<Eigen::Index>(i)] = ((p.logarithmic ? std::log(value) : value) - p.mean) / p.deviation;
  }
  const ShootingArm arm = arm_at(shooting_arm(hidden.model), parameters, z);
  const Chain& truth = hidden.truth.model.chain;
  EXPECT_TRUE(arm.model.chain.coulomb_friction.isApprox(truth.coulomb_friction));
  EXPECT_TRUE(arm.model.chain.rotor_inertia.isApprox(truth.rotor_inertia));
  EXPECT_NEAR(arm.model.chain.link[5].mass, truth.link[5].mass, 1e-12);
  EXPECT_TRUE(arm.model.chain.link[5].first_moment.isApprox(truth.link[5].first_moment));
  EXPECT_TRUE(arm.model.chain.link[5].inertia.isApprox(truth.link[5].inertia));
  EXPECT_TRUE(arm.model.chain.gravity.isApprox(truth.gravity));
  EXPECT_TRUE(arm.offset.isApprox(hidden.truth.offset));
  EXPECT_TRUE(arm.model.drive_position_gain.isApprox(hidden.truth.model.drive_position_gain));
  EXPECT_NEAR(arm.delay, hidden.truth.delay, 1e-12);
}

TEST(CalibrationParameters, GainsOfDrivesBelongToCommandsThatDrivesFollow) {
  const RobotModel model = *load_robot("ur5e");
  for (const CalibrationParameter& p : calibration_parameters(model, CommandKind::kTorque, {})) {
    EXPECT_NE(p.kind, ParameterKind::kVelocityGain);
    EXPECT_NE(p.kind, ParameterKind::kPositionGain);
  }
}

TEST(CalibrationParameters, AWidthOfZeroLeavesAParameterOut) {
  CalibrationPriors priors;
  priors.tilt = 0.0;
  for (const CalibrationParameter& p :
       calibration_parameters(*load_robot("ur5e"), CommandKind::kTorque, priors))
    EXPECT_NE(p.kind, ParameterKind::kTiltX);
}

}  // namespace
}  // namespace armtune::internal::calibration_parameters_test
