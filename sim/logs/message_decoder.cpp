#include "sim/logs/message_decoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "sim/logs/cdr_reader.hpp"
#include "sim/logs/channel_tree.hpp"
#include "sim/logs/message_labels.hpp"
#include "sim/logs/message_layout.hpp"

namespace armtune::internal {
namespace {

bool names_elements(const MessageField& field) {
  return field.kind == FieldKind::kString && field.shape != FieldShape::kSingle &&
         (field.name == "name" || field.name == "names" || field.name == "joint_names");
}

double read_seconds(CdrReader& reader, std::optional<std::int64_t>* stamp) {
  constexpr std::int64_t kNanoseconds = 1'000'000'000;
  const std::int64_t seconds = reader.number<std::int32_t>();
  const std::int64_t nanoseconds = reader.number<std::uint32_t>();
  const std::int64_t sum = seconds * kNanoseconds + nanoseconds;
  if (stamp != nullptr && sum != 0) *stamp = sum;
  return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
}

double read_value(CdrReader& reader, FieldKind kind) {
  switch (kind) {
    case FieldKind::kBool:
      return reader.number<std::uint8_t>() == 0 ? 0.0 : 1.0;
    case FieldKind::kInt8:
      return reader.number<std::int8_t>();
    case FieldKind::kUint8:
      return reader.number<std::uint8_t>();
    case FieldKind::kInt16:
      return reader.number<std::int16_t>();
    case FieldKind::kUint16:
      return reader.number<std::uint16_t>();
    case FieldKind::kInt32:
      return reader.number<std::int32_t>();
    case FieldKind::kUint32:
      return reader.number<std::uint32_t>();
    case FieldKind::kInt64:
      return static_cast<double>(reader.number<std::int64_t>());
    case FieldKind::kUint64:
      return static_cast<double>(reader.number<std::uint64_t>());
    case FieldKind::kFloat32:
      return static_cast<double>(reader.number<float>());
    case FieldKind::kTime:
    case FieldKind::kDuration:
      return read_seconds(reader, nullptr);
    default:
      return reader.number<double>();
  }
}

std::string_view problem_of(CdrFault fault) {
  switch (fault) {
    case CdrFault::kTruncated:
      return "ends before its last value";
    case CdrFault::kLength:
      return "gives a length that is longer than the rest of the message";
    case CdrFault::kBound:
      return "has a sequence or a string that is longer than its type allows";
    case CdrFault::kCompressed:
      return "is compressed; make a bag without compression with 'ros2 bag convert'";
    default:
      return "does not begin with the header of CDR (XCDR1)";
  }
}

}  // namespace

class MessageDecoder::Impl {
 public:
  Impl(const BagTopic& topic, const MessageDefinitions& definitions, const std::string& file)
      : place_{file, 0, topic.name}, type_(topic.type) {
    if (topic.encoding != "cdr") {
      throw InputError(place_, InputFault{.problem = fmt::format("topic {} has the encoding {}",
                                                                 shown(topic.name), shown(topic.encoding)),
                                          .value = topic.encoding,
                                          .limit = "cdr, the encoding of ROS 2"});
    }
    candidates_ = definitions.of(topic, file);
    make_tree(0, WstringForm::kFourBytes);
  }

  void decode(std::span<const std::byte> bytes, DecodedMessage& message) {
    if (!is_chosen_) choose(bytes);
    message.stamp.reset();
    message.values.assign(tree_->paths().size(), kAbsent);
    labels_.begin();
    CdrReader reader(bytes);
    read_fields(reader, 0, tree_->root(), message, true);
    check_end(reader, bytes);
  }

  const ChannelTree& tree() const { return *tree_; }
  const MessageLabels& labels() const { return labels_; }
  std::size_t skipped() const { return skipped_; }

 private:
  static constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();

  [[noreturn]] void refuse(std::span<const std::byte> bytes, std::size_t offset,
                           std::string_view problem) const {
    throw InputError(place_, InputFault{.problem = fmt::format(
                                            "a message of topic {} {}, at byte {} of {}, so it is not a {}",
                                            shown(place_.key), problem, offset, bytes.size(), shown(type_)),
                                        .value = fmt::format("{}", bytes.size())});
  }

  void check_end(const CdrReader& reader, std::span<const std::byte> bytes) const {
    if (reader.fault() != CdrFault::kNone) refuse(bytes, reader.offset(), problem_of(reader.fault()));
    if (reader.rest() > kMostPadding) refuse(bytes, reader.offset(), "is longer than its type");
  }

  /// Chooses the definition that leaves the fewest bytes of the first message. Refuses the message if none
  /// fits; then the next message chooses.
  void choose(std::span<const std::byte> bytes) {
    std::size_t least = kMostPadding + 1;
    std::size_t best = 0;
    WstringForm best_form = WstringForm::kFourBytes;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      for (const WstringForm form : {WstringForm::kFourBytes, WstringForm::kTwoBytes}) {
        const auto rest = surplus(bytes, candidates_[i], form);
        if (!rest || *rest >= least) continue;
        least = *rest;
        best = i;
        best_form = form;
      }
    }
    if (least > kMostPadding) {
      CdrReader reader(bytes);
      skip_struct(reader, candidates_.front(), 0, WstringForm::kFourBytes);
      check_end(reader, bytes);
    }
    is_chosen_ = true;
    labels_ = MessageLabels(kMostElements);
    make_tree(best, best_form);
  }

