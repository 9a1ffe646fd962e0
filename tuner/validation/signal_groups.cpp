#include "tuner/validation/signal_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Factor on the limits of the joints up to which positions can be radians.
constexpr double kBeyondLimits = 1.05;
/// Groups that a message lists at most.
constexpr int kMostGroups = 8;

bool is_of_joints(Quantity quantity) {
  return quantity == Quantity::kPosition || quantity == Quantity::kVelocity ||
         quantity == Quantity::kTorque || quantity == Quantity::kDrive || quantity == Quantity::kCurrent;
}

/// True if every channel stays within the limits of its joint.
bool within_limits(const RobotModel& model, const TopicSummary& topic, const JointChannels& channels) {
  for (std::size_t j = 0; j < channels.channel.size(); ++j) {
    const ChannelSummary& channel = topic.channels[channels.channel[j]];
    const JointLimits& limits = model.joints[j].limits;
    const double most =
        limits.has_position ? std::max(std::abs(limits.lower), std::abs(limits.upper)) : 2.0 * M_PI;
    if (std::max(std::abs(channel.least), std::abs(channel.greatest)) > kBeyondLimits * most) return false;
  }
  return true;
}

double factor_to_si(const std::string& unit, JointMotion motion) {
  const bool turns = motion == JointMotion::kRevolute;
  if (turns && unit.starts_with("deg")) return M_PI / 180.0;
  return !turns && unit == "mm" ? 1e-3 : 1.0;
}

}  // namespace

std::vector<SignalGroup> signal_groups(const RobotModel& model, const LogSummary& summary) {
  std::vector<SignalGroup> groups;
  for (const TopicSummary& topic : summary.topics) {
    if (topic.type.ends_with("/JointTrajectory")) continue;  // goals, not samples
    bool radians = false;  // positions that look like degrees are in radians, and so are their velocities
    for (const GroupMeaning& meaning : find_meanings(topic)) {
      if (!is_of_joints(meaning.quantity)) continue;
      const auto channels = match_joints(model, topic, meaning.group);
      if (!channels) continue;
      SignalGroup group;
      group.topic = topic.name;
      group.name = meaning.group.name;
      group.quantity = meaning.quantity;
      group.role = meaning.role;
      group.sureness = meaning.sureness;
      group.unit = meaning.unit;
      group.match = channels->match;
      if (meaning.quantity == Quantity::kPosition && !meaning.unit_stated && meaning.unit == "deg")
        radians = within_limits(model, topic, *channels);
      if (radians && !meaning.unit_stated && group.unit.starts_with("deg")) group.unit.replace(0, 3, "rad");
      for (std::size_t j = 0; j < channels->channel.size(); ++j) {
        group.channels.push_back(topic.channels[channels->channel[j]].name);
        group.scale.push_back(factor_to_si(group.unit, model.chain.motion[j]));
      }
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

const SignalGroup* find_group(const std::vector<SignalGroup>& groups, Quantity quantity, Role role,
                              const std::string& topic) {
  const SignalGroup* doubtful = nullptr;
  for (const SignalGroup& group : groups) {
    if (group.quantity != quantity || group.role != role) continue;
    if (!topic.empty() && group.topic != topic) continue;
    if (group.sureness != Sureness::kDoubtful) return &group;
    if (doubtful == nullptr) doubtful = &group;
  }
  return doubtful;
}

std::string to_text(const SignalGroup& group) {
  const bool converted =
      std::any_of(group.scale.begin(), group.scale.end(), [](double scale) { return scale != 1.0; });
  if (!converted) return group.name;
  return group.unit.empty() ? group.name + " with the factors of the column map"
                            : fmt::format("{} in {}, converted to SI units", group.name, group.unit);
}

std::string listed_groups(const LogSummary& summary) {
  std::string text;
  int listed = 0;
  for (const TopicSummary& topic : summary.topics) {
    for (const GroupMeaning& meaning : find_meanings(topic)) {
      if (!is_of_joints(meaning.quantity)) continue;
      if (++listed > kMostGroups) return text + " and more";
      text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", meaning.group.channels.size(),
                          meaning.role == Role::kCommand ? "commanded " : "", plural(meaning.quantity));
      text += fmt::format(" ({})", meaning.group.name);
    }
  }
  return text.empty() ? "no channels that look like joints" : text;
}

}  // namespace armtune::internal
