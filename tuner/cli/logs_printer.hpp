#pragma once
// Tables of what a log holds, for a terminal of 80 columns.

#include <string>

#include "sim/logs/log_summary.hpp"

namespace armtune::internal::cli {

/// Returns the table of topics, the tables of channels and the notes. Without `all`, similar channels are one
/// row, and topics in which no quantity of a robot was recognised have no table of channels, unless the log
/// has only one topic.
std::string log_text(const LogSummary& summary, bool all);

/// Returns what the user can do next with this log, as one line "next: armtune ...".
std::string next_step(const LogSummary& summary);

}  // namespace armtune::internal::cli
