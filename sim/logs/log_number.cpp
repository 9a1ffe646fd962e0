#include "sim/logs/log_number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

namespace armtune::internal {
namespace {

constexpr double kLargestStamp = 4e18;  ///< the difference of two stamps fits into 64 bits

bool same_word(std::string_view text, std::string_view word) {
  return std::equal(text.begin(), text.end(), word.begin(), word.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; });
}

/// Returns all of the text as a number of type T, or nothing.
template <typename T>
std::optional<T> parsed(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

/// Returns the text with its only comma as a decimal point, or as it is if it has no comma or also a point.
std::string with_point(std::string_view text) {
  std::string copy(text);
  const auto comma = std::find(copy.begin(), copy.end(), ',');
  if (comma != copy.end() && copy.find('.') == std::string::npos) *comma = '.';
  return copy;
}

std::optional<Stamp> plain_stamp(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const auto whole = parsed<std::int64_t>(text.substr(0, point));
  if (!whole || text.starts_with('-') || static_cast<double>(*whole) >= kLargestStamp) return std::nullopt;
  double fraction = 0.0;
  if (point + 1 < text.size()) {
    const std::string_view digits = text.substr(point + 1);
    if (digits.find_first_not_of("0123456789") != std::string_view::npos) return std::nullopt;
    fraction = parsed<double>("0." + std::string(digits)).value_or(0.0);
  }
  return negative ? Stamp{-*whole, -fraction} : Stamp{*whole, fraction};
}

std::optional<Stamp> date_stamp(std::string_view text) {
  if (text.size() < 19 || text[4] != '-' || text[7] != '-' || text[13] != ':' || text[16] != ':') return {};
  if (text[10] != 'T' && text[10] != ' ') return {};
  std::array<int, 5> part{};
  constexpr std::array<std::size_t, 5> kBegin = {5, 8, 11, 14, 17};
  const auto year = parsed<int>(text.substr(0, 4));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const auto value = parsed<int>(text.substr(kBegin[i], 2));
    if (!value || *value < 0) return {};
    part[i] = *value;
  }
  std::string_view rest = text.substr(19);
  if (rest.ends_with('Z')) rest.remove_suffix(1);
  const auto date = std::chrono::year(year.value_or(0)) / part[0] / part[1];
  if (!year || !date.ok() || part[2] > 23 || part[3] > 59 || part[4] > 60) return {};
  const auto second = plain_stamp("0" + std::string(rest));
  if (!second || second->whole != 0) return {};
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return Stamp{((days * 24 + part[2]) * 60 + part[3]) * 60 + part[4], second->fraction};
}

}  // namespace

std::optional<double> read_log_number(std::string_view cell, bool decimal_comma) {
  constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();
  cell = without_plus(cell);
  const auto value = decimal_comma ? parsed<double>(with_point(cell)) : parsed<double>(cell);
  if (value) return std::isfinite(*value) ? *value : kMissing;
  if (cell.empty()) return kMissing;
  for (const std::string_view word : {"nan", "null", "none", "n/a", "na", "-"}) {
    if (same_word(cell, word)) return kMissing;
  }
  if (same_word(cell, "true")) return 1.0;
  if (same_word(cell, "false")) return 0.0;
  return std::nullopt;
}

std::optional<Stamp> read_stamp(std::string_view cell, bool decimal_comma) {
  if (const auto date = date_stamp(cell)) return date;
  const std::string text = decimal_comma ? with_point(without_plus(cell)) : std::string(without_plus(cell));
  if (const auto plain = plain_stamp(text)) return plain;
  const auto value = parsed<double>(text);
  if (!value || !(std::abs(*value) < kLargestStamp)) return std::nullopt;
  const double whole = std::trunc(*value);
  return Stamp{static_cast<std::int64_t>(whole), *value - whole};
}

bool is_date(std::string_view cell) {
  return date_stamp(cell).has_value();
}

}  // namespace armtune::internal
