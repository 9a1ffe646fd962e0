#include "sim/rollout/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "sim/csv/text_file.hpp"

namespace armtune {

Recorder::Recorder(const Scenario& scenario, int stride)
    : columns_(rollout_columns(scenario)), stride_(stride), row_(columns_.size()) {
  values_.reserve((static_cast<std::size_t>(scenario.periods() / stride) + 2) * columns_.size());
}

bool Recorder::operator()(const Observation& o) {
  const bool first_of_row = seen_ == 0 || (seen_ - 1) % stride_ == 0;
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const double value = columns_[c].value(o);
    const Over over = columns_[c].over;
    row_[c] = first_of_row || over == Over::kThisPeriod ? value
              : over == Over::kLargest                  ? std::max(row_[c], value)
                                                        : std::min(row_[c], value);
  }
  if (seen_++ % stride_ == 0) values_.insert(values_.end(), row_.begin(), row_.end());
  return true;
}

void Recorder::write_csv(const std::string& path) const {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (std::size_t c = 0; c < columns_.size(); ++c)
    fmt::format_to(out, "{}{}", c ? "," : "", columns_[c].name);
  text.push_back('\n');
  const auto write = [&text, &out](std::span<const double> row) {
    for (std::size_t c = 0; c < row.size(); ++c) fmt::format_to(out, "{}{:.9g}", c ? "," : "", row[c]);
    text.push_back('\n');
  };
  const std::size_t width = columns_.size();
  for (std::size_t i = 0; i < values_.size(); i += width) write(std::span(values_).subspan(i, width));
  if (seen_ > 0 && (seen_ - 1) % stride_ != 0) write(row_);
  write_text_file(path, {text.data(), text.size()});
}

}  // namespace armtune
