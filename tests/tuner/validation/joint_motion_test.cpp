#include "tuner/validation/joint_motion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/core/support/refused_at.hpp"
#include "tests/tuner/validation/validation_rig.hpp"

namespace armtune::internal {
namespace joint_motion_test {

using test::input_error;
using test::recorded;
using test::Recording;

class LoggedMotionOfAnArm : public ::testing::Test {
 protected:
  RobotModel model_ = test::validation_arm("ur5e");

  /// Largest errors of q, q' and q'' against the motion itself.
  Vec3 errors(const LoggedMotion& motion, unsigned seed) const {
    const test::SmoothMotion truth(model_, seed);
    Vec3 worst = Vec3::Zero();
    JointVector q, qd, qdd;
    for (const MotionStretch& stretch : motion.stretches) {
      for (std::size_t i = 0; i < stretch.instants.size(); ++i) {
        truth.at(stretch.begin + static_cast<double>(i) * stretch.period, q, qd, qdd);
        const FilteredMotion& at = stretch.instants[i];
        worst = worst.cwiseMax(Vec3((at.q - q).cwiseAbs().maxCoeff(), (at.qd - qd).cwiseAbs().maxCoeff(),
                                    (at.qdd - qdd).cwiseAbs().maxCoeff()));
      }
    }
    return worst;
  }
};

TEST_F(LoggedMotionOfAnArm, IsThatWhichWasLoggedWithoutDelay) {
  // The filter passes half of its cutoff of 20 Hz within 1e-4; the motion has at most 0.6 Hz.
  for (const bool velocities : {false, true}) {
    Recording how;
    how.position_noise = how.velocity_noise = 0.0;
    how.velocities = velocities;
    const Vec3 worst = errors(joint_motion(model_, recorded(model_, model_.chain, how)), how.seed);
    EXPECT_LT(worst[0], 1e-4);
    EXPECT_LT(worst[1], 1e-3);
    EXPECT_LT(worst[2], 1e-2);
  }
}

TEST_F(LoggedMotionOfAnArm, IsRightWithUnevenTimes) {
  Recording how;
  how.position_noise = how.velocity_noise = 0.0;
  JointLog log = recorded(model_, model_.chain, how);
  const test::SmoothMotion truth(model_, how.seed);
  std::mt19937 generator(5);
  JointVector q, qd, qdd;
  for (Eigen::Index i = 0; i < log.samples(); ++i) {
    double& t = log.time[static_cast<std::size_t>(i)];
    t += test::random_number(generator, -0.3, 0.3) / how.rate;
    truth.at(t, q, qd, qdd);
    log.q.row(i) = q;
    log.qd.row(i) = qd;
  }
  const Vec3 worst = errors(joint_motion(model_, log), how.seed);
  EXPECT_LT(worst[0], 1e-4);
  EXPECT_LT(worst[2], 2e-2);
}

TEST_F(LoggedMotionOfAnArm, UsesVelocitiesThatAreTheDerivativesOfThePositions) {
  const LoggedMotion good = joint_motion(model_, recorded(model_, model_.chain));
  for (const VelocityAgreement& joint : good.velocities) {
    EXPECT_TRUE(joint.compared && joint.used);
    EXPECT_NEAR(joint.slope, 1.0, 0.01);
    EXPECT_NEAR(joint.lag, 0.0, 1e-3);
  }
  JointLog log = recorded(model_, model_.chain);
  log.qd.col(2) *= 1.3;
  const LoggedMotion scaled = joint_motion(model_, log);
  EXPECT_FALSE(scaled.velocities[2].used);
  EXPECT_NEAR(scaled.velocities[2].slope, 1.3, 0.01);
  EXPECT_LT(errors(scaled, 1)[1], 1e-2) << "the derivative of the position is used instead";
}

TEST_F(LoggedMotionOfAnArm, HasNoInstantAcrossAGapOrAJump) {
  JointLog log = recorded(model_, model_.chain);
  for (std::size_t i = 2500; i < log.time.size(); ++i) log.time[i] += 1.0;
  EXPECT_EQ(joint_motion(model_, log).stretches.size(), 2U);
  JointLog jumping = recorded(model_, model_.chain);
  jumping.q.col(1).tail(2000).array() += 0.5;
  const LoggedMotion motion = joint_motion(model_, jumping);
  ASSERT_EQ(motion.jumps.size(), 1U);
  EXPECT_EQ(motion.jumps[0].joint, 1);
  EXPECT_NEAR(motion.jumps[0].size, 0.5, 0.02);
  EXPECT_NEAR(motion.jumps[0].time, 12.0, 1e-9);
  ASSERT_EQ(motion.stretches.size(), 2U);
  EXPECT_LT(motion.stretches[0].begin +
                static_cast<double>(motion.stretches[0].instants.size()) * motion.stretches[0].period,
            12.0);
}

TEST_F(LoggedMotionOfAnArm, RefusesMalformedLogs) {
  const JointLog good = recorded(model_, model_.chain);
  const auto key = [&](auto&& change) {
    JointLog log = good;
    change(log);
    return input_error([&] { return joint_motion(model_, log); }).place().key;
  };
  EXPECT_EQ(key([](JointLog& log) { log.q(7, 2) = std::numeric_limits<double>::quiet_NaN(); }), "position");
  EXPECT_EQ(key([](JointLog& log) { log.torque.conservativeResize(10, 6); }), "torque");
  EXPECT_EQ(key([](JointLog& log) { log.qd.conservativeResize(Eigen::NoChange, 5); }), "velocity");
  EXPECT_EQ(key([](JointLog& log) { log.time[9] = -1.0; }), "time");
  EXPECT_EQ(key([](JointLog& log) { std::fill(log.time.begin(), log.time.end(), 3.0); }), "time");
  EXPECT_EQ(key([](JointLog& log) { log.time.resize(5); }), "time");
  EXPECT_EQ(key([](JointLog& log) { log.time.back() = std::numeric_limits<double>::infinity(); }), "time");
  Recording brief;
  brief.duration = 1.0;
  EXPECT_EQ(
      input_error([&] { return joint_motion(model_, recorded(model_, model_.chain, brief)); }).place().key,
      "time");
}

}  // namespace joint_motion_test
}  // namespace armtune::internal
