#include "sim/logs/bag_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/common/message_text.hpp"
#include "core/common/nearest.hpp"

namespace armtune::internal {
namespace {

constexpr std::int64_t kMinute = 60'000'000'000;
/// Number of different clocks of senders that are told apart.
constexpr std::size_t kMostClocks = 100;

/// Returns a - b. Times of a damaged file may be so large that the difference wraps around.
std::int64_t difference(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

bool is_near(std::int64_t a, std::int64_t b) {
  const std::int64_t apart = difference(a, b);
  return apart >= -kMinute && apart <= kMinute;
}

}  // namespace

double MessageClock::time(std::optional<std::int64_t> stamp, std::int64_t recorded,
                          std::optional<std::int64_t>& shift) {
  if (!first_) first_ = recorded;
  if (!stamp) return 1e-9 * static_cast<double>(difference(recorded, *first_));
  if (!shift) {
    const std::int64_t apart = difference(recorded, *stamp);
    shift = 0;
    if (!is_near(apart, 0)) {
      const auto known =
          std::find_if(shifts_.begin(), shifts_.end(), [&](std::int64_t s) { return is_near(s, apart); });
      shift = known == shifts_.end() ? apart : *known;
      if (known == shifts_.end() && shifts_.size() < kMostClocks) shifts_.push_back(apart);
    }
  }
  return 1e-9 * static_cast<double>(difference(*stamp, difference(*first_, *shift)));
}

void BagRows::meet_topics() {
  while (topics_.size() < bag_.topics().size()) {
    const BagTopic& known = bag_.topics()[topics_.size()];
    Topic& topic = topics_.emplace_back();
    topic.selected = is_selected(selection_, known.name);
    if (!topic.selected) continue;
    try {
      topic.decoder = std::make_unique<MessageDecoder>(known, definitions_, file_);
    } catch (const InputError& error) {
      topic.trouble = error;
    }
  }
}

bool BagRows::decode(Topic& topic, const BagMessage& message) {
  if (topic.decoder == nullptr) {
    ++topic.refused;
    return false;
  }
  try {
    topic.decoder->decode(message.bytes, decoded_);
    return true;
  } catch (const InputError& error) {
    if (!topic.trouble) topic.trouble = error;
    if (++topic.refused >= kMostRefused) topic.decoder.reset();
    return false;
  }
}

std::optional<BagRows::Row> BagRows::next() {
  while (const auto message = bag_.next()) {
    meet_topics();
    Topic& topic = topics_[message->topic];
    if (!topic.selected) continue;
    const bool known = decode(topic, *message);
    const std::optional<std::int64_t> stamp = known ? decoded_.stamp : std::nullopt;
    Row row;
    row.topic = message->topic;
    row.time = clock_.time(stamp, message->time, topic.shift);
    row.message = known ? &decoded_ : nullptr;
    return row;
  }
  meet_topics();
  return std::nullopt;
}

void BagRows::refuse_selection() const {
  std::vector<std::string> names;
  for (const BagTopic& topic : bag_.topics()) names.push_back(topic.name);
  if (names.empty())
    throw InputError(InputPlace{file_}, "the bag has no topics").with_value({}, "a bag with messages");
  const std::string pattern = selection_.topics.empty() ? std::string() : selection_.topics.front();
  throw InputError(InputPlace{file_, 0, "--topic"},
                   fmt::format("no topic matches {}{}; 'armtune logs' lists the {} topics of this bag",
                               shown(pattern), suggestion(pattern, names), names.size()))
      .with_value(pattern, "a pattern of topics of the bag");
}

}  // namespace armtune::internal
