#include "tuner/calibration/shooting.hpp"

#include <gtest/gtest.h>

#include "sim/scenario/robot_file.hpp"
#include "tests/tuner/calibration/hidden_arm.hpp"

namespace armtune::internal::shooting_test {
namespace {

using test::HiddenArm;
using test::HiddenRecording;

class ShootingOf : public testing::TestWithParam<CommandKind> {};

/// A log without noise and losses, of the hidden arm itself.
CommandedLog exact_log(const HiddenArm& arm, CommandKind kind) {
  HiddenRecording how;
  how.kind = kind;
  how.duration = 4.0;
  how.position_noise = 0.0;
  how.velocity_noise = 0.0;
  how.lost = 0.0;
  return test::record(arm, how);
}

TEST_P(ShootingOf, TheArmItselfRepeatsItsLog) {
  const HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 4);
  const CommandedLog made = exact_log(arm, GetParam());
  const Eigen::VectorXd noise = Eigen::VectorXd::Constant(arm.model.n(), 1e-6);
  WindowModel model(arm.model, arm.truth, made.commands, {}, start_deviations(arm.model, noise));
  const CommandSignal signal(made.commands);
  ShotWindow window = model.window(made.log, signal, {500, 500}, {}, false);
  fit_start(model, window, 500, noise, {});
  // The state at the start is fitted; what remains is rounding, and the servo's state a second before the
  // window.
  EXPECT_LT(model.residual(window, {}).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_P(ShootingOf, LanesDoNotDependOnTheirNeighbours) {
  const HiddenArm arm = test::hidden_arm(*load_robot("ur5e"), 5);
  const CommandedLog made = exact_log(arm, GetParam());
  const ShootingArm other = shooting_arm(arm.model);
  Shooting shooting(arm.model, made.commands);
  const CommandSignal signal(made.commands);
  const LogWindow window{300, 100};
  const StepCommands commands = shooting.step_commands(signal, made.log, window, arm.truth.delay);
  const StartState start = logged_start(made.log, window, arm.truth, GetParam(), commands, false);
  const Shot one{&arm.truth, &start, &commands};
  const Shot two{&other, &start, &commands};
  const std::vector<Shot> mixed{two, one, two, two, one, two, two, two, one};
  const Eigen::MatrixXd alone = shooting.simulate(made.log, window, {&one, 1});
  const Eigen::MatrixXd together = shooting.simulate(made.log, window, mixed);
  for (const Eigen::Index i : {1, 4, 8}) EXPECT_EQ(together.col(i), alone.col(0)) << i;
  EXPECT_NE(together.col(0), alone.col(0));
}

INSTANTIATE_TEST_SUITE_P(Commands, ShootingOf,
                         testing::Values(CommandKind::kTorque, CommandKind::kVelocity,
                                         CommandKind::kPosition),
                         [](const auto& kind) { return std::string(name(kind.param)); });

}  // namespace
}  // namespace armtune::internal::shooting_test
