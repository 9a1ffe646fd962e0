#include "tuner/validation/chosen_signals.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"

namespace armtune::internal {
namespace {

/// Names of elements that a message lists at most.
constexpr std::size_t kMostNames = 12;

/// Returns the names in the first group of positions or, if there is none, nothing.
std::vector<std::string> names_in_log(const LogSummary& summary) {
  for (const TopicSummary& topic : summary.topics) {
    for (const GroupMeaning& meaning : find_meanings(topic)) {
      if (meaning.quantity == Quantity::kPosition && meaning.role == Role::kMeasured)
        return element_names(topic, meaning.group);
    }
  }
  return {};
}

[[noreturn]] void refuse_without_positions(const RobotModel& model, const LogSummary& summary) {
  std::vector<std::string> names = names_in_log(summary);
  if (names.size() > kMostNames) names.resize(kMostNames);
  const std::string called =
      names.empty() ? "" : fmt::format("; positions are called {}", fmt::join(names, ", "));
  throw InputError(
      InputPlace{summary.files.front(), 0, "position"},
      {fmt::format(
           "the log has {}, and no positions for each of the {} joints of {}{}; name the columns in a "
           "YAML file with --columns",
           listed_groups(summary), model.n(), model.name, called),
       listed_groups(summary), fmt::format("positions of {}", fmt::join(joint_names(model), ", "))});
}

/// Returns the group as the positions of the arm. Prefers a topic that has torques beside them.
const SignalGroup& choose_positions(const RobotModel& model, const LogSummary& summary,
                                    const std::vector<SignalGroup>& groups, std::vector<std::string>& notes) {
  const SignalGroup* best = nullptr;
  std::vector<std::string> others;
  for (const bool with_torques : {true, false}) {
    for (const TopicSummary& topic : summary.topics) {
      const SignalGroup* group = find_group(groups, Quantity::kPosition, Role::kMeasured, topic.name);
      const bool torques = find_group(groups, Quantity::kTorque, Role::kMeasured, topic.name) != nullptr;
      if (group == nullptr || torques != with_torques) continue;
      if (best == nullptr)
        best = group;
      else
        others.push_back(topic.name);
    }
  }
  if (best == nullptr) refuse_without_positions(model, summary);
  if (!others.empty()) {
    notes.push_back(fmt::format("{} was chosen; {} has positions too (--topic chooses)", best->topic,
                                fmt::join(others, ", ")));
  }
  return *best;
}

std::optional<SignalGroup> copy_of(const SignalGroup* group) {
  return group == nullptr ? std::nullopt : std::optional(*group);
}

std::optional<SignalGroup> find_torques(const std::vector<SignalGroup>& groups, const std::string& topic,
                                        std::vector<std::string>& notes) {
  if (const auto* torque = find_group(groups, Quantity::kTorque, Role::kMeasured, topic)) return *torque;
  if (const auto* drive = find_group(groups, Quantity::kDrive, Role::kMeasured, topic)) {
    notes.push_back(fmt::format("{} may be torques or currents and are taken as torques", drive->name));
    return *drive;
  }
  if (const auto* current = find_group(groups, Quantity::kCurrent, Role::kMeasured, topic)) {
    notes.push_back(fmt::format(
        "{} are currents; a column map (--columns) with a factor to N m for each joint makes torques of them",
        current->name));
  }
  return std::nullopt;
}

/// Returns the group of columns that a map names. key: what they are, for messages.
SignalGroup mapped_group(const LogSummary& summary, const std::vector<LogColumn>& columns,
                         Quantity quantity) {
  SignalGroup group;
  group.quantity = quantity;
  group.name = columns.front().name;
  if (columns.size() > 1) group.name += " to " + columns.back().name;
  group.sureness = Sureness::kCertain;
  const auto has = [](const TopicSummary& topic, const std::string& name) {
    return std::any_of(topic.channels.begin(), topic.channels.end(),
                       [&](const ChannelSummary& channel) { return channel.name == name; });
  };
  for (const LogColumn& column : columns) {
    const auto topic = std::find_if(summary.topics.begin(), summary.topics.end(),
                                    [&](const TopicSummary& one) { return has(one, column.name); });
    const bool first = group.topic.empty();
    if (topic == summary.topics.end() || (!first && topic->name != group.topic)) {
      std::vector<std::string> known;
      for (const TopicSummary& one : summary.topics) {
        for (const ChannelSummary& channel : one.channels) known.push_back(channel.name);
      }
      throw InputError(InputPlace{summary.files.front(), 0, column.name},
                       {fmt::format("the log has no {} '{}'{}; 'armtune logs FILE --all' lists what it has",
                                    first ? "channel" : fmt::format("channel of {}", group.topic),
                                    column.name, suggestion(column.name, known)),
                        column.name, "the name of a channel"});
    }
    group.topic = topic->name;
    group.channels.push_back(column.name);
    group.scale.push_back(column.scale);
  }
  return group;
}

/// True if the log has the first of the columns.
bool has_columns(const LogSummary& summary, const std::vector<LogColumn>& columns) {
  for (const TopicSummary& topic : summary.topics) {
    for (const ChannelSummary& channel : topic.channels) {
      if (!columns.empty() && channel.name == columns.front().name) return true;
    }
  }
  return false;
}

void choose_mapped(const LogSummary& summary, const LogColumns& columns, ChosenSignals& chosen) {
  chosen.position = mapped_group(summary, columns.position, Quantity::kPosition);
  if (!columns.velocity.empty() && (!columns.velocity_optional || has_columns(summary, columns.velocity)))
    chosen.velocity = mapped_group(summary, columns.velocity, Quantity::kVelocity);
  if (has_columns(summary, columns.torque))
    chosen.torque = mapped_group(summary, columns.torque, Quantity::kTorque);
  for (const auto* group : {&chosen.velocity, &chosen.torque}) {
    if (!group->has_value() || (*group)->topic == chosen.position.topic) continue;
    throw InputError(
        InputPlace{summary.files.front(), 0, (*group)->name},
        {fmt::format("{} is recorded in {}, and {} in {}; name columns of one topic", (*group)->name,
                     (*group)->topic, chosen.position.name, chosen.position.topic),
         (*group)->topic, chosen.position.topic});
  }
}

Quantity quantity_of(CommandKind kind) {
  switch (kind) {
    case CommandKind::kTorque:
      return Quantity::kTorque;
    case CommandKind::kVelocity:
      return Quantity::kVelocity;
    default:
      return Quantity::kPosition;
  }
}

/// Chooses the commands and their kind, if there are any.
void choose_commands(const LogSummary& summary, const std::vector<SignalGroup>& groups,
                     const LoggedJointsOptions& options, ChosenSignals& chosen) {
  std::vector<CommandKind> kinds = {CommandKind::kPosition, CommandKind::kVelocity, CommandKind::kTorque};
  if (options.gains)
    kinds = {CommandKind::kReference};
  else if (options.command)
    kinds = {*options.command};
  for (const CommandKind kind : kinds) {
    const Quantity quantity = quantity_of(kind);
    // A reference is published beside the measured joints; commands of the same topic are of the same arm.
    const SignalGroup* group = find_group(groups, quantity, Role::kCommand, chosen.position.topic);
    if (group == nullptr) group = find_group(groups, quantity, Role::kCommand);
    chosen.command = copy_of(group);
    if (options.command == CommandKind::kTorque && !chosen.command) chosen.command = chosen.torque;
    if (!chosen.command) continue;
    if (kind == CommandKind::kReference)
      chosen.command_velocity =
          copy_of(find_group(groups, Quantity::kVelocity, Role::kCommand, group->topic));
    chosen.kind = kind;
    return;
  }
  if (!options.gains && !options.command) return;
  throw InputError(
      InputPlace{summary.files.front(), 0, "--commands"},
      {fmt::format("the log has no {} for each joint; it has {}. Leave the option out, or record them",
                   options.gains ? "desired positions, which the controller could follow,"
                                 : fmt::format("{} commands", name(*options.command)),
                   listed_groups(summary)),
       options.gains ? "reference" : name(*options.command), "commands that the log has"});
}

std::string match_note(const RobotModel& model, const SignalGroup& position) {
  switch (position.match) {
    case JointMatch::kEnding:
      return fmt::format("the names of the joints differ from those of {} and were matched by their ends",
                         model.name);
    case JointMatch::kOrder:
      return fmt::format("the log names no joints; its order is taken as {}",
                         fmt::join(joint_names(model), ", "));
    default:
      return {};
  }
}

std::string chosen_note(const ChosenSignals& chosen) {
  std::string text = "positions: " + to_text(chosen.position);
  if (chosen.velocity) text += "; velocities: " + to_text(*chosen.velocity);
  if (chosen.torque) text += "; torques: " + to_text(*chosen.torque);
  return text;
}

}  // namespace

ChosenSignals choose_signals(const RobotModel& model, const LogSummary& summary,
                             const LoggedJointsOptions& options) {
  const std::vector<SignalGroup> groups = signal_groups(model, summary);
  ChosenSignals chosen;
  if (options.columns) {
    choose_mapped(summary, *options.columns, chosen);
  } else {
    chosen.position = choose_positions(model, summary, groups, chosen.notes);
    const std::string& topic = chosen.position.topic;
    chosen.velocity = copy_of(find_group(groups, Quantity::kVelocity, Role::kMeasured, topic));
    chosen.torque = find_torques(groups, topic, chosen.notes);
  }
  if (options.commands) choose_commands(summary, groups, options, chosen);
  chosen.notes.push_back(chosen_note(chosen));
  if (const std::string note = match_note(model, chosen.position); !note.empty())
    chosen.notes.push_back(note);
  return chosen;
}

}  // namespace armtune::internal
