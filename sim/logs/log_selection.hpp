#pragma once
// Selects the part of a recording that is read, and holds what the user says about the recording.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/time_column.hpp"

namespace armtune::internal {

struct LogSelection {
  /// Patterns of topics, in which * stands for any text and ? for any character; a topic is read if one of
  /// them matches. Empty: all topics. The rows of a text log are always read.
  std::vector<std::string> topics;
  TimeOptions time;                ///< of text logs
  std::filesystem::path msg_path;  ///< folder with definitions of messages; empty: none
};

/// True if the pattern matches all of the text.
bool matches_pattern(std::string_view pattern, std::string_view text);

/// True if the topic is to be read.
bool is_selected(const LogSelection& selection, std::string_view topic);

}  // namespace armtune::internal
