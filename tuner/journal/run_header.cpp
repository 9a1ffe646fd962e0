#include "tuner/journal/run_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "core/common/message_text.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostTold = 3;
constexpr std::size_t kLongestLine = 300;

std::string beginning(const std::string& line) {
  return one_line(line.size() <= kLongestLine ? line : line.substr(0, kLongestLine) + "...");
}

/// Returns the first lines in which two texts differ. A text that ends first gives "(nothing)".
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

std::string differences(const RunHeader& was, const RunHeader& is,
                        const std::function<std::optional<std::string>(const std::string& value)>& copy_of) {
  std::string text;
  std::size_t told = 0;
  const auto tell = [&](const std::string& name, const std::string& before, const std::string& now) {
    if (++told > kMostTold) return;
    if (name == RunHeader::kProgram) {
      text += fmt::format("{}this program is another build than the one that started the run",
                          text.empty() ? "" : "; ");
      return;
    }
    const auto [line_before, line_now] = first_difference(before, now);
    text += fmt::format("{}{} was '{}', is '{}'", text.empty() ? "" : "; ", one_line(name),
                        beginning(line_before), beginning(line_now));
    if (const auto copy = copy_of ? copy_of(before) : std::nullopt)
      text += fmt::format(" (the original content is in {})", *copy);
  };
  // Entries are compared by name and value, because a name may occur more than once. Only entries that one of
  // the two headers lacks are reported.
  using Identity = decltype(RunHeader::identity);
  const auto has = [](const Identity& all, const auto& entry) {
    return std::find(all.begin(), all.end(), entry) != all.end();
  };
  const auto other_of_name = [&](const Identity& all, const Identity& others, const std::string& name) {
    return std::find_if(all.begin(), all.end(),
                        [&](const auto& entry) { return entry.first == name && !has(others, entry); });
  };
  for (const auto& entry : was.identity) {
    if (has(is.identity, entry)) continue;
    const auto now = other_of_name(is.identity, was.identity, entry.first);
    tell(entry.first, entry.second, now == is.identity.end() ? "" : now->second);
  }
  for (const auto& entry : is.identity) {
    if (has(was.identity, entry)) continue;
    if (other_of_name(was.identity, is.identity, entry.first) == was.identity.end())
      tell(entry.first, "", entry.second);
  }
  if (told > kMostTold) text += fmt::format("; and {} more", told - kMostTold);
  return text;
}

}  // namespace armtune::internal
