#include "sim/logs/time_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"
#include "sim/logs/channel_words.hpp"
#include "sim/logs/time_names.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kSurveyedRows = 1000;
/// Number of columns at the start of a row among which the time is sought if no name fits.
constexpr std::size_t kUnnamed = 3;
/// Smallest share of steps that are near the median in a column that is taken for the time by its values.
constexpr double kEven = 0.9;
/// Longest median step [s] of a robot's log.
constexpr double kLongestStep = 0.5;

struct Steps {
  double first = 0.0;   ///< the first stamp
  double median = 0.0;  ///< of the steps
  bool increasing = false;
  bool even = false;    ///< most steps are between half and twice the median
  bool counts = false;  ///< all steps are 1
};

Steps measure(const std::vector<Stamp>& stamps) {
  if (stamps.size() < 3) return {};
  Steps steps;
  steps.first = static_cast<double>(stamps[0].whole) + stamps[0].fraction;
  std::vector<double> step;
  for (std::size_t k = 1; k < stamps.size(); ++k) step.push_back(stamps[k] - stamps[k - 1]);
  const auto share = [&step](auto&& holds) {
    return static_cast<double>(std::count_if(step.begin(), step.end(), holds)) /
           static_cast<double>(step.size());
  };
  const auto middle = step.begin() + static_cast<std::ptrdiff_t>(step.size() / 2);
  std::nth_element(step.begin(), middle, step.end());
  const double median = *middle;
  steps.median = median;
  steps.increasing = share([](double s) { return s > 0.0; }) >= kEven;
  steps.even = share([median](double s) { return s >= 0.5 * median && s <= 2.0 * median; }) >= kEven;
  steps.counts = share([](double s) { return s == 1.0; }) >= 1.0;
  return steps;
}

/// The stamps of some columns in the first rows.
using Surveyed = std::vector<std::vector<Stamp>>;

Surveyed survey(TableRows& rows, const std::vector<TimeColumns>& candidates) {
  Surveyed stamps(candidates.size());
  for (std::size_t k = 0; k < kSurveyedRows && rows.next(); ++k) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (const auto stamp = candidates[i].stamp(rows.cells(), rows.decimal_comma()))
        stamps[i].push_back(*stamp);
    }
  }
  return stamps;
}

[[noreturn]] void refuse_without_time(const TableRows& rows) {
  throw InputError(InputPlace{rows.file(), 0, "--rate"},
                   "no column holds the time; give the rate of the rows with --rate HZ, or name the column "
                   "with --time NAME")
      .with_value({}, "a column such as time, t or timestamp");
}

std::size_t column_called(const std::string& name, const TableRows& rows) {
  const auto& names = rows.names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw InputError(InputPlace{rows.file(), 0, "--time"},
                   fmt::format("there is no column {}{}", shown(name), suggestion(name, names)))
      .with_value(name, "the name of a column");
}

/// Finds the unit from the values, if neither the file nor the user states it.
TimeUnit likely_unit(const Steps& steps, const char*& why) {
  constexpr std::array kUnits = {TimeUnit::kSeconds, TimeUnit::kMilliseconds, TimeUnit::kMicroseconds,
                                 TimeUnit::kNanoseconds};
  why = "the size of Unix time stamps";
  for (const TimeUnit unit : kUnits) {
    // Unix time stamps between 2001 and 2286.
    const double s = steps.first * seconds(unit);
    if (s >= 1e9 && s < 1e10) return unit;
  }
  why = "the time between rows";
  for (const TimeUnit unit : kUnits) {
    if (steps.median * seconds(unit) <= kLongestStep) return unit;
  }
  return TimeUnit::kNanoseconds;
}

