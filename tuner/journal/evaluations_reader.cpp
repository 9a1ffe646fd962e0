#include "tuner/journal/evaluations_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include "core/common/error.hpp"

namespace armtune {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      found.emplace_back();
    } else {
      found.back() += c;
    }
  }
  return found;
}

}  // namespace

std::vector<EvaluationRow> read_evaluations(const std::string& path, const Study& study) {
  std::ifstream file(path);
  if (!file) throw InputError(path + ": cannot be read; a run folder of armtune tune holds it");
  std::string line;
  std::getline(file, line);
  const auto header = cells(line);
  const auto column = [&](const std::string& name) {
    const auto found = std::find(header.begin(), header.end(), name);
    if (found == header.end()) {
      throw InputError(
          fmt::format("{}:1: no column '{}', which evaluations of {} have", path, name, study.source));
    }
    return static_cast<std::size_t>(found - header.begin());
  };
  const std::size_t objective = column("objective");
  const std::size_t violation = column("violation");
  std::vector<std::size_t> parameters;
  parameters.reserve(study.space.free.size());
  for (const Parameter& p : study.space.free) parameters.push_back(column(p.entry.name));

  std::vector<EvaluationRow> rows;
  for (std::size_t number = 2; std::getline(file, line); ++number) {
    if (file.eof()) break;  // no line end: the run was killed while it wrote this row
    const auto row = cells(line);
    if (row.size() != header.size()) {
      throw InputError(
          fmt::format("{}:{}: {} cells where the header has {}", path, number, row.size(), header.size()));
    }
    const auto read = [&](std::size_t c) {
      double value = NAN;
      const char* end = row[c].data() + row[c].size();
      if (std::from_chars(row[c].data(), end, value).ptr != end || !std::isfinite(value)) {
        throw InputError(
            fmt::format("{}:{}: '{}' in column {} is no finite number", path, number, row[c], header[c]));
      }
      return value;
    };
    if (row[objective].empty()) continue;  // given up: nothing is known of it
    Gains gains = study.space.start;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      value(gains, study.space.free[i].entry) = read(parameters[i]);
    }
    rows.push_back({study.space.point_of(gains), read(objective), read(violation)});
  }
  return rows;
}

}  // namespace armtune
