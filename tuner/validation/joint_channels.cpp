#include "tuner/validation/joint_channels.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace armtune::internal {
namespace {

using Names = std::vector<std::string>;

bool is_alnum(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Returns the last number in a name, such as 3 of "/joint_states/position[3]".
std::optional<std::size_t> last_number(const std::string& name) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto end = std::find_if(name.rbegin(), name.rend(), is_digit);
  if (end == name.rend()) return std::nullopt;
  const auto begin = std::find_if_not(end, name.rend(), is_digit);
  std::size_t number = 0;
  const auto read = std::from_chars(&*begin.base(), &*begin.base() + (begin - end), number);
  if (read.ec != std::errc()) return std::nullopt;
  return number;
}

/// True if the word stands in the text, with no letter or digit on either side.
bool has_word(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_alnum(text[at - 1])) && (end == text.size() || !is_alnum(text[end]))) return true;
  }
  return false;
}

std::size_t common_length(const Names& names, bool from_end) {
  const std::string& first = names.front();
  std::size_t length = first.size();
  for (const std::string& name : names) {
    const std::size_t most = std::min(length, name.size());
    length = 0;
    while (length < most && (from_end ? name[name.size() - 1 - length] == first[first.size() - 1 - length]
                                      : name[length] == first[length]))
      ++length;
  }
  return length;
}

/// Returns what distinguishes the names: each without the beginning and the end that all have in common. A
/// number is not cut in the middle.
Names distinct_parts(const Names& names) {
  const std::string& first = names.front();
  std::size_t head = common_length(names, false);
  while (head > 0 && std::isdigit(static_cast<unsigned char>(first[head - 1])) != 0) --head;
  std::size_t tail = common_length(names, true);
  while (tail > 0 && std::isdigit(static_cast<unsigned char>(first[first.size() - tail])) != 0) --tail;
  Names parts;
  for (const std::string& name : names)
    parts.push_back(name.size() >= head + tail ? name.substr(head, name.size() - head - tail) : "");
  return parts;
}

/// Returns for each wanted name the index of the only name for which `same` holds, or nothing.
template <typename Same>
std::optional<std::vector<std::size_t>> find_each(const Names& wanted, const Names& names, const Same& same) {
  std::vector<std::size_t> found;
  for (const std::string& one : wanted) {
    const auto is_it = [&](const std::string& name) { return same(name, one); };
    const auto at = std::find_if(names.begin(), names.end(), is_it);
    if (at == names.end() || std::find_if(at + 1, names.end(), is_it) != names.end()) return std::nullopt;
    found.push_back(static_cast<std::size_t>(at - names.begin()));
  }
  return found;
}

}  // namespace

std::vector<std::string> element_names(const TopicSummary& topic, const ChannelGroup& group) {
  Names names;
  for (const std::size_t c : group.channels) {
    const std::string& channel = topic.channels[c].name;
    const auto number = last_number(channel);
    names.push_back(number && *number < topic.labels.size() ? topic.labels[*number] : channel);
  }
  return names;
}

std::optional<JointChannels> match_joints(const RobotModel& model, const TopicSummary& topic,
                                          const ChannelGroup& group) {
  const Names joints = joint_names(model);
  const Names names = element_names(topic, group);
  if (names.size() < joints.size()) return std::nullopt;
  const auto equal = [](const std::string& a, const std::string& b) { return a == b; };
  JointMatch match = JointMatch::kName;
  auto found = find_each(joints, names, equal);
  if (!found) found = find_each(joints, names, has_word);
  if (!found && joints.size() > 1) {
    match = JointMatch::kEnding;
    found = find_each(distinct_parts(joints), distinct_parts(names), equal);
  }
  // A group is in the order of its numbers, and columns without names are in the order of the file.
  const bool numbered = !topic.named || (names.size() > 1 && last_number(distinct_parts(names).back()));
  if (!found && topic.labels.empty() && names.size() == joints.size() && numbered) {
    match = JointMatch::kOrder;
    found.emplace(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) (*found)[i] = i;
  }
  if (!found) return std::nullopt;
  JointChannels out;
  out.match = match;
  for (const std::size_t i : *found) out.channel.push_back(group.channels[i]);
  return out;
}

}  // namespace armtune::internal
