#include "tuner/validation/log_joints.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"
#include "tests/tuner/validation/written_log.hpp"

namespace armtune::internal {
namespace log_joints_test {

using test::input_error;
using test::refused_at;
using test::WrittenLog;

class JointsOfALog : public ::testing::Test {
 protected:
  RobotModel model_ = test::validation_arm("ur5e");
  test::TemporaryFolder files_;
  JointLog log_ = [this] {
    test::Recording how;
    how.duration = 4.0;
    how.rate = 100.0;
    return test::recorded(model_, model_.chain, how);
  }();

  LoggedJoints read(const std::string& text, const LoggedJointsOptions& options = {}) const {
    return read_logged_joints(model_, {files_.write("log.csv", text)}, options);
  }
  void expect_same(const LoggedJoints& found) const {
    ASSERT_EQ(found.log.samples(), log_.samples());
    EXPECT_TRUE(found.log.q.isApprox(log_.q, 1e-12));
    EXPECT_TRUE(found.log.qd.isApprox(log_.qd, 1e-12));
    EXPECT_TRUE(found.log.torque.isApprox(log_.torque, 1e-12));
  }
};

TEST_F(JointsOfALog, AreFoundByNameByNumberAndInDegrees) {
  const double degrees = 180.0 / M_PI;
  const std::vector<WrittenLog> ways = {
      {}, {.names = false}, {.angle = degrees, .unit = " [deg]"}, {.before = "arm_", .names = false}};
  for (const WrittenLog& way : ways) {
    const LoggedJoints found = read(test::log_text(model_, log_, way));
    expect_same(found);
    EXPECT_FALSE(found.commands);
    EXPECT_FALSE(found.notes.empty());
  }
}

TEST_F(JointsOfALog, BelongToTheJointsOfTheirNamesInAnyOrder) {
  RobotModel other = model_;
  std::swap(other.joints[0], other.joints[4]);
  const LoggedJoints found =
      read_logged_joints(other, {files_.write("log.csv", test::log_text(model_, log_))}, {});
  EXPECT_TRUE(found.log.q.col(0).isApprox(log_.q.col(4), 1e-12));
  EXPECT_TRUE(found.log.torque.col(4).isApprox(log_.torque.col(0), 1e-12));
}

TEST_F(JointsOfALog, AreMatchedByTheEndsOfTheirNames) {
  RobotModel panda = test::validation_arm("panda");
  test::Recording how;
  how.duration = 4.0;
  const JointLog log = test::recorded(panda, panda.chain, how);
  RobotModel fer = panda;
  for (JointInfo& joint : fer.joints) joint.name.replace(0, 5, "fer");
  const std::string path = files_.write("log.csv", test::log_text(fer, log));
  EXPECT_TRUE(read_logged_joints(panda, {path}, {}).log.q.isApprox(log.q, 1e-12));
}

TEST_F(JointsOfALog, OfAnotherArmAreRefusedWithWhatTheLogHas) {
  const RobotModel panda = test::validation_arm("panda");
  const std::string path = files_.write("log.csv", test::log_text(model_, log_));
  const InputError error = input_error([&] { return read_logged_joints(panda, {path}, {}); });
  EXPECT_THAT(error, refused_at({.file = path, .key = "position"}));
  EXPECT_THAT(error.what(),
              testing::AllOf(testing::HasSubstr("elbow_joint"), testing::HasSubstr("--columns")));
}

TEST_F(JointsOfALog, LeaveOutRowsThatLackANumber) {
  std::istringstream lines(test::log_text(model_, log_));
  std::string text, line;
  for (long row = 0; std::getline(lines, line); ++row) {
    if (row == 50)
      line.replace(line.find(',') + 1, line.find(',', line.find(',') + 1) - line.find(',') - 1, "");
    text += line + "\n";
  }
  const LoggedJoints found = read(text);
  EXPECT_EQ(found.log.samples(), log_.samples() - 1);
  EXPECT_TRUE(found.log.q.allFinite());
}

TEST_F(JointsOfALog, WithoutTorquesOrWithCommandsSaySo) {
  const LoggedJoints bare = read(test::log_text(model_, log_, {.torques = false}));
  EXPECT_FALSE(bare.log.has_torques());
  EXPECT_TRUE(bare.log.has_velocities());
  const std::string commanded = test::log_text(model_, log_, {.torques = false, .commands = true});
  const LoggedJoints found = read(commanded);
  ASSERT_TRUE(found.commands);
  EXPECT_EQ(found.commands->kind, CommandKind::kPosition);
  EXPECT_TRUE(found.commands->value.isApprox(log_.q, 1e-12));
  EXPECT_FALSE(read(commanded, {.commands = false}).commands);
  EXPECT_THAT(input_error([&] { return read(commanded, {.command = CommandKind::kVelocity}); }),
              refused_at({.key = "--commands", .value = "velocity"}));
}

TEST_F(JointsOfALog, UseMeasuredTorquesAsCommandsIfAsked) {
  const LoggedJoints found = read(test::log_text(model_, log_), {.command = CommandKind::kTorque});
  ASSERT_TRUE(found.commands);
  EXPECT_EQ(found.commands->kind, CommandKind::kTorque);
  EXPECT_TRUE(found.commands->value.isApprox(log_.torque, 1e-12));
}

TEST_F(JointsOfALog, AreThoseOfAColumnMapWithItsScales) {
  LogColumns columns = default_log_columns(model_);
  for (LogColumn& column : columns.torque) column.scale = 0.002;
  columns.torque[2].scale = -0.004;
  const LoggedJoints found = read(test::log_text(model_, log_), {.columns = columns});
  EXPECT_TRUE(found.log.torque.col(0).isApprox(0.002 * log_.torque.col(0), 1e-12));
  EXPECT_TRUE(found.log.torque.col(2).isApprox(-0.004 * log_.torque.col(2), 1e-12));
  columns.position[1].name = "joint/elbow_joint/positio";
  const InputError error =
      input_error([&] { return read(test::log_text(model_, log_), {.columns = columns}); });
  EXPECT_THAT(error, refused_at({.key = "joint/elbow_joint/positio"}));
  EXPECT_EQ(test::suggested_by(error), "joint/elbow_joint/position");
}

}  // namespace log_joints_test
}  // namespace armtune::internal
