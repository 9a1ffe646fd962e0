#pragma once
// Makes a JointLog, and the commands that moved the arm, of what a robot recorded. Channels are chosen by
// what they look like (log_meaning.hpp) and belong to joints by their names (joint_channels.hpp), or a column
// map names them:
//
//     const LoggedJoints logged = read_logged_joints(*load_robot("ur10"), {"run.mcap"}, {});
//     validate_torques(*load_robot("ur10"), logged.log);

#include <optional>
#include <string>
#include <vector>

#include "sim/logs/log_selection.hpp"
#include "tuner/identification/log_columns.hpp"
#include "tuner/validation/motion_commands.hpp"

namespace armtune::internal {

struct LoggedJointsOptions {
  LogSelection selection = {};             ///< topics to choose from, and the time of text files
  std::optional<LogColumns> columns = {};  ///< names the channels; none: they are found
  bool commands = true;                    ///< false: commands in the log are left out
  /// The commands to use; none: the first kind that the log has, in the order position, velocity, torque.
  std::optional<CommandKind> command = {};
  std::optional<Gains> gains =
      {};                       ///< of the controller whose reference the commands are; none: no reference
  double control_period = 0.0;  ///< of this controller [s]; 0: the median time between references
};

struct LoggedJoints {
  JointLog log;
  std::optional<MotionCommands> commands;
  std::vector<std::string> notes;  ///< what was chosen, converted and repaired: sentences without full stop
};

/// Reads a log (read_log in log_reader.hpp). Rows without a number for some joint are left out. Measured
/// currents are no torques unless the column map converts them. Throws InputError as read_log does, and with
/// the file and
///   - the key `position` if no channels look like the positions of all joints,
///   - the name of the column as key if the column map names one that the log does not have,
///   - the key `--commands` if there are no commands of the kind that is asked for, or no reference for the
///     gains.
LoggedJoints read_logged_joints(const RobotModel& model, const std::vector<std::string>& paths,
                                const LoggedJointsOptions& options);

}  // namespace armtune::internal
