#pragma once
// The channels of a topic, arranged as the fields of its messages are. A message is decoded by walking its
// definition and this tree together, so that no name is looked up.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/message_definition.hpp"

namespace armtune::internal {

/// One field at one place in the messages, with what is known of its elements so far.
struct ChannelField {
  std::string path;                                 ///< such as "/topic/points[0]/positions"
  std::string_view unit;                            ///< of all numbers in the field; empty: not stated
  std::vector<std::uint32_t> channels;              ///< of a field of numbers: the channel of each element
  std::vector<std::vector<ChannelField>> elements;  ///< of a field of structs: the fields of each element
};

/// Makes channels when a message first has an element for them.
class ChannelTree {
 public:
  /// definition: must outlive this object. most: largest number of channels, and of places in the tree, that
  /// are made.
  ChannelTree(const MessageDefinition& definition, const std::string& topic, std::size_t most);

  /// Returns the fields of the message itself.
  std::vector<ChannelField>& root() { return root_; }

  /// True if the field has channels for its elements 0 to `count` - 1; makes those that are missing.
  bool has_channels(ChannelField& place, const MessageField& field, std::size_t count) {
    return count <= place.channels.size() || add_channels(place, field, count);
  }
  /// Returns the fields of element i of a field of structs; null if there are too many places.
  std::vector<ChannelField>* element(ChannelField& place, const MessageField& field, std::size_t i) {
    if (i < place.elements.size()) return &place.elements[i];
    return add_element(place, field, i);
  }

  const std::vector<std::string>& paths() const { return paths_; }
  const std::vector<std::string>& units() const { return units_; }

 private:
  bool add_channels(ChannelField& place, const MessageField& field, std::size_t count);
  std::vector<ChannelField>* add_element(ChannelField& place, const MessageField& field, std::size_t i);
  std::vector<ChannelField> fields_of(const MessageType& type, const std::string& path,
                                      std::string_view unit);

  const MessageDefinition& definition_;
  std::size_t most_;
  std::size_t places_ = 0;
  std::vector<ChannelField> root_;
  std::vector<std::string> paths_;
  std::vector<std::string> units_;
};

}  // namespace armtune::internal
