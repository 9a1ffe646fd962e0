#pragma once
// Decodes the messages of the selected topics of a bag, one after another.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "sim/logs/bag.hpp"
#include "sim/logs/log_selection.hpp"
#include "sim/logs/message_decoder.hpp"

namespace armtune::internal {

/// Converts the stamps of messages to the recorder's clock. A sender whose clock differs from the recorder's
/// by more than a minute, such as one in simulated time, is shifted by the difference in its first message.
/// Senders with the same difference get the same shift, so that they stay synchronous.
class MessageClock {
 public:
  /// Returns the time of a message [s] since the first message of the bag was recorded. stamp: [ns], nothing
  /// if the message has none; recorded: [ns]. shift: of the topic; it is set by its first message with a
  /// stamp.
  double time(std::optional<std::int64_t> stamp, std::int64_t recorded, std::optional<std::int64_t>& shift);
  /// The time at which the first message was recorded [s], on the recorder's clock.
  double start() const { return 1e-9 * static_cast<double>(first_.value_or(0)); }

 private:
  std::optional<std::int64_t> first_;
  std::vector<std::int64_t> shifts_;
};

class BagRows {
 public:
  /// The data of a topic that are known so far.
  struct Topic {
    bool selected = false;
    std::unique_ptr<MessageDecoder>
        decoder;                        ///< null: the type is unknown, or too many messages were refused
    std::optional<InputError> trouble;  ///< of the first message that could not be decoded
    long refused = 0;                   ///< number of messages that could not be decoded
    std::optional<std::int64_t> shift;  ///< of the sender's clock [ns]; none: no message had a stamp
  };
  struct Row {
    std::size_t topic = 0;                    ///< index in BagReader::topics()
    double time = 0.0;                        ///< since the first message of the bag was recorded [s]
    const DecodedMessage* message = nullptr;  ///< null: it could not be decoded; valid until next()
  };

  /// All arguments must outlive the object.
  BagRows(BagReader& bag, const MessageDefinitions& definitions, const std::string& file,
          const LogSelection& selection)
      : bag_(bag), definitions_(definitions), file_(file), selection_(selection) {}

  /// Returns the next message of a selected topic, or nothing at the end. Throws InputError as
  /// BagReader::next does. After kMostRefused refused messages of a topic no further one is decoded.
  std::optional<Row> next();
  const Topic& topic(std::size_t index) const { return topics_[index]; }
  /// Number of topics that next() has met so far, selected or not.
  std::size_t topics() const { return topics_.size(); }
  const MessageClock& clock() const { return clock_; }
  /// Throws InputError with the key `--topic` and a message that names the topics of the bag. Call it if none
  /// of them is selected.
  [[noreturn]] void refuse_selection() const;

  static constexpr long kMostRefused = 100;

 private:
  void meet_topics();
  bool decode(Topic& topic, const BagMessage& message);

  BagReader& bag_;
  const MessageDefinitions& definitions_;
  const std::string& file_;
  const LogSelection& selection_;
  std::vector<Topic> topics_;
  DecodedMessage decoded_;
  MessageClock clock_;
};

}  // namespace armtune::internal
