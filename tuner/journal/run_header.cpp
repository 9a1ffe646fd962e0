#include "tuner/journal/run_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace armtune {
namespace {

/// The first lines of two texts that differ; a text that ends first gives "(nothing)".
std::pair<std::string, std::string> first_difference(const std::string& a, const std::string& b) {
  std::istringstream lines_a(a);
  std::istringstream lines_b(b);
  std::string line_a;
  std::string line_b;
  for (;;) {
    const bool has_a = static_cast<bool>(std::getline(lines_a, line_a));
    const bool has_b = static_cast<bool>(std::getline(lines_b, line_b));
    if (!has_a) line_a = "(nothing)";
    if (!has_b) line_b = "(nothing)";
    if (line_a != line_b || (!has_a && !has_b)) return {line_a, line_b};
  }
}

}  // namespace

std::string differences(const RunHeader& was, const RunHeader& is) {
  std::string text;
  const auto tell = [&text](const std::string& name, const std::string& before, const std::string& now) {
    if (name == RunHeader::kProgram) {
      text += fmt::format("{}the program is another build than the one that began the run",
                          text.empty() ? "" : "; ");
      return;
    }
    const auto [line_before, line_now] = first_difference(before, now);
    text += fmt::format("{}{} was '{}', is '{}'", text.empty() ? "" : "; ", name, line_before, line_now);
  };
  const auto find = [](const RunHeader& header, const std::string& name) {
    return std::find_if(header.identity.begin(), header.identity.end(),
                        [&name](const auto& entry) { return entry.first == name; });
  };
  for (const auto& entry : was.identity) {
    const auto now = find(is, entry.first);
    if (now == is.identity.end()) {
      tell(entry.first, entry.second, "");
    } else if (now->second != entry.second) {
      tell(entry.first, entry.second, now->second);
    }
  }
  for (const auto& entry : is.identity) {
    if (find(was, entry.first) == was.identity.end()) tell(entry.first, "", entry.second);
  }
  return text;
}

}  // namespace armtune
