#include "sim/rollout/recorder.hpp"

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"

namespace armtune {

Recorder::Recorder(const Scenario& scenario, int stride)
    : columns_(rollout_columns(scenario)), stride_(stride) {
  values_.reserve((static_cast<std::size_t>(scenario.periods() / stride) + 1) * columns_.size());
}

bool Recorder::operator()(const Observation& o) {
  if (seen_++ % stride_ == 0) {
    for (const Column& column : columns_) values_.push_back(column.value(o));
  }
  return true;
}

void Recorder::write_csv(const std::string& path) const {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (std::size_t c = 0; c < columns_.size(); ++c)
    fmt::format_to(out, "{}{}", c ? "," : "", columns_[c].name);
  text.push_back('\n');
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (i % columns_.size() != 0) text.push_back(',');
    fmt::format_to(out, "{:.9g}", values_[i]);
    if ((i + 1) % columns_.size() == 0) text.push_back('\n');
  }
  write_text_file(path, {text.data(), text.size()});
}

}  // namespace armtune
