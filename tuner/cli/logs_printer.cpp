#include "tuner/cli/logs_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/logs/log_meaning.hpp"
#include "tuner/cli/shell_words.hpp"

namespace armtune::internal::cli {
namespace {

constexpr std::size_t kTopicWidth = 30;
constexpr std::size_t kChannelWidth = 26;
/// Largest number of labels that are listed.
constexpr std::size_t kShownLabels = 12;

/// Returns the name with blanks up to the width. A longer name has a line of its own before the rest.
std::string padded(const std::string& name, std::size_t width) {
  if (name.size() < width) return fmt::format("{:<{}}", name, width);
  return fmt::format("{}\n{:<{}}", name, "", width);
}

std::string percent(double share) {
  return share < 0.0005 ? "-" : fmt::format("{:.2g} %", 100.0 * share);
}

std::string shown_number(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.4g}", value);
}

std::string topics_table(const LogSummary& summary) {
  std::string text = fmt::format("{:<{}}{:>10}{:>9}{:>9}{:>7}{:>9}{:>6}\n", "topic", kTopicWidth, "rows",
                                 "rate", "jitter", "gaps", "longest", "same");
  for (const TopicSummary& topic : summary.topics) {
    const std::string rate = topic.rate() > 0.0 ? fmt::format("{:.4g}", topic.rate()) : "-";
    text +=
        fmt::format("{}{:>10}{:>9}{:>9}{:>7}{:>9.3g}{:>6}\n", padded(topic.name, kTopicWidth), topic.rows,
                    rate, percent(topic.steps.jitter), topic.steps.gaps, topic.steps.longest, topic.repeated);
  }
  return text + fmt::format(
                    "rate [Hz]: from the median step; jitter: half the width of the central 90 %\n"
                    "of the steps; gaps: steps longer than {} median steps; longest: longest step\n"
                    "[s]; same: rows with the time of the row before\n",
                    StepHistogram::kGap);
}

std::string looks_like(const GroupMeaning& meaning) {
  if (meaning.quantity == Quantity::kUnknown) return "";
  const char* command = meaning.role == Role::kCommand ? ", commanded" : "";
  const std::string sure =
      meaning.sureness == Sureness::kNone ? "" : fmt::format(" ({})", name(meaning.sureness));
  return plural(meaning.quantity) + std::string(command) + sure;
}

/// Lines about a group that do not fit into its row.
std::string remarks(const GroupMeaning& meaning) {
  std::vector<std::string> all = meaning.reasons;
  if (meaning.constant == meaning.group.channels.size())
    all.insert(all.begin(), "constant");
  else if (meaning.constant > 0)
    all.insert(all.begin(), fmt::format("{} channels are constant", meaning.constant));
  if (meaning.missing_share > 0.0)
    all.insert(all.begin(),
               fmt::format("up to {} of the rows have no number", percent(meaning.missing_share)));
  std::string text;
  for (const std::string& remark : all) text += fmt::format("    {}\n", remark);
  return text;
}

std::string group_rows(const std::vector<GroupMeaning>& meanings) {
  std::string text = fmt::format("{:<{}}{:>10} {:>10} {:<8} {}\n", "channels", kChannelWidth, "from", "to",
                                 "unit", "look like");
  for (const GroupMeaning& meaning : meanings) {
    std::string row = fmt::format("{}{:>10} {:>10} {:<8} {}", padded(meaning.group.name, kChannelWidth),
                                  shown_number(meaning.least), shown_number(meaning.greatest), meaning.unit,
                                  looks_like(meaning));
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n" + remarks(meaning);
  }
  return text;
}

std::string channel_rows(const TopicSummary& topic) {
  constexpr std::size_t kWidth = 40;
  std::string text =
      fmt::format("{:<{}}{:>10} {:>10} {:<8} {:>8}\n", "channel", kWidth, "from", "to", "unit", "missing");
  for (const ChannelSummary& channel : topic.channels) {
    const double missing =
        topic.rows > 0 ? static_cast<double>(channel.missing) / static_cast<double>(topic.rows) : 0.0;
    text += fmt::format("{}{:>10} {:>10} {:<8} {:>8}\n", padded(channel.name, kWidth),
                        shown_number(channel.least), shown_number(channel.greatest), channel.unit,
                        percent(missing));
  }
  return text;
}

std::string labels_line(const std::vector<std::string>& labels) {
  if (labels.empty()) return {};
  const auto end = labels.begin() + static_cast<std::ptrdiff_t>(std::min(kShownLabels, labels.size()));
  std::string line = "elements:";
  std::string text;
  for (auto label = labels.begin(); label != end; ++label) {
    if (line.size() + label->size() + 1 > 80) {
      text += line + "\n";
      line = "   ";
    }
    line += " " + *label;
  }
  return text + line + (labels.size() > kShownLabels ? " ...\n" : "\n");
}

bool is_of_a_robot(const std::vector<GroupMeaning>& meanings) {
  return std::any_of(meanings.begin(), meanings.end(), [](const GroupMeaning& meaning) {
    return meaning.quantity != Quantity::kUnknown && meaning.quantity != Quantity::kOther;
  });
}

/// True if some channels look like the positions of joints.
bool has_joints(const TopicSummary& topic) {
  const std::vector<GroupMeaning> meanings = find_meanings(topic);
  return std::any_of(meanings.begin(), meanings.end(), [](const GroupMeaning& meaning) {
    return meaning.quantity == Quantity::kPosition && meaning.role == Role::kMeasured;
  });
}

std::string topic_text(const TopicSummary& topic, bool all, bool only) {
  const std::string head = fmt::format("\n{} ({})\n", topic.name, topic.type);
  if (!topic.trouble.empty() && topic.channels.empty()) return head + "  " + topic.trouble + "\n";
  const std::string trouble = topic.trouble.empty() ? std::string() : "  " + topic.trouble + "\n";
  const std::vector<GroupMeaning> meanings = find_meanings(topic);
  if (topic.channels.empty() || (!all && !only && !is_of_a_robot(meanings)))
    return trouble.empty() ? "" : head + trouble;
  return head + trouble + labels_line(topic.labels) + group_rows(meanings) +
         (all ? "\n" + channel_rows(topic) : std::string());
}

}  // namespace

std::string log_text(const LogSummary& summary, bool all) {
  double duration = 0.0;
  for (const TopicSummary& topic : summary.topics) duration = std::max(duration, topic.last);
  std::string text =
      fmt::format("{}: {:.4g} s\n{}\n\n", fmt::join(summary.files, " "), duration, summary.description);
  text += topics_table(summary);
  for (const TopicSummary& topic : summary.topics) text += topic_text(topic, all, summary.topics.size() == 1);
  for (const std::string& note : summary.notes) text += "\nnote: " + note;
  return summary.notes.empty() ? text : text + "\n";
}

std::string next_step(const LogSummary& summary) {
  std::string file;
  for (const std::string& path : summary.files) file += (file.empty() ? "" : " ") + shell_word(path);
  const std::string inputs = file;
  if (summary.files.size() > 1) file += " --join";
  for (const TopicSummary& topic : summary.topics) {
    if (topic.channels.empty() && !topic.trouble.empty())
      return fmt::format("next: armtune logs {} --msg-path FOLDER (with PACKAGE/msg/TYPE.msg)\n", file);
  }
  const bool joints = std::any_of(summary.topics.begin(), summary.topics.end(), has_joints);
  const std::string validate = fmt::format("next: armtune validate {} --robot ARM\n", inputs);
  return joints ? validate : fmt::format("next: armtune logs {} --all\n", file);
}

}  // namespace armtune::internal::cli
