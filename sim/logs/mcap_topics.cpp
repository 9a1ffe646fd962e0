#include "sim/logs/mcap_topics.hpp"

#include <utility>

#include "core/common/message_text.hpp"
#include "sim/logs/byte_cursor.hpp"

namespace armtune::internal {
namespace {

/// Returns a name of the record. Throws its InputError if the name is not UTF-8, which tables and results
/// could not show.
std::string name_of(ByteCursor& record, const McapPlace& place) {
  const std::string_view name = record.text();
  if (!is_utf8(name)) throw mcap_error(place, {.problem = "has a name that is not UTF-8", .limit = "UTF-8"});
  return std::string(name);
}

[[noreturn]] void refuse_change(const McapPlace& place, std::uint16_t number) {
  throw mcap_error(place, {.problem = "differs from an earlier one with the same number",
                           .value = std::to_string(number),
                           .limit = "the same content for the same number"});
}

}  // namespace

void McapTopics::count_bytes(std::size_t bytes, const McapPlace& place) {
  bytes_ += bytes;
  if (bytes_ > kMostMcapDefinitions) {
    throw mcap_error(place, {.problem = "makes the definitions of the file's topics too long",
                             .value = std::to_string(bytes_),
                             .limit = "at most " + std::to_string(kMostMcapDefinitions) + " bytes in all"});
  }
}

void McapTopics::add_schema(std::span<const std::byte> content, const McapPlace& place) {
  ByteCursor record(content, place);
  const auto number = record.number<std::uint16_t>();
  Schema schema;
  schema.name = name_of(record, place);
  schema.encoding = name_of(record, place);
  schema.data = std::string(record.text());
  if (number == 0) return;  // invalid, and to be ignored (specification, "Schema")
  if (const auto known = schemas_.find(number); known != schemas_.end()) {
    const Schema& before = known->second;
    if (schema.name != before.name || schema.encoding != before.encoding || schema.data != before.data)
      refuse_change(place, number);
    return;
  }
  count_bytes(content.size(), place);
  Schema& kept = schemas_.emplace(number, std::move(schema)).first->second;
  kept.same_as = first_schema_.try_emplace({kept.name, kept.encoding, kept.data}, number).first->second;
}

void McapTopics::add_channel(std::span<const std::byte> content, const McapPlace& place) {
  ByteCursor record(content, place);
  const auto number = record.number<std::uint16_t>();
  Channel channel;
  channel.schema = record.number<std::uint16_t>();
  channel.topic = name_of(record, place);
  channel.encoding = name_of(record, place);
  record.counted_bytes();  // metadata, which armtune does not use
  if (const auto known = channels_.find(number); known != channels_.end()) {
    const Channel& before = known->second;
    if (channel.schema != before.schema || channel.topic != before.topic ||
        channel.encoding != before.encoding)
      refuse_change(place, number);
    return;
  }
  if (channel.schema != 0 && !schemas_.contains(channel.schema)) {
    throw mcap_error(place, {.problem = "names a schema that has not occurred before it",
                             .value = std::to_string(channel.schema)});
  }
  count_bytes(content.size(), place);
  connect(number, channels_.emplace(number, std::move(channel)).first->second, place);
}

void McapTopics::connect(std::uint16_t number, const Channel& channel, const McapPlace& place) {
  const Schema none;
  const Schema& schema = channel.schema == 0 ? none : schemas_.at(channel.schema);
  const auto [entry, is_new] =
      index_.try_emplace({schema.same_as, channel.topic, channel.encoding}, topics_.size());
  if (is_new) {
    count_bytes(schema.name.size() + schema.encoding.size() + schema.data.size(), place);
    topics_.push_back({channel.topic, schema.name, channel.encoding, schema.data, schema.encoding});
  }
  if (topic_of_channel_.size() <= number) topic_of_channel_.resize(number + 1U, kNone);
  topic_of_channel_[number] = entry->second;
}

}  // namespace armtune::internal
