#include "sim/logs/channel_groups.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "sim/logs/channel_words.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostJoints = 16;
constexpr std::string_view kDigits = "0123456789";

/// A way in which the names of one group differ: the text before and after, and what differs.
struct NamePattern {
  std::string before, part, after;
  std::string key() const { return before + '\n' + after; }
};

std::optional<NamePattern> by_number(const std::string& name) {
  const std::size_t last = name.find_last_of(kDigits);
  if (last == std::string::npos) return std::nullopt;
  const std::size_t before = name.find_last_not_of(kDigits, last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return NamePattern{name.substr(0, first), name.substr(first, last + 1 - first), name.substr(last + 1)};
}

std::optional<NamePattern> by_middle(const std::string& name) {
  const std::size_t first = name.find('/');
  const std::size_t last = name.rfind('/');
  if (first == 0 || first == std::string::npos || last <= first + 1) return std::nullopt;
  return NamePattern{name.substr(0, first + 1), name.substr(first + 1, last - first - 1), name.substr(last)};
}

std::optional<NamePattern> by_axis(const std::string& name) {
  const std::size_t last = name.size() - 1;
  if (name.size() < 3 || std::string_view("xyzw").find(name[last]) == std::string_view::npos)
    return std::nullopt;
  if (std::string_view("/._").find(name[last - 1]) == std::string_view::npos) return std::nullopt;
  return NamePattern{name.substr(0, last), name.substr(last), ""};
}

std::optional<NamePattern> by_last_word(const std::string& name) {
  const std::size_t mark = name.find_last_of("_ ./");
  if (mark == std::string::npos || mark == 0) return std::nullopt;
  if (words_of(name.substr(mark)).quantity == Quantity::kUnknown) return std::nullopt;
  return NamePattern{"", name.substr(0, mark), name.substr(mark)};
}

std::optional<NamePattern> by_first_word(const std::string& name) {
  const std::size_t mark = name.find_first_of("_ ./");
  if (mark == std::string::npos || mark + 1 == name.size()) return std::nullopt;
  if (words_of(name.substr(0, mark)).quantity == Quantity::kUnknown) return std::nullopt;
  return NamePattern{name.substr(0, mark + 1), name.substr(mark + 1), ""};
}

bool shorter_number(const NamePattern& a, const NamePattern& b) {
  return a.part.size() != b.part.size() ? a.part.size() < b.part.size() : a.part < b.part;
}

struct Member {
  std::size_t channel = 0;
  NamePattern pattern;
};

ChannelGroup make_group(std::vector<Member> members, bool ordered) {
  if (ordered)
    std::stable_sort(members.begin(), members.end(),
                     [](const Member& a, const Member& b) { return shorter_number(a.pattern, b.pattern); });
  ChannelGroup group;
  for (const Member& member : members) group.channels.push_back(member.channel);
  const NamePattern& first = members.front().pattern;
  const std::string parts = ordered ? first.part + ".." + members.back().pattern.part : "*";
  group.name = first.before + parts + first.after;
  return group;
}

using FindPattern = std::optional<NamePattern> (*)(const std::string&);

/// Groups those of the channels that are left whose names differ in one way, and removes them.
void take_groups(FindPattern find, bool ordered, const TopicSummary& topic, std::vector<std::size_t>& left,
                 std::vector<ChannelGroup>& groups) {
  std::map<std::string, std::vector<Member>> found;
  for (const std::size_t c : left) {
    if (const auto pattern = find(topic.channels[c].name)) found[pattern->key()].push_back({c, *pattern});
  }
  std::vector<bool> taken(topic.channels.size(), false);
  for (auto& [key, members] : found) {
    if (members.size() < 2) continue;
    for (const Member& member : members) taken[member.channel] = true;
    groups.push_back(make_group(std::move(members), ordered));
  }
  std::erase_if(left, [&taken](std::size_t c) { return taken[c]; });
}

/// Returns the number of columns by which derivatives stand behind their positions, and the first position.
std::pair<std::size_t, std::size_t> find_joints(const TopicSummary& topic) {
  std::size_t best = 0, best_count = 0, best_first = 0;
  for (std::size_t n = 1; n <= kMostJoints && n < topic.channels.size(); ++n) {
    std::size_t count = 0, first = 0;
    for (std::size_t c = 0; c + n < topic.channels.size(); ++c) {
      if (count > 0 && c >= first + n) break;
      if (topic.channels[c].constant()) continue;
      const Relation relation = topic.blocks.derivative(c, c + n);
      if (relation.correlation < 0.9 || std::abs(relation.factor - 1.0) > 0.2) continue;
      if (count++ == 0) first = c;
    }
    if (count <= best_count) continue;
    best = n;
    best_count = count;
    best_first = first;
  }
  return {best, best_first};
}

std::vector<ChannelGroup> group_by_values(const TopicSummary& topic) {
  const auto [joints, first] = find_joints(topic);
  const std::size_t all = topic.channels.size();
  std::vector<ChannelGroup> groups;
  const auto add = [&](std::size_t begin, std::size_t end) {
    if (begin >= end) return;
    ChannelGroup& group = groups.emplace_back();
    for (std::size_t c = begin; c < end; ++c) group.channels.push_back(c);
    group.name = topic.channels[begin].name;
    if (end > begin + 1) group.name += ".." + topic.channels[end - 1].name;
  };
  if (joints == 0) {
    for (std::size_t c = 0; c < all; ++c) add(c, c + 1);
    return groups;
  }
  add(0, first);
  for (std::size_t c = first; c < all; c += joints) add(c, std::min(c + joints, all));
  return groups;
}

}  // namespace

std::vector<ChannelGroup> group_channels(const TopicSummary& topic) {
  if (!topic.named) return group_by_values(topic);
  std::vector<std::size_t> left(topic.channels.size());
  for (std::size_t c = 0; c < left.size(); ++c) left[c] = c;
  std::vector<ChannelGroup> groups;
  take_groups(by_middle, false, topic, left, groups);
  take_groups(by_number, true, topic, left, groups);
  take_groups(by_axis, true, topic, left, groups);
  take_groups(by_last_word, false, topic, left, groups);
  take_groups(by_first_word, false, topic, left, groups);
  for (const std::size_t c : left) groups.push_back({topic.channels[c].name, {c}});
  std::sort(groups.begin(), groups.end(), [](const ChannelGroup& a, const ChannelGroup& b) {
    return *std::min_element(a.channels.begin(), a.channels.end()) <
           *std::min_element(b.channels.begin(), b.channels.end());
  });
  return groups;
}

}  // namespace armtune::internal
