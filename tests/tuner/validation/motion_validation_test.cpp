#include "tuner/validation/motion_validation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/laws/controller.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/robot/theta.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/tuner/validation/motion_rig.hpp"

namespace armtune::internal {
namespace motion_validation_test {

using test::CommandedLog;
using test::input_error;
using test::kLogPeriod;
using test::kPlantSteps;
using test::moved_by_drives;
using test::moved_by_torques;

CommandedLog recorded_under(CommandKind kind, const RobotModel& model, const RobotModel& arm,
                            double duration = 20.0) {
  return kind == CommandKind::kTorque ? moved_by_torques(model, arm, duration)
                                      : moved_by_drives(model, arm, kind, duration);
}

MotionValidation validated(const RobotModel& model, const CommandedLog& recorded) {
  return validate_motion(model, recorded.log, recorded.commands);
}

double rms_at(const MotionValidation& found, double horizon, int joint) {
  return found.joint[static_cast<std::size_t>(joint)].rms[found.index_of(horizon)];
}

class MotionUnder : public ::testing::TestWithParam<CommandKind> {
 protected:
  RobotModel model_ = test::validation_arm("ur5e");
};

/// From an exact state, the simulation repeats the recorded steps. Only rounding of the times differs.
TEST_P(MotionUnder, CommandsOfTheSameArmIsRepeated) {
  const CommandedLog recorded = recorded_under(GetParam(), model_, model_, 4.1);
  const std::unique_ptr<Plant> plant = make_native_plant(model_, Stepper::kMidpoint);
  MotionStretch stretch{0.0, kLogPeriod, kLogPeriod, {}};
  for (Eigen::Index i = 0; i < recorded.log.samples(); ++i) {
    FilteredMotion at;
    at.q = recorded.log.q.row(i).transpose();
    at.qd = recorded.log.qd.row(i).transpose();
    plant->accelerations(at.q, at.qd, recorded.first_torque[static_cast<std::size_t>(i)], at.qdd);
    stretch.instants.push_back(at);
  }
  const WindowRun run = WindowSimulator(model_, recorded.commands).run(stretch, {0, 500, 2.0});
  ASSERT_EQ(run.time.size(), 101U);
  EXPECT_EQ(run.failed_at, -1.0);
  // The servo has forgotten its start 1.5 s before to 1e-10.
  EXPECT_LT((run.simulated - run.measured).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_GT((run.measured.row(100) - run.measured.row(0)).cwiseAbs().maxCoeff(), 0.05) << "the arm moves";
}

TEST_P(MotionUnder, CommandsOfTheSameArmMatches) {
  const MotionValidation found = validated(model_, recorded_under(GetParam(), model_, model_));
  EXPECT_TRUE(found.model_matches());
  EXPECT_EQ(found.failed, 0);
  EXPECT_GT(found.windows.size(), 15U);
  ASSERT_EQ(found.horizons.size(), 101U);
  for (const HorizonCurve& joint : found.joint) {
    // The first filter changes the start by about 1e-4 rad and 1e-3 rad/s where friction turns.
    EXPECT_LT(joint.rms[0], 1e-12) << "no error without a horizon";
    EXPECT_EQ(joint.stays[0], 0.0);
    EXPECT_LT(joint.rms[found.index_of(1.0)], 0.03 * joint.yardstick(found.index_of(1.0)));
    EXPECT_LE(joint.low.back(), joint.rms.back());
    EXPECT_GE(joint.high.back(), joint.rms.back());
  }
}

TEST_P(MotionUnder, CommandsMatchesWithTheNoiseOfSensors) {
  CommandedLog recorded = recorded_under(GetParam(), model_, model_);
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  for (double& q : recorded.log.q.reshaped()) q += 2e-5 * normal(generator);
  for (double& qd : recorded.log.qd.reshaped()) qd += 2e-3 * normal(generator);
  const MotionValidation found = validated(model_, recorded);
  EXPECT_TRUE(found.model_matches());
}

TEST_P(MotionUnder, CommandsNeedsNoVelocities) {
  CommandedLog recorded = recorded_under(GetParam(), model_, model_);
  recorded.log.qd.resize(0, 0);
  EXPECT_TRUE(validated(model_, recorded).model_matches());
}

INSTANTIATE_TEST_SUITE_P(Kinds, MotionUnder,
                         ::testing::Values(CommandKind::kTorque, CommandKind::kVelocity,
                                           CommandKind::kPosition),
                         [](const auto& kind) { return std::string(name(kind.param)); });

/// An arm with more friction than the model: under the same torques the simulated joint moves further.
TEST(MotionUnderTorques, NamesTheJointWithOtherFriction) {
  const RobotModel model = test::validation_arm("ur5e");
  const MotionValidation same = validated(model, moved_by_torques(model, model));
  for (const int joint : {0, 2, 4}) {
    for (const double factor : {1.2, 0.8}) {
      RobotModel arm = model;
      arm.chain.coulomb_friction[joint] *= factor;
      arm.chain.viscous_friction[joint] *= factor;
      const MotionValidation found = validated(model, moved_by_torques(model, arm));
      EXPECT_EQ(found.worst_joint(), joint) << factor;
      EXPECT_GT(rms_at(found, 0.1, joint), 3.0 * rms_at(same, 0.1, joint)) << factor;
      EXPECT_GT(rms_at(found, 0.5, joint), 2.0 * rms_at(found, 0.1, joint)) << "errors grow";
      const HorizonCurve& curve = found.joint[static_cast<std::size_t>(joint)];
      EXPECT_GT(curve.slope[found.index_of(0.1)] * (factor - 1.0), 0.0) << factor;
      EXPECT_THAT(sentences(found, model).front(),
                  testing::HasSubstr(model.joints[static_cast<std::size_t>(joint)].name));
    }
  }
}

TEST(MotionUnderTorques, AnArmWithAnotherPayloadDoesNotMatch) {
  const RobotModel model = test::validation_arm("ur5e");
  const RobotModel loaded = with_payload(model, {3.0, Vec3(0.0, 0.05, 0.1)});
  const MotionValidation found = validated(model, moved_by_torques(model, loaded));
  EXPECT_FALSE(found.model_matches());
  // Its weight loads the shoulder and the elbow.
  for (const int j : {1, 2}) {
    EXPECT_GT(found.excess[static_cast<std::size_t>(j)], 1.0) << j;
    EXPECT_GT(rms_at(found, 0.5, j), 3.0 * rms_at(found, 0.1, j)) << "errors grow";
  }
  EXPECT_DOUBLE_EQ(found.judged, ValidationThresholds{}.torque_horizon);
}

/// The arm moves later than its commands say, so the simulation is ahead by velocity times delay.
TEST(MotionUnderPositions, ADelayShowsAsTheDistanceMovedInIt) {
  constexpr double kDelay = 0.04;
  const RobotModel model = test::validation_arm("ur5e");
  CommandedLog recorded = moved_by_drives(model, model, CommandKind::kPosition);
  for (double& t : recorded.commands.time) t -= kDelay;
  const MotionValidation found = validated(model, recorded);
  EXPECT_FALSE(found.model_matches());
  EXPECT_DOUBLE_EQ(found.judged, ValidationThresholds{}.drive_horizon);
  for (int j = 0; j < model.n(); ++j) {
    const double speed = std::sqrt(recorded.log.qd.col(j).squaredNorm() / double(recorded.log.samples()));
    // Windows see another part of the motion than the whole log.
    EXPECT_NEAR(rms_at(found, 1.0, j) / (kDelay * speed), 1.0, 0.35) << j;
    EXPECT_LT(rms_at(found, 0.1, j), rms_at(found, 1.0, j)) << "the simulated arm starts where the log is";
  }
}

TEST(MotionUnderPositions, ReachTheDrivesInOneCycleWithoutAServo) {
  const RobotModel model = test::validation_arm("ur5e");
  CommandedLog recorded = moved_by_drives(model, model, CommandKind::kPosition);
  recorded.commands.servo.reset();
  const MotionValidation found = validated(model, recorded);
  // The servo that the model lacks lags by its look-ahead time.
  for (int j = 0; j < model.n(); ++j) {
    const double speed = std::sqrt(recorded.log.qd.col(j).squaredNorm() / double(recorded.log.samples()));
    EXPECT_NEAR(rms_at(found, 1.0, j) / (test::kLogServo.lookahead_time * speed), 1.0, 0.35) << j;
  }
}

TEST(MotionUnderTorques, CanLeaveTheWeightToTheRobot) {
  const RobotModel model = test::validation_arm("panda");
  CommandedLog recorded = moved_by_torques(model, model, 6.0);
  JointVector weight;
  for (Eigen::Index i = 0; i < recorded.log.samples(); ++i) {
    gravity_torque(model.chain, test::poses_at(model.chain, recorded.log.q.row(i).transpose()), weight);
    recorded.commands.value.row(i) -= weight.transpose();
  }
  const MotionValidation falling = validated(model, recorded);
  recorded.commands.robot_adds_weight = true;
  const MotionValidation held = validated(model, recorded);
  // The robot adds the weight in every step, while the log had it in every sample.
  for (const int j : {1, 3}) EXPECT_LT(rms_at(held, 0.5, j), 0.01 * rms_at(falling, 0.5, j)) << j;
  EXPECT_TRUE(held.model_matches());
  EXPECT_FALSE(falling.model_matches());
}

/// ROS's joint_trajectory_controller with effort commands, without integrals, on an arm that holds its
/// weight.
class MotionUnderAController : public ::testing::Test {
 protected:
  MotionUnderAController() {
    model_.compensates_gravity = true;
    gains_ = joint_motion_gains(kJointTrajectoryController, model_.n());
    jtc_gain(gains_, "p") = 3.0 * model_.effort_limits();
    jtc_gain(gains_, "d") = 0.3 * model_.effort_limits();
    jtc_gain(gains_, "i").setZero(model_.n());
  }

  CommandedLog recorded() {
    const test::SmoothMotion motion(model_, 1);
    CommandedLog out;
    MotionCommands reference;
    std::vector<MotionPoint<JointVector>> points;
    JointVector q, qd, qdd;
    for (int i = 0; i < 2500; ++i) {
      reference.time.push_back(i * kLogPeriod);
      motion.at(reference.time.back(), q, qd, qdd);
      points.push_back({q, qd, qdd});
    }
    const JointSpline plan(reference.time, points, PointsGive::kVelocities);
    Scene scene;
    scene.plan = &plan;
    scene.holds_plan = true;
    Controller controller(std::make_shared<RobotModel>(model_), gains_, theta_of(model_.chain), kLogPeriod);
    JointVector torque;
    out = test::record_motion(model_, motion, 10.0, CommandKind::kReference,
                              [&](Eigen::Index i, int k, const JointState& state, JointVector& command) {
                                command = points[static_cast<std::size_t>(i)].position;
                                const double time = static_cast<double>(i) * kLogPeriod;
                                if (k == 0) torque = controller.update(state, scene, time).torque;
                                return torque;
                              });
    out.commands.velocity.resize(out.log.samples(), model_.n());
    for (Eigen::Index i = 0; i < out.log.samples(); ++i)
      out.commands.velocity.row(i) = points[static_cast<std::size_t>(i)].velocity.transpose();
    out.commands.gains = gains_;
    return out;
  }

  RobotModel model_ = test::validation_arm("panda");
  Gains gains_;
};

TEST_F(MotionUnderAController, MatchesWithItsGainsAndNotWithOthers) {
  CommandedLog log = recorded();
  const MotionValidation same = validated(model_, log);
  EXPECT_TRUE(same.model_matches());
  jtc_gain(*log.commands.gains, "p") *= 0.3;
  jtc_gain(*log.commands.gains, "d") *= 0.3;
  const MotionValidation softer = validated(model_, log);
  for (int j = 0; j < model_.n(); ++j) {
    EXPECT_GT(rms_at(softer, 1.0, j), 5.0 * rms_at(same, 1.0, j)) << j;
  }
}

TEST(MotionValidation, CountsWindowsThatDivergeAndLimitsThatAreLeft) {
  RobotModel model = test::validation_arm("ur5e");
  const CommandedLog recorded = moved_by_torques(model, model, 6.0);
  const double path_end = recorded.log.q.col(3).maxCoeff();
  model.joints[3].limits.upper = path_end - 0.01;
  const MotionValidation outside = validated(model, recorded);
  EXPECT_GT(outside.at_limit, 0);
  long marked = 0;
  for (const MotionWindow& window : outside.windows) {
    marked += window.limit_joint == 3 ? 1 : 0;
    EXPECT_EQ(window.limit_joint >= 0, window.limit_at >= 0.0);
  }
  EXPECT_EQ(marked, outside.at_limit);
  EXPECT_TRUE(outside.model_matches()) << "a limit is only marked";

  for (JointInfo& joint : model.joints) joint.limits.velocity = 1e-4;  // 20 times as much counts as diverged
  const MotionValidation diverged = validated(model, recorded);
  EXPECT_EQ(diverged.failed, static_cast<long>(diverged.windows.size()));
  EXPECT_FALSE(diverged.model_matches());
  EXPECT_EQ(diverged.count.back(), 0);
}

TEST(MotionValidation, KeepsExamplesFromTheWorstToTheBest) {
  const RobotModel model = test::validation_arm("ur5e");
  RobotModel arm = model;
  arm.chain.coulomb_friction *= 1.3;
  const MotionValidation found = validated(model, moved_by_torques(model, arm));
  ASSERT_EQ(found.examples.size(), 3U);
  const auto row = static_cast<Eigen::Index>(found.index_of(found.judged));
  const auto size = [&](const MotionExample& example) {
    return (example.simulated - example.measured).row(row).cwiseAbs().maxCoeff();
  };
  EXPECT_GT(size(found.examples.front()), size(found.examples.back()));
  for (const MotionExample& example : found.examples) {
    EXPECT_EQ(example.time.front(), found.windows[example.window].begin);
    EXPECT_EQ(static_cast<Eigen::Index>(example.time.size()), example.measured.rows());
  }
}

TEST(MotionValidation, RefusesMalformedCommands) {
  const RobotModel model = test::validation_arm("ur5e");
  const CommandedLog good = moved_by_torques(model, model, 3.0);
  const auto key = [&](auto&& change) {
    MotionCommands commands = good.commands;
    change(commands);
    return input_error([&] { return validate_motion(model, good.log, commands); }).place().key;
  };
  EXPECT_EQ(key([](MotionCommands& x) { x.value(3, 1) = std::nan(""); }), "torque command");
  EXPECT_EQ(key([](MotionCommands& x) { x.value.conservativeResize(Eigen::NoChange, 5); }), "torque command");
  EXPECT_EQ(key([](MotionCommands& x) { x.time[5] = x.time[4]; }), "command time");
  EXPECT_EQ(key([](MotionCommands& x) { x.time.resize(1); }), "command time");
  EXPECT_EQ(key([](MotionCommands& x) {
              for (double& t : x.time) t += 1000.0;
            }),
            "command time");
  EXPECT_EQ(key([](MotionCommands& x) { x.kind = CommandKind::kReference; }), "gains");
  EXPECT_EQ(key([](MotionCommands& x) { x.velocity = Eigen::MatrixXd::Zero(2, 2); }), "reference velocity");
}

}  // namespace motion_validation_test
}  // namespace armtune::internal
