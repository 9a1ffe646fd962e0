#pragma once
// Chooses the channels of a log that are the positions, velocities and torques of an arm, and its commands.

#include <optional>
#include <string>
#include <vector>

#include "tuner/validation/log_joints.hpp"
#include "tuner/validation/signal_groups.hpp"

namespace armtune::internal {

struct ChosenSignals {
  SignalGroup position;
  std::optional<SignalGroup> velocity, torque;  ///< of the same topic as the positions
  std::optional<SignalGroup> command;
  std::optional<SignalGroup> command_velocity;  ///< of a reference
  std::optional<CommandKind> kind;              ///< of the commands; none: there are none
  std::vector<std::string> notes;               ///< each a sentence without a full stop
};

/// Chooses the channels. Throws InputError as read_logged_joints() does about channels and commands.
ChosenSignals choose_signals(const RobotModel& model, const LogSummary& summary,
                             const LoggedJointsOptions& options);

}  // namespace armtune::internal
