#pragma once
// Writes logs of hidden arms as CSV files.

#include <fmt/format.h>

#include <string>

#include "tests/tuner/calibration/hidden_arm.hpp"

namespace armtune::internal::test {

/// Returns the positions and commands of a log, with the columns joint/NAME/position and
/// joint/NAME/KIND_command.
inline std::string hidden_log_text(const RobotModel& model, const internal::CommandedLog& made,
                                   bool with_commands = true) {
  std::string text = "time";
  for (const JointInfo& joint : model.joints) text += fmt::format(",joint/{}/position", joint.name);
  for (const JointInfo& joint : model.joints) {
    if (with_commands) text += fmt::format(",joint/{}/{}_command", joint.name, name(made.commands.kind));
  }
  text += '\n';
  for (Eigen::Index i = 0; i < made.log.samples(); ++i) {
    text += fmt::format("{}", made.log.time[static_cast<std::size_t>(i)]);
    for (Eigen::Index j = 0; j < model.n(); ++j) text += fmt::format(",{}", made.log.q(i, j));
    for (Eigen::Index j = 0; j < model.n() && with_commands; ++j)
      text += fmt::format(",{}", made.commands.value(i, j));
    text += '\n';
  }
  return text;
}

/// Records a few seconds of an arm under torque commands at a low rate, so that a test takes seconds.
inline internal::CommandedLog short_torque_log(const HiddenArm& arm, double duration, double rate = 125.0) {
  HiddenRecording how;
  how.rate = rate;
  how.duration = duration;
  how.seed = 12;
  return record(arm, how);
}

}  // namespace armtune::internal::test
