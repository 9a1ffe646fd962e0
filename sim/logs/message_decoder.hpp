#pragma once
// Turns the messages of one topic of a bag into numbers with names:
//
//     const MessageDefinitions definitions(msg_path);
//     MessageDecoder decoder(bag.topics()[i], definitions, file);
//     DecodedMessage message;
//     decoder.decode(bytes, message);  // message.values[k] belongs to decoder.paths()[k]

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sim/logs/bag.hpp"
#include "sim/logs/message_definitions.hpp"

namespace armtune::internal {

/// The numbers of one message. Use the same object for all messages of a topic: then its memory is reused.
struct DecodedMessage {
  /// header.stamp of the message [ns], on the clock of its sender. No value: the message has no header, or
  /// its stamp is 0. Only the time at which it was recorded is then known.
  std::optional<std::int64_t> stamp;
  /// As many as MessageDecoder::paths() after this message; NaN where this message has no such element.
  std::vector<double> values;
};

/// Decodes the messages of one topic. Every number becomes a channel:
///   - `/topic/field`, `/topic/field[i]` and, nested, `/topic/pose/position/x` or
///   `/topic/points[0]/positions[1]`;
///   - builtin_interfaces Time and Duration become one channel in s; header.stamp becomes the time instead;
///   - strings are skipped. A sequence of strings that is called name, names or joint_names gives the labels.
///     The numbers in sequences of the same length are stored by label, because another publisher on the same
///     topic may send other joints or another order of them;
///   - arrays and sequences of more than kMostElements elements, such as images, are skipped as a whole.
class MessageDecoder {
 public:
  static constexpr std::size_t kMostElements = 256;   ///< longest array or sequence that is read
  static constexpr std::size_t kMostChannels = 8192;  ///< most channels of one topic; others are not read

  /// topic: only CDR-encoded topics. definitions: need not outlive the decoder. file: of the bag, for
  /// messages. Throws InputError, with the file and with the topic as key, if the encoding is not "cdr", or
  /// if the definition of its type is unknown or invalid. Only this topic is then unreadable.
  MessageDecoder(const BagTopic& topic, const MessageDefinitions& definitions, const std::string& file);
  ~MessageDecoder();
  MessageDecoder(MessageDecoder&& other) noexcept;
  MessageDecoder& operator=(MessageDecoder&& other) noexcept;

  /// Decodes one message, and allocates only if it has more elements than every message before. Throws
  /// InputError, with the file and with the topic as key, if the bytes do not fit the definition.
  void decode(std::span<const std::byte> bytes, DecodedMessage& message);

  /// Returns the names of all channels so far. decode() can append channels; indices do not change.
  const std::vector<std::string>& paths() const;
  /// Returns the units of the channels as far as the type states them, "" elsewhere; as many as paths().
  const std::vector<std::string>& units() const;
  /// Returns the labels of all messages so far, such as joints, in the order in which they appeared, as
  /// printable text. `/topic/position[i]` belongs to label i. decode() can append labels.
  const std::vector<std::string>& labels() const;
  /// Returns how many arrays and sequences were skipped so far, because they were too long or because the
  /// topic had kMostChannels channels. One that is skipped in several messages is counted in each of them.
  std::size_t skipped_arrays() const;
  /// Returns how many messages so far had other labels, or another order of them, than the message before.
  std::size_t label_changes() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace armtune::internal
