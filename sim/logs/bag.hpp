#pragma once
// A bag is a file of messages that a robot's programs sent on topics. Here a message is bytes that are not
// decoded yet.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace armtune::internal {

/**
 * A bag is a file of recorded messages: each belongs to a topic, has a time, and is a sequence of bytes in
 * the encoding of its topic. A BagReader streams the messages of one file in the order in which they were
 * recorded, in bounded memory:
 *
 *     while (const auto message = bag.next()) count[message->topic]++;
 */
struct BagTopic {
  std::string name;      ///< for example "/joint_states"
  std::string type;      ///< for example "sensor_msgs/msg/JointState"
  std::string encoding;  ///< of its messages: "cdr" for ROS 2
  std::string schema;    ///< the definition of the type as the file holds it; empty: the file holds none
  std::string schema_encoding;  ///< "ros2msg" or "ros2idl"; empty: none
};

struct BagMessage {
  std::size_t topic = 0;             ///< index in BagReader::topics()
  std::int64_t time = 0;             ///< when it was recorded, ns since the epoch of the recorder's clock
  std::span<const std::byte> bytes;  ///< valid until the next call of next()
};

class BagReader {
 public:
  virtual ~BagReader() = default;

  /// Returns the topics found so far. After the last message, these are all topics. next() can append topics;
  /// the indices of the others do not change.
  virtual const std::vector<BagTopic>& topics() const = 0;

  /// Returns the next message, or nothing at the end. Throws InputError with the file and the offset where
  /// the file is damaged.
  virtual std::optional<BagMessage> next() = 0;

  /// True after the last message if the file was cut off, for example because the recorder was killed. Later
  /// messages may then be missing.
  virtual bool unfinished() const { return false; }
};

}  // namespace armtune::internal
