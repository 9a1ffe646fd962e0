#include "tuner/calibration/command_signal.hpp"

#include <gtest/gtest.h>

namespace armtune::internal::command_signal_test {
namespace {

MotionCommands stairs() {
  MotionCommands commands;
  commands.value.resize(50, 1);
  for (int i = 0; i < 50; ++i) {
    commands.time.push_back(0.01 * i);
    commands.value(i, 0) = i % 7 - 0.1 * i;
  }
  return commands;
}

TEST(CommandSignal, HoldsEachCommandUntilTheNext) {
  const MotionCommands commands = stairs();
  const Eigen::MatrixXd means = CommandSignal(commands).means(0.1, 0.005, 20, 0.0);
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(means(i, 0), commands.value(10 + i / 2, 0), 1e-9) << i;
}

TEST(CommandSignal, ADelayOfAWholeNumberOfCommandsShiftsThem) {
  const CommandSignal signal(stairs());
  const Eigen::MatrixXd late = signal.means(0.2, 0.01, 10, 0.05);
  const Eigen::MatrixXd early = signal.means(0.15, 0.01, 10, 0.0);
  EXPECT_LT((late - early).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CommandSignal, BetweenTwoWholeDelaysTheMeansAreLinear) {
  const CommandSignal signal(stairs());
  const Eigen::MatrixXd none = signal.means(0.2, 0.01, 10, 0.0);
  const Eigen::MatrixXd half = signal.means(0.2, 0.01, 10, 0.005);
  const Eigen::MatrixXd whole = signal.means(0.2, 0.01, 10, 0.01);
  EXPECT_LT((half - 0.5 * (none + whole)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CommandSignal, BeforeTheFirstCommandTheFirstOneActs) {
  const MotionCommands commands = stairs();
  const Eigen::MatrixXd means = CommandSignal(commands).means(-0.1, 0.01, 5, 0.0);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(means(i, 0), commands.value(0, 0), 1e-9);
}

TEST(CommandSignal, InterpolatesALostCommand) {
  MotionCommands commands = stairs();
  const double between = 0.5 * (commands.value(19, 0) + commands.value(21, 0));
  commands.time.erase(commands.time.begin() + 20);
  Eigen::MatrixXd rest(49, 1);
  rest << commands.value.topRows(20), commands.value.bottomRows(29);
  commands.value = rest;
  EXPECT_NEAR(CommandSignal(commands).means(0.2, 0.01, 1, 0.0)(0, 0), between, 1e-9);
}

}  // namespace
}  // namespace armtune::internal::command_signal_test
