#pragma once
// Finds the definition by which the messages of a topic are decoded.

#include <filesystem>
#include <string>
#include <vector>

#include "sim/logs/bag.hpp"
#include "sim/logs/message_definition.hpp"

namespace armtune::internal {

/// Knows the definitions of message types from three sources, in this order: the schema that the bag holds,
/// the folder of the user (`--msg-path`), and armtune's built-in definitions of common types.
class MessageDefinitions {
 public:
  /// msg_path: a folder with files `PACKAGE/msg/TYPE.msg`, such as the share folder of a ROS installation.
  /// Empty: none. Throws InputError if it is not a folder.
  explicit MessageDefinitions(std::filesystem::path msg_path = {});

  /// Returns the possible definitions of the topic's type, at least one and the most likely first. There are
  /// several where a type changed between ROS distributions and the bag holds no schema: the bytes of the
  /// messages then tell which is right. Throws InputError, with the file of the bag and with the topic as key
  /// (or with the file and the line of a .msg file), if the type is unknown or its definition is invalid.
  std::vector<MessageDefinition> of(const BagTopic& topic, const std::string& file) const;

 private:
  std::filesystem::path msg_path_;
};

}  // namespace armtune::internal
