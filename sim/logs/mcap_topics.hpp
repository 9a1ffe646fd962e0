#pragma once
// The schemas and channels of an MCAP file, as the topics of a bag.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "sim/logs/bag.hpp"
#include "sim/logs/mcap_place.hpp"

namespace armtune::internal {

/// Collects the Schema and Channel records of a file. Channels that state the same topic, encoding and
/// schema, as those of several publishers do, are one topic.
class McapTopics {
 public:
  /// Takes the content of a Schema record. Throws InputError at its place if a field is too long, if another
  /// schema has the same number, or if all definitions together are longer than kMostMcapDefinitions.
  void add_schema(std::span<const std::byte> content, const McapPlace& place);

  /// Takes the content of a Channel record. Throws the same errors, and also InputError if the record names a
  /// schema that has not occurred.
  void add_channel(std::span<const std::byte> content, const McapPlace& place);

  /// Returns the index in all() of the channel's topic; nothing if the channel has not occurred.
  std::optional<std::size_t> topic_of(std::uint16_t channel) const noexcept {
    if (channel >= topic_of_channel_.size() || topic_of_channel_[channel] == kNone) return std::nullopt;
    return topic_of_channel_[channel];
  }

  const std::vector<BagTopic>& all() const noexcept { return topics_; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Schema {
    std::string name;
    std::string encoding;
    std::string data;
    std::uint16_t same_as = 0;  ///< the first schema with this name, encoding and data, perhaps itself
  };
  struct Channel {
    std::uint16_t schema = 0;
    std::string topic;
    std::string encoding;
  };
  // Keys share the memory of the values of schemas_ and channels_, which stay where they are.
  using SchemaKey = std::tuple<std::string_view, std::string_view, std::string_view>;
  using TopicKey = std::tuple<std::uint16_t, std::string_view, std::string_view>;

  void count_bytes(std::size_t bytes, const McapPlace& place);
  void connect(std::uint16_t number, const Channel& channel, const McapPlace& place);

  std::map<std::uint16_t, Schema> schemas_;
  std::map<SchemaKey, std::uint16_t> first_schema_;
  std::map<std::uint16_t, Channel> channels_;
  std::map<TopicKey, std::size_t> index_;
  std::vector<BagTopic> topics_;
  std::vector<std::size_t> topic_of_channel_;  // by the number of the channel
  std::size_t bytes_ = 0;
};

}  // namespace armtune::internal
