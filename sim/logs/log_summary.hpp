#pragma once
// What a log holds: rows, rates, gaps and ranges, computed while the log is read. The memory does not grow
// with the number of rows.

#include <limits>
#include <string>
#include <vector>

#include "sim/logs/motion_blocks.hpp"
#include "sim/logs/row_order.hpp"
#include "sim/logs/step_histogram.hpp"

namespace armtune::internal {

struct ChannelSummary {
  std::string name;
  std::string unit;                                         ///< as the file states it; empty: not stated
  double least = std::numeric_limits<double>::quiet_NaN();  ///< NaN: the channel has no number
  double greatest = std::numeric_limits<double>::quiet_NaN();
  long missing = 0;  ///< rows without a number

  /// True if all of its numbers are equal, or it has none.
  bool constant() const { return !(greatest > least); }
};

struct TopicSummary {
  std::string name;
  std::string type;
  long rows = 0;       ///< rows or messages, also those that could not be decoded
  double first = 0.0;  ///< time of the first and the last row, from LogSummary::start on [s]
  double last = 0.0;
  StepSummary steps;
  long repeated = 0;   ///< rows with the time of the row before, also those that were dropped
  long backward = 0;   ///< rows with a smaller time than the row before, also those that were sorted
  LogRepairs repairs;  ///< of a text log
  std::vector<ChannelSummary> channels;
  std::vector<std::string> labels;  ///< names that the messages give their elements, such as joints
  std::string trouble;              ///< why the messages cannot be decoded; empty: they can
  bool named = true;                ///< false: the file has no names, and channels are called by their number
  MotionBlocks blocks;

  /// The rate of the rows [Hz], from the median step; 0 if there are fewer than two rows.
  double rate() const { return steps.median > 0.0 ? 1.0 / steps.median : 0.0; }
};

struct LogSummary {
  std::vector<std::string> files;  ///< several if text files are read side by side
  std::string description;         ///< how the file was understood, for people
  double start = 0.0;              ///< s on the recorder's clock
  std::vector<TopicSummary> topics;
  std::vector<std::string> notes;  ///< what a user should know, each a sentence
};

/// Summarises the rows of one topic, in the order of their arrival.
class TopicAccumulator {
 public:
  /// Names the next channel. Channels can be added between rows; they are missing in the rows before.
  void add_channel(const std::string& name, const std::string& unit);
  std::size_t channels() const { return topic_.channels.size(); }
  /// Counts a row. time: [s], from any origin.
  void add_time(double time);
  /// Adds the values of the row that was counted last, at most as many as there are channels. Channels
  /// without a value, or with NaN, are missing in this row.
  void add_values(const std::vector<double>& value);
  /// Returns the summary. Its first and last have the same origin as the times of add_time().
  TopicSummary finish();

  /// Returns the summary so far, so that name, type, labels, repairs and trouble can be set.
  TopicSummary& topic() { return topic_; }

 private:
  TopicSummary topic_;
  StepHistogram steps_;
  std::vector<long> present_;  ///< number of rows with a number, one per channel
  double latest_ = 0.0;
  double time_ = 0.0;
};

}  // namespace armtune::internal
