#include "sim/logs/log_summary.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace armtune::internal {

void TopicAccumulator::add_channel(const std::string& name, const std::string& unit) {
  ChannelSummary& channel = topic_.channels.emplace_back();
  channel.name = name;
  channel.unit = unit;
  present_.push_back(0);
}

void TopicAccumulator::add_time(double time) {
  if (topic_.rows++ == 0) {
    topic_.first = topic_.last = latest_ = time_ = time;
    return;
  }
  if (time == time_) ++topic_.repeated;
  if (time < time_) ++topic_.backward;
  // Steps are measured from the latest time, so that a row that comes late does not make two gaps.
  steps_.add(time - latest_);
  latest_ = std::max(latest_, time);
  topic_.first = std::min(topic_.first, time);
  topic_.last = latest_;
  time_ = time;
}

void TopicAccumulator::add_values(const std::vector<double>& value) {
  const std::size_t count = std::min(value.size(), topic_.channels.size());
  for (std::size_t c = 0; c < count; ++c) {
    if (std::isnan(value[c])) continue;
    ChannelSummary& channel = topic_.channels[c];
    // std::fmin takes the number where the other argument is NaN.
    channel.least = std::fmin(channel.least, value[c]);
    channel.greatest = std::fmax(channel.greatest, value[c]);
    ++present_[c];
  }
  topic_.blocks.add(time_, value);
}

TopicSummary TopicAccumulator::finish() {
  topic_.steps = steps_.summary();
  for (std::size_t c = 0; c < topic_.channels.size(); ++c)
    topic_.channels[c].missing = topic_.rows - present_[c];
  return std::move(topic_);
}

}  // namespace armtune::internal
