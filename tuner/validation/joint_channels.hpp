#pragma once
// Finds out which channel of a log belongs to which joint of an arm. The names in the messages, such as those
// of a JointState, or the names of the columns decide. Channels that only have numbers are taken in order.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/logs/channel_groups.hpp"

namespace armtune::internal {

/// What the channels and the joints have in common.
enum class JointMatch {
  kName,    ///< every joint's name stands in the name of one channel
  kEnding,  ///< the names differ in their common beginning or end: panda_joint1 and fer_joint1
  kOrder    ///< the channels are numbered, and there are as many as joints
};

struct JointChannels {
  std::vector<std::size_t> channel;  ///< n, indices in the topic, in the joint order of the model
  JointMatch match = JointMatch::kName;
};

/// Assigns the channels of a group to the joints of the model. Returns nothing if a joint has no channel, or
/// several that could be meant.
std::optional<JointChannels> match_joints(const RobotModel& model, const TopicSummary& topic,
                                          const ChannelGroup& group);

/// Returns the names by which a group's channels are told apart: the label that the messages give an element,
/// or the name of the channel.
std::vector<std::string> element_names(const TopicSummary& topic, const ChannelGroup& group);

}  // namespace armtune::internal
