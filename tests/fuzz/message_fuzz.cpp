// Whatever the schema and the messages: the definition is within its limits, every message has as many values
// as there are channels, and what does not fit is refused on one line. The schema ends at the first zero
// byte; behind it come the messages, each with a byte for its length.

#include <cstddef>
#include <span>
#include <string>

#include "sim/logs/message_decoder.hpp"
#include "tests/fuzz/support/input.hpp"

namespace armtune::internal::fuzz {
namespace {

void decode_all(MessageDecoder& decoder, std::string_view messages) {
  DecodedMessage decoded;
  while (!messages.empty()) {
    const auto length = static_cast<unsigned char>(messages.front());
    messages.remove_prefix(1);
    const std::string_view message = messages.substr(0, length);
    messages.remove_prefix(message.size());
    const auto bytes = std::as_bytes(std::span(message.data(), message.size()));
    read_or_refuse([&] {
      decoder.decode(bytes, decoded);
      require(decoded.values.size() == decoder.paths().size());
    });
    require(decoder.paths().size() <= MessageDecoder::kMostChannels);
    require(decoder.units().size() == decoder.paths().size());
    require(decoder.labels().size() <= MessageDecoder::kMostElements);
  }
}

void check(std::string_view bytes) {
  static const MessageDefinitions definitions;
  const std::size_t end = bytes.find('\0');
  const std::string_view schema = bytes.substr(0, end);
  const std::string_view messages = end == std::string_view::npos ? "" : bytes.substr(end + 1);
  BagTopic topic{"/topic", "pkg/msg/Type", "cdr", std::string(schema), "ros2msg"};
  read_or_refuse([&] {
    for (const MessageDefinition& definition : definitions.of(topic, "input.mcap")) {
      require(!definition.types.empty() && definition.types.size() <= kMostMessageTypes);
      for (const MessageType& type : definition.types)
        require(!type.fields.empty() && type.fields.size() <= kMostFields);
    }
  });
  read_or_refuse([&] {
    MessageDecoder decoder(topic, definitions, "input.mcap");
    decode_all(decoder, messages);
  });
  if (!schema.empty()) return;
  for (const char* type : {"sensor_msgs/msg/JointState", "control_msgs/msg/JointTrajectoryControllerState"}) {
    MessageDecoder decoder({"/topic", type, "cdr", "", ""}, definitions, "input.db3");
    decode_all(decoder, messages);
  }
}

}  // namespace
}  // namespace armtune::internal::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  armtune::internal::fuzz::check(armtune::internal::fuzz::text(data, size));
  return 0;
}
