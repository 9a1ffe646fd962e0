#include "sim/logs/time_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace armtune::internal {
namespace {

/// Names of time columns in lower case, without anything but letters, in order of preference.
constexpr std::array kTimeNames = {
    "headerstamp", "fieldheaderstamp", "time",    "timestamp",  "t",           "stamp",   "times",    "ts",
    "robottime",   "rostime",          "simtime", "systemtime", "elapsedtime", "elapsed", "unixtime", "epoch",
    "clock",       "datetime",         "date",    "zeit"};

std::string letters_of(std::string_view name) {
  std::string letters;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalpha(byte) != 0) letters += static_cast<char>(std::tolower(byte));
  }
  return letters;
}

struct UnitWord {
  std::string_view word;
  TimeUnit unit;
};

/// Endings of names after a separator, as in time_ms.
constexpr UnitWord kUnitWords[] = {
    {"nanoseconds", TimeUnit::kNanoseconds},
    {"nanosec", TimeUnit::kNanoseconds},
    {"nsecs", TimeUnit::kNanoseconds},
    {"nsec", TimeUnit::kNanoseconds},
    {"ns", TimeUnit::kNanoseconds},
    {"microseconds", TimeUnit::kMicroseconds},
    {"usec", TimeUnit::kMicroseconds},
    {"us", TimeUnit::kMicroseconds},
    {"milliseconds", TimeUnit::kMilliseconds},
    {"millis", TimeUnit::kMilliseconds},
    {"msec", TimeUnit::kMilliseconds},
    {"ms", TimeUnit::kMilliseconds},
    {"seconds", TimeUnit::kSeconds},
    {"secs", TimeUnit::kSeconds},
    {"sec", TimeUnit::kSeconds},
    {"s", TimeUnit::kSeconds},
};

/// Returns the letters of a name without the unit at its end, and that unit.
std::pair<std::string, std::optional<TimeUnit>> split_unit(const std::string& name) {
  const std::size_t end = name.find_last_not_of(" ])");
  const std::size_t mark = end == std::string::npos ? end : name.find_last_of("_ .-/[(", end);
  if (mark != std::string::npos) {
    const std::string last = letters_of(name.substr(mark));
    for (const UnitWord& known : kUnitWords) {
      if (last == known.word) return {letters_of(name.substr(0, mark)), known.unit};
    }
  }
  return {letters_of(name), std::nullopt};
}

/// Returns the column with the seconds that belong to a column of nanoseconds.
std::optional<std::size_t> partner_of(std::size_t nanoseconds, const std::vector<std::string>& names) {
  const auto [stem, unit] = split_unit("_" + names[nanoseconds]);
  if (unit != TimeUnit::kNanoseconds) return std::nullopt;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto [other, other_unit] = split_unit("_" + names[c]);
    if (other == stem && other_unit == TimeUnit::kSeconds) return c;
  }
  return std::nullopt;
}

bool is_time_stem(const std::string& stem) {
  return std::any_of(kTimeNames.begin(), kTimeNames.end(), [&](const char* known) {
    return stem == known || (std::string_view(known).size() > 4 && stem.ends_with(known));
  });
}

std::optional<NamedTime> find_pair(const std::vector<std::string>& names) {
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto partner = partner_of(c, names);
    const std::string stem = split_unit("_" + names[c]).first;
    if (partner && (stem.empty() || is_time_stem(stem))) return NamedTime{*partner, c, TimeUnit::kSeconds};
  }
  return std::nullopt;
}

}  // namespace

NamedTime find_named_time(const std::vector<std::string>& names) {
  if (const auto pair = find_pair(names)) return *pair;
  for (const std::string_view known : kTimeNames) {
    for (std::size_t c = 0; c < names.size(); ++c) {
      const auto [stem, unit] = split_unit(names[c]);
      const bool stamp = known == "headerstamp" && stem.ends_with(known);
      if (stem != known && !stamp) continue;
      return {c, std::nullopt, unit};
    }
  }
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (is_time_stem(split_unit(names[c]).first)) return {c, std::nullopt, stated_time_unit(names[c])};
  }
  return {};
}

std::optional<TimeUnit> stated_time_unit(const std::string& name) {
  return split_unit(name).second;
}

bool ends_with_time(const std::string& name) {
  const std::size_t mark = name.find_last_of("_ .-/");
  return mark != std::string::npos && letters_of(name.substr(mark)) == "time";
}

}  // namespace armtune::internal
