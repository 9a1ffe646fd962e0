#include "sim/cell/mesh_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace armtune::internal {
namespace {

constexpr std::string_view kBlank = " \t\r\v\f";

}  // namespace

bool MeshLines::next() {
  while (!rest_.empty()) {
    const std::size_t end = rest_.find('\n');
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
    words_.clear();
    for (std::size_t at = text.find_first_not_of(kBlank); at != std::string_view::npos;
         at = text.find_first_not_of(kBlank)) {
      text.remove_prefix(at);
      const std::string_view word = text.substr(0, text.find_first_of(kBlank));
      text.remove_prefix(word.size());
      words_.push_back(word);
      if (words_.size() == kMostWords) break;
    }
    if (!words_.empty()) return true;
  }
  return false;
}

std::string MeshLines::at_line(const std::string& what) const {
  return fmt::format("line {}: {}", line_, what);
}

std::optional<float> coordinate(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  if (!(std::abs(value) <= double{std::numeric_limits<float>::max()})) return std::nullopt;  // or NaN
  return static_cast<float>(value);
}

bool append_point(const std::vector<std::string_view>& words, std::vector<float>& coordinates) {
  if (words.size() < 4) return false;
  for (std::size_t i = 1; i < 4; ++i) {
    const auto value = coordinate(words[i]);
    if (!value) return false;
    coordinates.push_back(*value);
  }
  return true;
}

std::string shown_word(std::string_view word) {
  constexpr std::size_t kMost = 40;
  std::string shown(word.substr(0, kMost));
  std::replace_if(
      shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return fmt::format("'{}'", shown);
}

}  // namespace armtune::internal
