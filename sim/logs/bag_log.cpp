#include "sim/logs/bag_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "sim/logs/bag_rows.hpp"
#include "sim/logs/log_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

/// Names the channels that a decoder has found since the last call.
void add_new_channels(const MessageDecoder& decoder, TopicAccumulator& topic) {
  for (std::size_t c = topic.channels(); c < decoder.paths().size(); ++c)
    topic.add_channel(decoder.paths()[c], decoder.units()[c]);
}

void describe(const BagTopic& known, const BagRows::Topic& topic, TopicSummary& summary) {
  summary.name = known.name;
  summary.type = known.type;
  if (topic.decoder) summary.labels = topic.decoder->labels();
  if (topic.trouble) {
    const bool all = topic.refused >= summary.rows;
    summary.trouble = all ? topic.trouble->what()
                          : fmt::format("{} of {} messages could not be decoded. The first one: {}",
                                        topic.refused, summary.rows, topic.trouble->what());
  }
}

void note_clock(const BagRows::Topic& topic, const std::string& name, LogSummary& summary) {
  if (!topic.shift || *topic.shift == 0) return;
  summary.notes.push_back(fmt::format(
      "The time stamps of {} are from another clock than the recording; {:.6g} s were added to them.", name,
      1e-9 * static_cast<double>(*topic.shift)));
}

/// Puts the rows of a topic in the order of time.
void sort_rows(LogTopic& topic, const std::string& file) {
  if (std::is_sorted(topic.time.begin(), topic.time.end())) return;
  std::vector<std::size_t> order(topic.time.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&topic](std::size_t a, std::size_t b) { return topic.time[a] < topic.time[b]; });
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (order[k] <= k + RepairBounds::kWindow) continue;
    throw InputError(
        InputPlace{file, 0, topic.name},
        fmt::format("the time stamps of {} jump back at message {}; if the sender was restarted, record "
                    "the parts in separate bags",
                    topic.name, order[k] + 1))
        .with_value(fmt::to_string(order[k] - k),
                    fmt::format("messages that are at most {} messages too late", RepairBounds::kWindow));
  }
  std::vector<double> sorted(order.size());
  const auto put = [&](std::vector<double>& values) {
    for (std::size_t k = 0; k < order.size(); ++k) sorted[k] = values[order[k]];
    values.swap(sorted);
  };
  put(topic.time);
  for (LogChannel& channel : topic.channels) put(channel.value);
}

/// Keeps the values of all selected topics.
class BagMemory {
 public:
  BagMemory(const std::string& file, std::vector<LogTopic>& topics) : file_(file), topics_(topics) {}

  void add(const BagRows::Row& row, const MessageDecoder& decoder) {
    if (topics_.size() <= row.topic) topics_.resize(row.topic + 1);
    LogTopic& topic = topics_[row.topic];
    const std::size_t rows = topic.time.size();
    const std::size_t before = topic.channels.size();
    const std::size_t channels = decoder.paths().size();
    count((channels - before) * rows + channels + 1);
    for (std::size_t c = before; c < channels; ++c) {
      LogChannel& channel = topic.channels.emplace_back();
      channel.name = decoder.paths()[c];
      channel.unit = decoder.units()[c];
      channel.value.assign(rows, kMissing);
    }
    topic.time.push_back(row.time);
    for (std::size_t c = 0; c < channels; ++c)
      topic.channels[c].value.push_back(c < row.message->values.size() ? row.message->values[c] : kMissing);
  }

 private:
  void count(std::size_t values) {
    values_ += values;
    if (values_ <= kMostLogValues) return;
    throw InputError(
        InputPlace{file_, 0, "--topic"},
        fmt::format("has more than {} values; read fewer topics with --topic PATTERN", kMostLogValues))
        .with_value({}, fmt::format("at most {} values", kMostLogValues));
  }

  const std::string& file_;
  std::vector<LogTopic>& topics_;
  std::size_t values_ = 0;
};

/// Makes the smallest time of all topics the start of the log.
void move_start(Log& log, double origin) {
  double least = std::numeric_limits<double>::infinity();
  for (const LogTopic& topic : log.topics) least = std::min(least, topic.time.front());
  for (LogTopic& topic : log.topics) {
    for (double& time : topic.time) time -= least;
  }
  log.start = origin + least;
}

}  // namespace

LogSummary summarize_bag(BagReader& bag, const MessageDefinitions& definitions, const std::string& file,
                         const LogSelection& selection) {
  BagRows rows(bag, definitions, file, selection);
  std::vector<TopicAccumulator> topics;
  while (const auto row = rows.next()) {
    while (topics.size() <= row->topic) topics.emplace_back();
    TopicAccumulator& topic = topics[row->topic];
    topic.add_time(row->time);
    if (row->message == nullptr) continue;
    add_new_channels(*rows.topic(row->topic).decoder, topic);
    topic.add_values(row->message->values);
  }
  LogSummary summary;
  summary.files = {file};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rows.topics(); ++i) {
    if (!rows.topic(i).selected) continue;
    TopicSummary topic = i < topics.size() ? topics[i].finish() : TopicSummary();
    describe(bag.topics()[i], rows.topic(i), topic);
    note_clock(rows.topic(i), topic.name, summary);
    if (topic.rows > 0) least = std::min(least, topic.first);
    summary.topics.push_back(std::move(topic));
  }
  if (summary.topics.empty()) rows.refuse_selection();
  if (bag.unfinished()) {
    summary.notes.emplace_back(
        "The recorder did not finish the file; what it had written until then was read.");
  }
  if (least > std::numeric_limits<double>::max()) least = 0.0;
  for (TopicSummary& topic : summary.topics) {
    topic.first -= least;
    topic.last -= least;
  }
  summary.start = rows.clock().start() + least;
  summary.description =
      fmt::format("a bag with {} topic{}", bag.topics().size(), bag.topics().size() == 1 ? "" : "s");
  return summary;
}

Log read_bag(BagReader& bag, const MessageDefinitions& definitions, const std::string& file,
             const LogSelection& selection) {
  BagRows rows(bag, definitions, file, selection);
  std::vector<LogTopic> topics;
  BagMemory memory(file, topics);
  while (const auto row = rows.next()) {
    const BagRows::Topic& topic = rows.topic(row->topic);
    if (topic.trouble) throw InputError(*topic.trouble);
    memory.add(*row, *topic.decoder);
  }
  Log log;
  log.file = file;
  bool any = false;
  for (std::size_t i = 0; i < rows.topics(); ++i) {
    any = any || rows.topic(i).selected;
    if (i >= topics.size() || topics[i].channels.empty()) continue;
    LogTopic& topic = topics[i];
    topic.name = bag.topics()[i].name;
    topic.type = bag.topics()[i].type;
    topic.labels = rows.topic(i).decoder->labels();
    sort_rows(topic, file);
    log.topics.push_back(std::move(topic));
  }
  if (!any) rows.refuse_selection();
  if (!log.topics.empty()) move_start(log, rows.clock().start());
  return log;
}

}  // namespace armtune::internal
