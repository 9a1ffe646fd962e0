#pragma once
// Reads the messages of a bag as numbers against time.

#include <string>

#include "sim/logs/bag.hpp"
#include "sim/logs/log.hpp"
#include "sim/logs/log_selection.hpp"
#include "sim/logs/log_summary.hpp"
#include "sim/logs/message_definitions.hpp"

namespace armtune::internal {

/// Summarises the selected topics of a bag in bounded memory. file: for messages. Messages that cannot be
/// decoded are counted, and TopicSummary::trouble says why. Throws InputError as BagReader::next does, and
/// with file and key `--topic` if the bag has no selected topic.
LogSummary summarize_bag(BagReader& bag, const MessageDefinitions& definitions, const std::string& file,
                         const LogSelection& selection);

/// Reads the selected topics of a bag. The rows of a topic are sorted by time, as long as no row must be
/// moved by more than RepairBounds::kWindow rows. Of messages with equal stamps, all are kept. Topics without
/// numbers are left out. Throws InputError as BagReader::next does, and
///   - with the file, and the topic as key, if a message of a selected topic cannot be decoded, or if its
///     time runs back too far,
///   - with file and key `--topic` if the bag has no selected topic, or more than kMostLogValues values.
Log read_bag(BagReader& bag, const MessageDefinitions& definitions, const std::string& file,
             const LogSelection& selection);

}  // namespace armtune::internal
