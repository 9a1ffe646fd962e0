#pragma once
// Puts similar channels together, such as the positions of all joints.

#include <string>
#include <vector>

#include "sim/logs/log_summary.hpp"

namespace armtune::internal {

struct ChannelGroup {
  std::string name;                   ///< such as "position[0..5]"
  std::vector<std::size_t> channels;  ///< indices, in the order of their numbers
};

/// Groups channels whose names differ in
///   - their last number (actual_q_0, actual_q_1),
///   - the middle of a path (joint/elbow/position), or its last letter x, y, z or w (force/x),
///   - everything but their last or first word, if this names a quantity (elbow_pos, wrist_pos).
/// Every channel is in exactly one group, and groups are in the order of their first channels. Columns
/// without names are grouped by their values: if n neighbouring columns are the derivatives of the n columns
/// before them, all columns are divided into groups of n.
std::vector<ChannelGroup> group_channels(const TopicSummary& topic);

}  // namespace armtune::internal