  void make_tree(std::size_t candidate, WstringForm form) {
    definition_ = &candidates_[candidate];
    form_ = form;
    tree_ = std::make_unique<ChannelTree>(*definition_, place_.key, kMostChannels);
  }

  void read_fields(CdrReader& reader, std::size_t type, std::vector<ChannelField>& places,
                   DecodedMessage& message, bool is_top) {
    const MessageType& own = definition_->types[type];
    for (std::size_t k = 0; k < own.fields.size() && reader.fault() == CdrFault::kNone; ++k) {
      const MessageField& field = own.fields[k];
      const std::size_t count = element_count(reader, field);
      if (field.kind == FieldKind::kString && is_top && names_elements(field)) {
        labels_.read(reader, count, field.string_size);
      } else if (field.kind == FieldKind::kString || field.kind == FieldKind::kWstring) {
        skip_values(reader, field, count, form_);
      } else if (field.kind == FieldKind::kStruct) {
        read_structs(reader, field, count, places[k], message, is_top);
      } else {
        read_numbers(reader, field, count, places[k], message);
      }
    }
  }

  void read_structs(CdrReader& reader, const MessageField& field, std::size_t count, ChannelField& place,
                    DecodedMessage& message, bool is_top) {
    const bool is_header = is_top && field.name == "header" && field.shape == FieldShape::kSingle;
    if (is_header && read_header(reader, field.type, message)) return;
    bool is_skipped = count > kMostElements;
    for (std::size_t i = 0; i < count && reader.fault() == CdrFault::kNone; ++i) {
      std::vector<ChannelField>* element = is_skipped ? nullptr : tree_->element(place, field, i);
      is_skipped = element == nullptr;
      if (is_skipped) {
        skip_struct(reader, *definition_, field.type, form_);
      } else {
        read_fields(reader, field.type, *element, message, false);
      }
    }
    skipped_ += is_skipped ? 1 : 0;
  }

  /// Reads a std_msgs/Header, whose stamp is the time of the message. Returns false for any other type.
  bool read_header(CdrReader& reader, std::size_t type, DecodedMessage& message) const {
    const MessageType& header = definition_->types[type];
    if (header.name != "std_msgs/Header" || header.fields.front().kind != FieldKind::kTime ||
        header.fields.front().shape != FieldShape::kSingle)
      return false;
    read_seconds(reader, &message.stamp);
    for (std::size_t k = 1; k < header.fields.size(); ++k)
      skip_field(reader, *definition_, header.fields[k], form_);
    return true;
  }

  void read_numbers(CdrReader& reader, const MessageField& field, std::size_t count, ChannelField& place,
                    DecodedMessage& message) {
    const bool is_long = count > kMostElements;
    std::size_t needed = is_long ? 0 : count;
    if (field.shape == FieldShape::kSequence) {
      for (std::size_t i = 0; !is_long && i < count; ++i)
        needed = std::max(needed, labels_.place(i, count) + 1);
    }
    // A length that lies must not make channels: the values have to be there.
    CdrReader ahead = reader;
    skip_values(ahead, field, count, form_);
    if (is_long || ahead.fault() != CdrFault::kNone || !tree_->has_channels(place, field, needed)) {
      ++skipped_;
      reader = ahead;
      return;
    }
    message.values.resize(tree_->paths().size(), kAbsent);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = field.shape == FieldShape::kSequence ? labels_.place(i, count) : i;
      message.values[place.channels[at]] = read_value(reader, field.kind);
    }
  }

  InputPlace place_;
  std::string type_;
  std::vector<MessageDefinition> candidates_;
  bool is_chosen_ = false;
  const MessageDefinition* definition_ = nullptr;  // one of candidates_
  WstringForm form_ = WstringForm::kFourBytes;
  std::unique_ptr<ChannelTree> tree_;
  MessageLabels labels_{kMostElements};
  std::size_t skipped_ = 0;
};

MessageDecoder::MessageDecoder(const BagTopic& topic, const MessageDefinitions& definitions,
                               const std::string& file)
    : impl_(std::make_unique<Impl>(topic, definitions, file)) {}
MessageDecoder::~MessageDecoder() = default;
MessageDecoder::MessageDecoder(MessageDecoder&& other) noexcept = default;
MessageDecoder& MessageDecoder::operator=(MessageDecoder&& other) noexcept = default;

void MessageDecoder::decode(std::span<const std::byte> bytes, DecodedMessage& message) {
  impl_->decode(bytes, message);
}
const std::vector<std::string>& MessageDecoder::paths() const {
  return impl_->tree().paths();
}
const std::vector<std::string>& MessageDecoder::units() const {
  return impl_->tree().units();
}
const std::vector<std::string>& MessageDecoder::labels() const {
  return impl_->labels().names();
}
std::size_t MessageDecoder::skipped_arrays() const {
  return impl_->skipped();
}
std::size_t MessageDecoder::label_changes() const {
  return impl_->labels().changes();
}

}  // namespace armtune::internal
