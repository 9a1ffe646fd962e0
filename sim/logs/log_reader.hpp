#pragma once
// Reads what a robot recorded: a CSV file, several CSV files side by side, or a bag.
//
//     const Log log = read_log("run.mcap", {.topics = {"/joint_states"}});
//     const LogSummary summary = summarize_log("run.csv", {});

#include <filesystem>
#include <string>
#include <vector>

#include "sim/logs/log.hpp"
#include "sim/logs/log_selection.hpp"
#include "sim/logs/log_summary.hpp"

namespace armtune::internal {

/// Largest number of values of a log that are kept in memory. They take 320 MB.
inline constexpr std::size_t kMostLogValues = 40'000'000;

/// Reads a log into memory. A bag (is_bag in open_bag.hpp) is read as read_bag does, any other file as CsvLog
/// does. Throws InputError as these do, and with the file if there are more than kMostLogValues values.
Log read_log(const std::filesystem::path& path, const LogSelection& selection);

/// Reads several text files side by side as one log (joined_tables.hpp). One path is read as above. Throws
/// InputError with the file if one of several is a bag.
Log read_log(const std::vector<std::string>& paths, const LogSelection& selection);

/// Summarises a log. The memory does not grow with its length. Throws InputError as read_log does, but a log
/// may have any number of values, and messages that cannot be decoded are only counted.
LogSummary summarize_log(const std::filesystem::path& path, const LogSelection& selection);

/// Does the same for several text files side by side.
LogSummary summarize_log(const std::vector<std::string>& paths, const LogSelection& selection);

}  // namespace armtune::internal
