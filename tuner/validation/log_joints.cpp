#include "tuner/validation/log_joints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/logs/log_reader.hpp"
#include "tuner/validation/chosen_signals.hpp"

namespace armtune::internal {
namespace {

/// The values of a group, one row for each row of its topic; NaN where a number is missing.
Eigen::MatrixXd values_of_group(const LogTopic& topic, const SignalGroup& group) {
  Eigen::MatrixXd values(static_cast<Eigen::Index>(topic.time.size()),
                         static_cast<Eigen::Index>(group.channels.size()));
  for (std::size_t j = 0; j < group.channels.size(); ++j) {
    const auto channel = std::find_if(topic.channels.begin(), topic.channels.end(),
                                      [&](const LogChannel& one) { return one.name == group.channels[j]; });
    const auto column = static_cast<Eigen::Index>(j);
    values.col(column) =
        group.scale[j] * Eigen::Map<const Eigen::VectorXd>(channel->value.data(), values.rows());
  }
  return values;
}

const LogTopic& topic_of(const Log& log, const std::string& name) {
  return *std::find_if(log.topics.begin(), log.topics.end(),
                       [&](const LogTopic& topic) { return topic.name == name; });
}

/// Returns the rows in which every matrix has finite numbers; with `increasing` also only those with a later
/// time than the row before.
std::vector<Eigen::Index> whole_rows(const std::vector<double>& time,
                                     const std::vector<const Eigen::MatrixXd*>& parts, bool increasing) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const bool whole = std::all_of(parts.begin(), parts.end(), [&](const Eigen::MatrixXd* part) {
      return part->size() == 0 || part->row(row).allFinite();
    });
    const bool later = !increasing || rows.empty() || time[i] > time[static_cast<std::size_t>(rows.back())];
    if (whole && later) rows.push_back(row);
  }
  return rows;
}

void keep_rows(const std::vector<Eigen::Index>& rows, std::vector<double>& time,
               const std::vector<Eigen::MatrixXd*>& parts) {
  if (rows.size() == time.size()) return;
  for (std::size_t i = 0; i < rows.size(); ++i) time[i] = time[static_cast<std::size_t>(rows[i])];
  time.resize(rows.size());
  for (Eigen::MatrixXd* part : parts) {
    if (part->size() > 0) *part = Eigen::MatrixXd((*part)(rows, Eigen::all));
  }
}

JointLog joint_log_of(const Log& log, const ChosenSignals& chosen, std::vector<std::string>& notes) {
  const LogTopic& topic = topic_of(log, chosen.position.topic);
  JointLog out;
  out.source = log.file;
  out.time = topic.time;
  out.q = values_of_group(topic, chosen.position);
  if (chosen.velocity) out.qd = values_of_group(topic, *chosen.velocity);
  if (chosen.torque) out.torque = values_of_group(topic, *chosen.torque);
  // Some drivers publish fields that they do not fill: they have no number in any row, or zeros throughout.
  const auto drop_empty = [&](Eigen::MatrixXd& values, const char* what) {
    if (values.size() == 0 || (values.array() == values.array() && values.array() != 0.0).any()) return;
    values.resize(0, 0);
    notes.push_back(fmt::format("the {} have no number other than 0 and were left out", what));
  };
  drop_empty(out.qd, "velocities");
  drop_empty(out.torque, "torques");
  const auto rows = whole_rows(out.time, {&out.q, &out.qd, &out.torque}, false);
  if (const std::size_t left_out = out.time.size() - rows.size(); left_out > 0)
    notes.push_back(fmt::format("{} of {} rows without a number for each joint were left out", left_out,
                                out.time.size()));
  keep_rows(rows, out.time, {&out.q, &out.qd, &out.torque});
  return out;
}

MotionCommands commands_of(const Log& log, const ChosenSignals& chosen, const LoggedJointsOptions& options,
                           std::vector<std::string>& notes) {
  const LogTopic& topic = topic_of(log, chosen.command->topic);
  MotionCommands out;
  out.kind = *chosen.kind;
  out.time = topic.time;
  out.value = values_of_group(topic, *chosen.command);
  if (chosen.command_velocity) out.velocity = values_of_group(topic, *chosen.command_velocity);
  out.gains = options.gains;
  out.control_period = options.control_period;
  keep_rows(whole_rows(out.time, {&out.value, &out.velocity}, true), out.time, {&out.value, &out.velocity});
  // libfranka's tau_J_d and the commands of franka_ros leave the torque that holds the arm to the robot.
  const std::string& name = chosen.command->channels.front();
  out.robot_adds_weight = out.kind == CommandKind::kTorque && name.find("tau_J_d") != std::string::npos;
  notes.push_back(
      fmt::format("{} commands: {}{}", internal::name(out.kind), to_text(*chosen.command),
                  out.robot_adds_weight ? "; the robot adds the torque that holds its weight" : ""));
  return out;
}

/// Adds what the column map says about the time to the selection.
LogSelection with_time(LogSelection selection, const std::optional<LogColumns>& columns) {
  if (!columns) return selection;
  // A column called time is found without being named, and a bag has none.
  if (columns->time.name != "time") selection.time.column = columns->time.name;
  if (columns->time.scale != 1.0) selection.time.unit = TimeUnit::kSeconds;
  return selection;
}

}  // namespace

LoggedJoints read_logged_joints(const RobotModel& model, const std::vector<std::string>& paths,
                                const LoggedJointsOptions& options) {
  LogSelection selection = with_time(options.selection, options.columns);
  const LogSummary summary = summarize_log(paths, selection);
  const ChosenSignals chosen = choose_signals(model, summary, options);
  LoggedJoints out;
  out.notes = chosen.notes;
  selection.topics = {chosen.position.topic};
  if (chosen.command) selection.topics.push_back(chosen.command->topic);
  Log log = read_log(paths, selection);
  if (options.columns && options.columns->time.scale != 1.0) {
    for (LogTopic& topic : log.topics) {
      for (double& time : topic.time) time *= options.columns->time.scale;
    }
  }
  out.log = joint_log_of(log, chosen, out.notes);
  if (chosen.kind) out.commands = commands_of(log, chosen, options, out.notes);
  for (std::string note : summary.notes) {
    if (note.ends_with('.')) note.pop_back();
    out.notes.push_back(std::move(note));
  }
  return out;
}

}  // namespace armtune::internal
