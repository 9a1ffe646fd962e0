#include "sim/rollout/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/csv/cell.hpp"
#include "sim/csv/text_file.hpp"

namespace armtune::internal {
namespace {

/// Combines the values of an earlier and a later period of a row. NaN counts as the worst value and therefore
/// stays.
double folded(Over over, double before, double value) {
  if (over == Over::kThisPeriod || std::isnan(value)) return value;
  if (std::isnan(before)) return before;
  return over == Over::kLargest ? std::max(before, value) : std::min(before, value);
}

}  // namespace

Recorder::Recorder(const Scenario& scenario, int stride)
    : columns_(rollout_columns(scenario)), stride_(stride), row_(columns_.size()) {
  values_.reserve((static_cast<std::size_t>(scenario.periods() / stride) + 2) * columns_.size());
}

bool Recorder::operator()(const Observation& o) {
  const bool first_of_row = seen_ == 0 || (seen_ - 1) % stride_ == 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const double value = columns_[c].value(o);
    row_[c] = first_of_row ? value : folded(columns_[c].over, row_[c], value);
  }
  if (seen_++ % stride_ == 0) values_.insert(values_.end(), row_.begin(), row_.end());
  return true;
}

std::vector<double> Recorder::rows(bool completed) && {
  const std::size_t width = columns_.size();
  const bool behind_last_row = seen_ > 0 && (seen_ - 1) % stride_ != 0;
  if (behind_last_row && completed) {
    double* last = values_.data() + values_.size() - width;
    for (std::size_t c = 0; c < width; ++c) {
      if (columns_[c].over != Over::kThisPeriod) last[c] = folded(columns_[c].over, last[c], row_[c]);
    }
  } else if (behind_last_row) {
    values_.insert(values_.end(), row_.begin(), row_.end());
  }
  return std::move(values_);
}

void Recorder::write_csv(const std::string& path, bool completed) const {
  const std::vector<double> values = rows(completed);
  const std::size_t width = columns_.size();
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (std::size_t c = 0; c < width; ++c) fmt::format_to(out, "{}{}", c ? "," : "", columns_[c].name);
  text.push_back('\n');
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % width != 0) text.push_back(',');
    const std::string written = cell(values[i]);
    text.append(written.data(), written.data() + written.size());
    if ((i + 1) % width == 0) text.push_back('\n');
  }
  write_text_file(path, {text.data(), text.size()});
}

}  // namespace armtune::internal
