// What a calibration writes about its uncertainty is what arms are drawn from.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/arm_distribution.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/calibration/hidden_arm.hpp"
#include "tuner/calibration/calibration_files.hpp"

namespace armtune::internal::uncertainty_file_test {
namespace {

/// A calibration of every parameter that commands of this kind act on, without a log. The payload's centre
/// along z keeps the robot file's value.
struct MadeUp {
  explicit MadeUp(CommandKind kind) {
    CalibrationPriors priors;
    priors.torque_factor = 0.1;
    const RobotModel model = test::hidden_arm(*load_robot("ur5e"), 1).model;
    const auto parameters = calibration_parameters(model, kind, priors);
    const auto n = static_cast<Eigen::Index>(parameters.size());
    found.commands = kind;
    found.z = Eigen::VectorXd::LinSpaced(n, -0.5, 0.8);
    found.covariance = 0.02 * Eigen::MatrixXd::Ones(n, n);
    found.covariance.diagonal().setConstant(0.05);
    std::vector<CalibrationParameter> seen;
    std::vector<double> seen_z;
    for (Eigen::Index i = 0; i < n; ++i) {
      const CalibrationParameter& p = parameters[static_cast<std::size_t>(i)];
      const bool kept = p.kind == ParameterKind::kPayloadCenterZ;
      found.parameters.push_back(
          {p, p.value(found.z[i]), 0.0, 1.0, 0.2, !kept, kept, CalibrationNeed::kNone});
      if (kept) continue;
      seen.push_back(p);
      seen_z.push_back(p.kind == ParameterKind::kDelay ? 0.4 : found.z[i]);
      if (p.kind == ParameterKind::kDelay) found.z[i] = 0.4;  // 4 ms: not negative
      if (p.kind == ParameterKind::kPayloadMass) found.z[i] = seen_z.back() = 0.5;
      found.parameters.back().value = p.value(found.z[i]);
    }
    found.arm = arm_at(shooting_arm(model), seen,
                       Eigen::VectorXd::Map(seen_z.data(), static_cast<Eigen::Index>(seen_z.size())));
    scenario.name = "made up";
    scenario.robot = std::make_shared<const RobotModel>(calibrated_model(model, found));
    scenario.control_period = 0.002;
    scenario.start_position = JointVector::Zero(model.n());
    distribution =
        load_arm_distribution(folder.write("uncertainty.yaml", uncertainty_yaml(found)), {&scenario, 1});
  }

  test::TemporaryFolder folder;
  Calibration found;
  Scenario scenario;
  std::shared_ptr<const ArmDistribution> distribution;
};

constexpr CommandKind kKinds[] = {CommandKind::kTorque, CommandKind::kVelocity, CommandKind::kPosition};

TEST(UncertaintyYaml, IsReadAsTheDistributionThatWasWritten) {
  for (const CommandKind kind : kKinds) {
    const MadeUp made(kind);
    const auto& parameters = made.distribution->parameters;
    ASSERT_EQ(parameters.size(), made.found.parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const CalibrationParameter& p = made.found.parameters[i].prior;
      const auto k = static_cast<Eigen::Index>(i);
      EXPECT_EQ(parameters[i].name, p.name);
      EXPECT_EQ(parameters[i].joint, p.joint) << p.name;
      EXPECT_EQ(parameters[i].logarithmic, p.logarithmic) << p.name;
      EXPECT_EQ(parameters[i].mean, p.mean + p.deviation * made.found.z[k]) << p.name;
      EXPECT_EQ(parameters[i].told, made.found.parameters[i].told) << p.name;
      // Two products of the same three numbers.
      EXPECT_NEAR(made.distribution->covariance(k, 0),
                  p.deviation * made.found.parameters[0].prior.deviation * made.found.covariance(k, 0),
                  1e-15);
      EXPECT_EQ(static_cast<int>(parameters[i].kind), static_cast<int>(p.kind)) << p.name;
    }
  }
}

/// At the means, the arm that is simulated is the calibrated one, but for what the log does not tell.
TEST(UncertaintyYaml, AtItsMeansTheDrawnArmIsTheCalibratedOne) {
  for (const CommandKind kind : kKinds) {
    const MadeUp made(kind);
    Eigen::VectorXd values(static_cast<Eigen::Index>(made.found.parameters.size()));
    for (std::size_t i = 0; i < made.found.parameters.size(); ++i) {
      const FittedParameter& p = made.found.parameters[i];
      values[static_cast<Eigen::Index>(i)] = p.kept ? p.prior.nominal : p.value;
    }
    Scenario drawn = made.scenario;
    give_parameters(*made.distribution, values, drawn);
    const Chain arm = plant_model(drawn).chain;
    const Chain& expected = made.found.arm.model.chain;
    EXPECT_TRUE(arm.viscous_friction.isApprox(expected.viscous_friction));
    EXPECT_TRUE(arm.coulomb_friction.isApprox(expected.coulomb_friction));
    EXPECT_TRUE(arm.rotor_inertia.isApprox(expected.rotor_inertia));
    EXPECT_TRUE(arm.gravity.isApprox(expected.gravity));
    EXPECT_NEAR(arm.link[5].mass, expected.link[5].mass, 1e-12);
    EXPECT_TRUE(arm.link[5].first_moment.isApprox(expected.link[5].first_moment));
    EXPECT_TRUE(arm.link[5].inertia.isApprox(expected.link[5].inertia));
    EXPECT_TRUE(drawn.plant.encoder_offset.isApprox(made.found.arm.offset));
    EXPECT_EQ(drawn.plant.torque_delay_periods, std::lround(made.found.arm.delay / 0.002));
    if (kind == CommandKind::kTorque) continue;
    EXPECT_TRUE(drawn.robot->drive_velocity_gain.isApprox(made.found.arm.model.drive_velocity_gain));
    EXPECT_TRUE(drawn.robot->drive_velocity_integral.isApprox(made.found.arm.model.drive_velocity_integral));
    EXPECT_TRUE(drawn.robot->drive_position_gain.isApprox(made.found.arm.model.drive_position_gain));
  }
}

TEST(UncertaintyYaml, OfPositionCommandsSaysThatItsIntervalsAreTooNarrow) {
  EXPECT_EQ(MadeUp(CommandKind::kPosition).distribution->note, kNarrowIntervals);
  EXPECT_EQ(MadeUp(CommandKind::kTorque).distribution->note, "");
}

}  // namespace
}  // namespace armtune::internal::uncertainty_file_test
