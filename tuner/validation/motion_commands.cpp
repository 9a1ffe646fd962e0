#include "tuner/validation/motion_commands.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "armtune/error.hpp"
#include "core/control/laws/valid_gains.hpp"

namespace armtune::internal {
namespace {

void check_command_channel(const MotionCommands& commands, const Eigen::MatrixXd& values,
                           const std::string& source, const std::string& key, int joints) {
  const auto count = static_cast<Eigen::Index>(commands.time.size());
  if (values.rows() != count || values.cols() != joints) {
    throw InputError(
        InputPlace{source, 0, key},
        {fmt::format("{} commands to {} joints, although there are {} times and the arm has {} "
                     "joints; give every joint one number for each time",
                     values.rows(), values.cols(), count, joints),
         fmt::format("{} x {}", values.rows(), values.cols()), fmt::format("{} x {}", count, joints)});
  }
  for (Eigen::Index j = 0; j < values.cols(); ++j) {
    for (Eigen::Index i = 0; i < values.rows(); ++i) {
      if (std::isfinite(values(i, j))) continue;
      throw InputError(
          InputPlace{source, 0, key},
          {fmt::format("command {} to joint {} is {}; leave this command out", i + 1, j + 1, values(i, j)),
           fmt::to_string(values(i, j)), "a finite number"});
    }
  }
}

void check_command_times(const std::vector<double>& time, const std::string& source) {
  const InputPlace place{source, 0, "command time"};
  if (time.size() < 2) {
    throw InputError(place, {fmt::format("{} commands are too few to move an arm; log longer", time.size()),
                             fmt::to_string(time.size()), "at least 2"});
  }
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (std::isfinite(time[i]) && (i == 0 || time[i] > time[i - 1])) continue;
    throw InputError(place, {fmt::format("the time of command {} is {} s, which is not after the one before; "
                                         "leave this command out",
                                         i + 1, time[i]),
                             fmt::to_string(time[i]), "increasing times"});
  }
}

}  // namespace

const char* name(CommandKind kind) {
  switch (kind) {
    case CommandKind::kTorque:
      return "torque";
    case CommandKind::kVelocity:
      return "velocity";
    case CommandKind::kPosition:
      return "position";
    case CommandKind::kReference:
      return "reference";
  }
  return "";
}

void check_motion_commands(const RobotModel& model, const JointLog& log, const MotionCommands& commands) {
  check_command_times(commands.time, log.source);
  const std::string key = std::string(name(commands.kind)) + " command";
  check_command_channel(commands, commands.value, log.source, key, model.n());
  if (commands.velocity.size() > 0)
    check_command_channel(commands, commands.velocity, log.source, "reference velocity", model.n());
  if (commands.kind != CommandKind::kReference) return;
  if (!commands.gains) {
    throw InputError(InputPlace{log.source, 0, "gains"},
                     "a logged reference moves the arm only through a controller; give its gains")
        .with_value("none", "gains of a controller");
  }
  validate(*commands.gains, joint_names(model), log.source);
}

}  // namespace armtune::internal
