#include "sim/logs/log_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "sim/logs/bag_log.hpp"
#include "sim/logs/csv_log.hpp"
#include "sim/logs/open_bag.hpp"

namespace armtune::internal {
namespace {

/// Largest number of skipped columns that a note names.
constexpr std::size_t kNamed = 5;

std::string file_name(const std::vector<std::string>& paths) {
  return std::filesystem::path(paths.front()).filename().string();
}

/// Returns true if the only path is a bag. Throws InputError if one of several is a bag.
bool is_one_bag(const std::vector<std::string>& paths) {
  const auto bag =
      std::find_if(paths.begin(), paths.end(), [](const std::string& path) { return is_bag(path); });
  if (bag == paths.end()) return false;
  if (paths.size() == 1) return true;
  throw InputError(InputPlace{*bag}, "is a bag; only text files are read side by side")
      .with_value({}, "text files");
}

Log read_csv(const std::vector<std::string>& paths, const LogSelection& selection) {
  CsvLog csv(paths, selection.time);
  Log log;
  log.file = paths.front();
  LogTopic& topic = log.topics.emplace_back();
  topic.name = file_name(paths);
  topic.type = "csv";
  topic.channels.resize(csv.channels().size());
  for (std::size_t c = 0; c < topic.channels.size(); ++c) {
    topic.channels[c].name = csv.channels()[c];
    topic.channels[c].unit = csv.units()[c];
  }
  const std::size_t most = kMostLogValues / (topic.channels.size() + 1);
  for (LogRow row; csv.next(row);) {
    if (topic.time.size() >= most)
      throw InputError(
          InputPlace{log.file},
          fmt::format("has more than {} values; split the log, or remove columns", kMostLogValues))
          .with_value({}, fmt::format("at most {} values", kMostLogValues));
    topic.time.push_back(row.time);
    for (std::size_t c = 0; c < topic.channels.size(); ++c) topic.channels[c].value.push_back(row.value[c]);
  }
  if (topic.time.empty())
    throw InputError(InputPlace{log.file}, "holds no rows of numbers").with_value("0", "at least one row");
  const double first = topic.time.front();
  for (double& time : topic.time) time -= first;
  log.start = csv.start() + first;
  return log;
}

void add_notes(const CsvLog& csv, LogSummary& summary) {
  const LogRepairs& repairs = csv.repairs();
  const auto note = [&summary](long count, const char* text) {
    if (count > 0) summary.notes.push_back(fmt::format("{} {}.", count, text));
  };
  note(repairs.repeated, "rows with the time stamp of an earlier row were dropped");
  note(repairs.moved, "rows that were out of order were sorted by time");
  note(repairs.no_time, "rows without a time stamp were dropped");
  note(repairs.cut, "row that was cut off at the end of the file was dropped");
  const std::vector<std::string>& skipped = csv.skipped();
  if (skipped.empty()) return;
  const auto end = skipped.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, skipped.size()));
  const std::string more =
      skipped.size() > kNamed ? fmt::format(" and {} more", skipped.size() - kNamed) : std::string();
  summary.notes.push_back(
      fmt::format("Columns that hold text were skipped: {}{}.", fmt::join(skipped.begin(), end, ", "), more));
}

LogSummary summarize_csv(const std::vector<std::string>& paths, const LogSelection& selection) {
  CsvLog csv(paths, selection.time);
  TopicAccumulator accumulator;
  for (std::size_t c = 0; c < csv.channels().size(); ++c)
    accumulator.add_channel(csv.channels()[c], csv.units()[c]);
  for (LogRow row; csv.next(row);) {
    accumulator.add_time(row.time);
    accumulator.add_values(row.value);
  }
  TopicSummary topic = accumulator.finish();
  if (topic.rows == 0)
    throw InputError(InputPlace{paths.front()}, "holds no rows of numbers")
        .with_value("0", "at least one row");
  topic.name = file_name(paths);
  topic.type = "csv";
  topic.named = csv.has_names();
  topic.repairs = csv.repairs();
  topic.repeated = topic.repairs.repeated;
  topic.backward = topic.repairs.moved;
  LogSummary summary;
  summary.files = paths;
  summary.description = csv.description();
  summary.start = csv.start() + topic.first;
  topic.last -= topic.first;
  topic.first = 0.0;
  summary.topics.push_back(std::move(topic));
  add_notes(csv, summary);
  return summary;
}

}  // namespace

Log read_log(const std::filesystem::path& path, const LogSelection& selection) {
  return read_log(std::vector{path.string()}, selection);
}

Log read_log(const std::vector<std::string>& paths, const LogSelection& selection) {
  if (!is_one_bag(paths)) return read_csv(paths, selection);
  const auto bag = open_bag(paths.front());
  return read_bag(*bag, MessageDefinitions(selection.msg_path), paths.front(), selection);
}

LogSummary summarize_log(const std::filesystem::path& path, const LogSelection& selection) {
  return summarize_log(std::vector{path.string()}, selection);
}

LogSummary summarize_log(const std::vector<std::string>& paths, const LogSelection& selection) {
  if (!is_one_bag(paths)) return summarize_csv(paths, selection);
  const auto bag = open_bag(paths.front());
  return summarize_bag(*bag, MessageDefinitions(selection.msg_path), paths.front(), selection);
}

}  // namespace armtune::internal
