#include "sim/logs/derivative_law.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace armtune::internal {
namespace {

/// A channel moves if its RMS change over a stretch is at least this share of the largest in its group.
constexpr double kMoves = 0.05;
/// Largest groups whose order is checked; the check compares all pairs.
constexpr std::size_t kMostOrdered = 32;

std::vector<std::size_t> moving(const TopicSummary& topic, const ChannelGroup& group) {
  std::vector<double> change;
  for (const std::size_t c : group.channels) change.push_back(topic.blocks.rms_change(c));
  const double largest = *std::max_element(change.begin(), change.end());
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < change.size(); ++i) {
    if (change[i] > 0.0 && change[i] >= kMoves * largest) places.push_back(i);
  }
  return places;
}

GroupRelation combined(const std::vector<Relation>& relations) {
  GroupRelation group;
  std::vector<double> factors;
  group.correlation = 1.0;
  for (const Relation& relation : relations) {
    factors.push_back(relation.factor);
    group.correlation = std::min(group.correlation, relation.correlation);
  }
  std::sort(factors.begin(), factors.end());
  group.factor = factors[factors.size() / 2];
  const double worst = std::max(factors.back() - group.factor, group.factor - factors.front());
  group.deviation = group.factor != 0.0 ? worst / std::abs(group.factor) : worst;
  return group;
}

}  // namespace

std::optional<GroupRelation> derivative_relation(const TopicSummary& topic, const ChannelGroup& a,
                                                 const ChannelGroup& b) {
  if (a.channels.size() != b.channels.size()) return std::nullopt;
  std::vector<Relation> relations;
  bool same_order = true;
  for (const std::size_t i : moving(topic, a)) {
    relations.push_back(topic.blocks.derivative(a.channels[i], b.channels[i]));
    if (relations.back().correlation > 0.9 || a.channels.size() > kMostOrdered) continue;
    for (const std::size_t other : b.channels)
      same_order = same_order && topic.blocks.derivative(a.channels[i], other).correlation < 0.95;
  }
  if (relations.empty()) return std::nullopt;
  GroupRelation group = combined(relations);
  group.same_order = same_order;
  return group;
}

std::optional<GroupRelation> multiple_relation(const TopicSummary& topic, const ChannelGroup& a,
                                               const ChannelGroup& b) {
  if (a.channels.size() != b.channels.size()) return std::nullopt;
  std::vector<Relation> relations;
  for (const std::size_t i : moving(topic, a))
    relations.push_back(topic.blocks.multiple(a.channels[i], b.channels[i]));
  if (relations.empty()) return std::nullopt;
  return combined(relations);
}

}  // namespace armtune::internal
