#include "tuner/validation/torque_residuals.hpp"

#include <gtest/gtest.h>

#include "core/robot/slotine_li.hpp"
#include "tests/tuner/validation/validation_rig.hpp"

namespace armtune::internal {
namespace torque_residuals_test {

using test::recorded;
using test::Recording;

TorqueRows rows_of(const RobotModel& model, const JointLog& log) {
  return torque_rows(model, joint_motion(model, log));
}

TEST(TorqueResiduals, AModelThatIsRightExplainsAllTorque) {
  for (const char* name : {"ur5e", "panda"}) {
    const RobotModel model = test::validation_arm(name);
    Recording how;
    how.torque_noise = how.position_noise = how.velocity_noise = 0.0;
    const TorqueResiduals found = torque_residuals(rows_of(model, recorded(model, model.chain, how)));
    // Friction turns within milliseconds at a reversal; the first filter of 20 Hz smooths q' but not
    // friction.
    for (const JointResidual& joint : found.joint) {
      EXPECT_GT(joint.explained, 0.999) << name;
      EXPECT_LT(joint.rms, 0.02 * joint.torque_rms) << name;
      EXPECT_NEAR(joint.predicted_rms, joint.torque_rms, 0.01 * joint.torque_rms) << name;
    }
    for (const bool match : matching_joints(model, found)) EXPECT_TRUE(match) << name;
  }
}

TEST(TorqueResiduals, AreMeasuredMinusPredictedTorque) {
  const RobotModel model = test::validation_arm("ur5e");
  JointLog log = recorded(model, model.chain);
  log.torque.col(3).array() += 5.0;
  const TorqueRows rows = rows_of(model, log);
  const TorqueResiduals found = torque_residuals(rows);
  for (std::size_t j = 0; j < found.joint.size(); ++j) {
    const Eigen::VectorXd tau = rows.joint[j].col(kMeasuredTorque);
    const Eigen::VectorXd r = tau - rows.joint[j].col(kPredictedTorque);
    EXPECT_NEAR(found.joint[j].rms, std::sqrt(r.squaredNorm() / double(r.size())), 1e-6);
    const double explained =
        1.0 - (r.array() - r.mean()).square().sum() / (tau.array() - tau.mean()).square().sum();
    EXPECT_NEAR(found.joint[j].explained, explained, 1e-6);
  }
  EXPECT_NEAR(found.joint[3].rms, 5.0, 0.1);
  EXPECT_GT(found.joint[3].explained, 0.9) << "an offset is no variance";
}

TEST(TorqueResiduals, CoulombFrictionShowsAtReversals) {
  const RobotModel model = test::validation_arm("ur5e");
  Chain arm = model.chain;
  arm.coulomb_friction[4] += 2.0;
  arm.coulomb_friction[1] -= 1.5;
  const TorqueResiduals found = torque_residuals(rows_of(model, recorded(model, arm)));
  ASSERT_GT(found.joint[4].reversals.count, 3);
  EXPECT_NEAR(found.joint[4].reversals.half_step, 2.0, 0.3);
  EXPECT_NEAR(found.joint[1].reversals.half_step, -1.5, 0.3);
  EXPECT_NEAR(found.joint[2].reversals.half_step, 0.0, 0.2);
}

TEST(TorqueResiduals, RotorInertiaShowsWithTheAcceleration) {
  const RobotModel model = test::validation_arm("ur5e");
  Chain arm = model.chain;
  arm.rotor_inertia[0] += 2.0;
  const TorqueResiduals found = torque_residuals(rows_of(model, recorded(model, arm)));
  EXPECT_GT(found.joint[0].inertia.correlation, 0.95);
  EXPECT_NEAR(found.joint[0].inertia.slope, 2.0, 0.1);
  EXPECT_LT(std::abs(found.joint[5].inertia.slope), 0.1);
}

TEST(TorqueResiduals, GravityIsComparedWhereAllJointsAreSlow) {
  const RobotModel model = test::validation_arm("ur5e");
  const JointLog log = recorded(model, model.chain);
  ValidationThresholds none;
  none.slow = 0.0;
  ValidationThresholds all;
  all.slow = 100.0;
  const TorqueRows rows = rows_of(model, log);
  EXPECT_EQ(torque_residuals(rows, none).joint[0].gravity.rows, 0);
  const JointResidual joint = torque_residuals(rows, all).joint[1];
  EXPECT_EQ(joint.gravity.rows, rows.count());
  EXPECT_NEAR(joint.gravity.rms, joint.rms, 1e-6);
}

/// The columns are derivatives of the torque by what the robot file may have wrong.
TEST(TorqueColumns, AreWhatTheTorqueChangesBy) {
  const RobotModel model = test::validation_arm("panda");
  std::mt19937 generator(3);
  FilteredMotion at;
  at.q = test::random_configuration(generator, model);
  at.qd = test::random_vector(generator, model.n(), 1.0);
  at.qdd = test::random_vector(generator, model.n(), 3.0);
  at.torque = JointVector::Zero(model.n());
  const Eigen::MatrixXd columns = torque_columns(model, at);
  const auto change = [&](auto&& alter) {
    RobotModel other = model;
    alter(other.chain);
    return Eigen::VectorXd(torque_columns(other, at).col(kPredictedTorque) - columns.col(kPredictedTorque));
  };
  const auto last = static_cast<std::size_t>(model.n() - 1);
  // The torque is linear in each of these, so unit changes are exact but for rounding.
  const auto same = [&](TorqueColumn column, const Eigen::VectorXd& expected) {
    EXPECT_LT((columns.col(column) - expected).norm(), 1e-9 * (1.0 + expected.norm())) << column;
  };
  same(kPayloadMass, change([&](Chain& c) { c.link[last].mass += 1.0; }));
  same(kPayloadMomentX, change([&](Chain& c) { c.link[last].first_moment.x() += 1.0; }));
  same(kPayloadMomentZ, change([&](Chain& c) { c.link[last].first_moment.z() += 1.0; }));
  same(kGravityX, change([](Chain& c) { c.gravity.x() += 1.0; }));
  same(kGravityZ, change([](Chain& c) { c.gravity.z() += 1.0; }));
  same(kCoulombDirection, change([](Chain& c) { c.coulomb_friction.array() += 1.0; }));
  same(kJointVelocity, change([](Chain& c) { c.viscous_friction.array() += 1.0; }));
  same(kJointAcceleration, change([](Chain& c) { c.rotor_inertia.array() += 1.0; }));
}

}  // namespace torque_residuals_test
}  // namespace armtune::internal
