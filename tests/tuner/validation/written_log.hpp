#pragma once
// Writes logs of joints as CSV files.

#include <fmt/format.h>

#include <string>

#include "tests/tuner/validation/validation_rig.hpp"

namespace armtune::internal::test {

/// How the columns of a file are called, and in which unit the positions and velocities are.
struct WrittenLog {
  std::string before = "joint/";  ///< before the joint in the names of the columns
  bool names = true;              ///< true: joints by name; false: by number, from 1
  double angle = 1.0;             ///< factor on positions and velocities
  const char* unit = "";          ///< behind the names of positions, such as " [deg]"
  bool torques = true;
  bool commands = false;  ///< also writes the positions, as commands
};

inline std::string log_text(const RobotModel& model, const JointLog& log, const WrittenLog& how = {}) {
  std::string text = "time";
  const auto add_names = [&](const char* quantity, const char* unit) {
    for (int j = 0; j < model.n(); ++j) {
      const std::string joint =
          how.names ? model.joints[static_cast<std::size_t>(j)].name : std::to_string(j + 1);
      text += fmt::format(",{}{}/{}{}", how.before, joint, quantity, unit);
    }
  };
  const bool velocities = log.has_velocities();
  add_names("position", how.unit);
  if (velocities) add_names("velocity", "");
  if (how.torques) add_names("torque", "");
  if (how.commands) add_names("position_command", how.unit);
  text += '\n';
  for (Eigen::Index i = 0; i < log.samples(); ++i) {
    text += fmt::format("{}", log.time[static_cast<std::size_t>(i)]);
    const auto add_row = [&](const Eigen::MatrixXd& values, double factor) {
      for (Eigen::Index j = 0; j < model.n(); ++j) text += fmt::format(",{}", factor * values(i, j));
    };
    add_row(log.q, how.angle);
    if (velocities) add_row(log.qd, how.angle);
    if (how.torques) add_row(log.torque, 1.0);
    if (how.commands) add_row(log.q, how.angle);
    text += '\n';
  }
  return text;
}

}  // namespace armtune::internal::test