TimeColumns with_unit(TimeColumns found, const Steps& steps, std::optional<TimeUnit> unit,
                      const TableRows& rows) {
  const char* why = "as stated";
  if (!unit) unit = likely_unit(steps, why);
  found.scale = seconds(*unit);
  found.reason =
      fmt::format("time from column {} in {} ({})", shown(rows.names()[*found.column]), symbol(*unit), why);
  if (found.nanoseconds)
    found.reason += fmt::format(", and {} in ns", shown(rows.names()[*found.nanoseconds]));
  return found;
}

/// Takes the time from the values of the first columns.
TimeColumns find_by_values(TableRows& rows, const TimeOptions& options) {
  std::vector<TimeColumns> candidates;
  for (std::size_t c = 0; c < rows.names().size(); ++c) {
    if (ends_with_time(rows.names()[c])) candidates.emplace_back().column = c;
  }
  for (std::size_t c = 0; c < std::min(kUnnamed, rows.names().size()); ++c) {
    const bool other = rows.has_names() && words_of(rows.names()[c]).quantity != Quantity::kUnknown;
    if (!other) candidates.emplace_back().column = c;
  }
  const Surveyed stamps = survey(rows, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Steps steps = measure(stamps[i]);
    if (!steps.increasing || !steps.even || steps.counts) continue;
    TimeColumns found = with_unit(candidates[i], steps, options.unit, rows);
    found.reason += ", because the column increases evenly";
    return found;
  }
  refuse_without_time(rows);
}

}  // namespace

double seconds(TimeUnit unit) {
  constexpr std::array kSeconds = {1.0, 1e-3, 1e-6, 1e-9};
  return kSeconds[static_cast<std::size_t>(unit)];
}

const char* symbol(TimeUnit unit) {
  constexpr std::array kSymbols = {"s", "ms", "us", "ns"};
  return kSymbols[static_cast<std::size_t>(unit)];
}

std::optional<TimeUnit> time_unit(std::string_view text) {
  for (const TimeUnit unit :
       {TimeUnit::kSeconds, TimeUnit::kMilliseconds, TimeUnit::kMicroseconds, TimeUnit::kNanoseconds}) {
    if (text == symbol(unit)) return unit;
  }
  return std::nullopt;
}

std::optional<Stamp> TimeColumns::stamp(const std::vector<std::string_view>& cells,
                                        bool decimal_comma) const {
  if (!column) return std::nullopt;
  auto stamp = read_stamp(cells[*column], decimal_comma);
  if (!stamp || !nanoseconds) return stamp;
  const auto fraction = read_stamp(cells[*nanoseconds], decimal_comma);
  if (!fraction) return std::nullopt;
  stamp->fraction += 1e-9 * (static_cast<double>(fraction->whole) + fraction->fraction);
  return stamp;
}

TimeColumns find_time_columns(TableRows& rows, const TimeOptions& options) {
  if (options.rate) {
    if (!(*options.rate > 0.0) || !std::isfinite(*options.rate))
      throw InputError(InputPlace{.key = "--rate"},
                       {.problem = fmt::format("the rate is {} Hz", *options.rate),
                        .value = fmt::to_string(*options.rate),
                        .limit = "above zero"});
    return {.column = {},
            .nanoseconds = {},
            .scale = 1.0 / *options.rate,
            .reason = fmt::format("rows at {} Hz, as stated", *options.rate)};
  }
  NamedTime named = find_named_time(rows.names());
  if (!options.column.empty())
    named = {column_called(options.column, rows), {}, stated_time_unit(options.column)};
  if (!named.column) return find_by_values(rows, options);
  const std::string& stated = rows.units()[*named.column];
  TimeColumns found{.column = named.column, .nanoseconds = named.nanoseconds, .scale = 1.0, .reason = {}};
  const std::vector<Stamp> stamps = survey(rows, {found}).front();
  std::optional<TimeUnit> unit = options.unit;
  if (!unit) unit = named.unit;
  if (!unit) unit = time_unit(stated);
  return with_unit(found, measure(stamps), unit, rows);
}

}  // namespace armtune::internal
