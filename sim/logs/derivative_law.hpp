#pragma once
// Compares two groups of channels, to find out whether one is the derivative or a multiple of the other.

#include <optional>

#include "sim/logs/channel_groups.hpp"
#include "sim/logs/log_summary.hpp"

namespace armtune::internal {

/// How the channels of one group are related to those of another.
struct GroupRelation {
  double factor = 0.0;       ///< median of the factors of its channels
  double deviation = 0.0;    ///< largest relative deviation of a channel's factor from the median
  double correlation = 0.0;  ///< smallest correlation of a channel
  bool same_order = true;    ///< false: a channel fits better to another channel of the other group
};

/// Compares the derivatives of the channels of `a` with the channels of `b`. Channels that hardly move are
/// left out. Returns nothing if the groups have different sizes or none of the channels moves.
std::optional<GroupRelation> derivative_relation(const TopicSummary& topic, const ChannelGroup& a,
                                                 const ChannelGroup& b);

/// Compares the channels of `a` with those of `b`; the factor is that from a to b. Returns nothing in the
/// same cases.
std::optional<GroupRelation> multiple_relation(const TopicSummary& topic, const ChannelGroup& a,
                                               const ChannelGroup& b);

}  // namespace armtune::internal
