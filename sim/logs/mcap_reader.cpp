#include "sim/logs/mcap_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "sim/logs/byte_cursor.hpp"
#include "sim/logs/byte_source.hpp"
#include "sim/logs/mcap_chunk.hpp"
#include "sim/logs/mcap_summary_check.hpp"
#include "sim/logs/mcap_topics.hpp"

namespace armtune::internal {
namespace {

enum class McapSection { kHeader, kData, kSummary, kEnd };

/// True if a record of this kind may stand in the section. Kinds of later versions may stand everywhere.
bool may_stand_in(McapSection section, McapRecord kind) {
  switch (kind) {
    case McapRecord::kHeader:
      return section == McapSection::kHeader;
    case McapRecord::kMessage:
    case McapRecord::kChunk:
    case McapRecord::kMessageIndex:
    case McapRecord::kAttachment:
    case McapRecord::kMetadata:
    case McapRecord::kDataEnd:
      return section == McapSection::kData;
    default:
      return section != McapSection::kHeader && static_cast<std::uint8_t>(kind) != 0;
  }
}

class McapReader final : public BagReader {
 public:
  explicit McapReader(const std::filesystem::path& path) : source_(path, "an MCAP file"), chunk_(source_) {
    const auto magic = source_.peek(kMcapMagic.size());
    if (!std::equal(magic.begin(), magic.end(), kMcapMagic.begin(), kMcapMagic.end())) {
      throw InputError(InputPlace{source_.path()},
                       InputFault{.problem = "does not begin like an MCAP file of version 0",
                                  .limit = "a recording in the MCAP format"});
    }
    source_.skip(kMcapMagic.size());
  }

  const std::vector<BagTopic>& topics() const override { return topics_.all(); }
  bool unfinished() const override { return unfinished_; }

  std::optional<BagMessage> next() override {
    source_.skip(std::exchange(held_, 0));
    while (section_ != McapSection::kEnd) {
      if (const auto record = chunk_.next_record()) {
        if (const auto message = read_record(record->content, record->place)) return message;
      } else if (const auto message = read_top_record()) {
        return message;
      }
    }
    return std::nullopt;
  }

 private:
  McapPlace place_of(McapRecord kind) const { return {source_.path(), kind, source_.offset()}; }

  /// Ends the reading because the file ends within a record, or where one should begin. Throws InputError if
  /// the file is complete and so the record's length is wrong.
  std::optional<BagMessage> end_unfinished(const McapPlace& place) {
    const bool only_magic = place.offset == kMcapMagic.size() && place.kind == McapRecord{0};
    if (!only_magic && source_.ends_with(kMcapMagic))
      throw mcap_error(place,
                       {.problem = "is longer than the rest of the file, although the file is not cut off"});
    section_ = McapSection::kEnd;
    unfinished_ = true;
    return std::nullopt;
  }

  std::optional<BagMessage> read_top_record() {
    const auto head = source_.peek(kMcapRecordHead);
    if (head.size() < kMcapRecordHead) return end_unfinished(place_of(McapRecord{0}));
    const auto kind = static_cast<McapRecord>(head[0]);
    const auto length = little_endian_at<std::uint64_t>(&head[1]);
    const McapPlace place = place_of(kind);
    if (!may_stand_in(section_, kind)) {
      throw mcap_error(
          place, {.problem = section_ == McapSection::kHeader ? "stands where the Header must be"
                                                              : "is not allowed in this part of the file"});
    }
    if (kind == McapRecord::kChunk) return chunk_.read(length, place) ? std::nullopt : end_unfinished(place);
    const bool kept = kind == McapRecord::kMessage || kind == McapRecord::kSchema ||
                      kind == McapRecord::kChannel || kind == McapRecord::kHeader ||
                      kind == McapRecord::kStatistics || kind == McapRecord::kDataEnd ||
                      kind == McapRecord::kFooter;
    if (!kept) {
      const bool whole = source_.pass(kMcapRecordHead) && source_.pass(length);
      return whole ? std::nullopt : end_unfinished(place);
    }
    if (length > kLargestMcapRecord) throw too_long_mcap_record(place, length);
    const std::size_t size = kMcapRecordHead + static_cast<std::size_t>(length);
    const auto record = source_.peek(size);
    if (record.size() < size) return end_unfinished(place);
    const auto content = record.subspan(kMcapRecordHead);
    if (kind == McapRecord::kFooter) return read_footer(content, place);
    if (kind == McapRecord::kDataEnd) return read_data_end(content, place);
    held_ = size;  // skipped with the next call: the message shares the memory
    const auto message = read_record(content, place);
    if (!message) source_.skip(std::exchange(held_, 0));
    return message;
  }

  /// Reads a record that holds a message or says something of messages.
  std::optional<BagMessage> read_record(std::span<const std::byte> content, const McapPlace& place) {
    switch (place.kind) {
      case McapRecord::kMessage:
        return message_of(content, place);
      case McapRecord::kSchema:
        topics_.add_schema(content, place);
        return std::nullopt;
      case McapRecord::kChannel:
        topics_.add_channel(content, place);
        return std::nullopt;
      case McapRecord::kStatistics:
        summary_.set_statistics(content, place);
        return std::nullopt;
      case McapRecord::kHeader: {
        ByteCursor header(content, place);
        header.text();  // profile
        header.text();  // library
        section_ = McapSection::kData;
        return std::nullopt;
      }
      default:
        return std::nullopt;
    }
  }

  BagMessage message_of(std::span<const std::byte> content, const McapPlace& place) {
    if (content.size() < kMcapMessageHead) {
      throw mcap_error(place, {.problem = "is too short",
                               .value = std::to_string(content.size()),
                               .limit = fmt::format("at least {} bytes", kMcapMessageHead)});
    }
    const auto channel = little_endian_at<std::uint16_t>(content.data());
    const auto time =
        little_endian_at<std::uint64_t>(content.data() + 6);  // log_time, behind the sequence number
    const auto topic = topics_.topic_of(channel);
    if (!topic) {
      throw mcap_error(
          place, {.problem = fmt::format("belongs to channel {}, which has not occurred before it", channel),
                  .value = std::to_string(channel)});
    }
    constexpr std::uint64_t kLatest = std::numeric_limits<std::int64_t>::max();
    if (time > kLatest) {
      throw mcap_error(place, {.problem = fmt::format("has a time that is too late, {} ns", time),
                               .value = std::to_string(time),
                               .limit = fmt::format("at most {} ns", kLatest)});
    }
    summary_.count_message();
    return {*topic, static_cast<std::int64_t>(time), content.subspan(kMcapMessageHead)};
  }

  std::optional<BagMessage> read_data_end(std::span<const std::byte> content, const McapPlace& place) {
    ByteCursor record(content, place);
    check_mcap_crc(place, record.number<std::uint32_t>(), source_.crc(), "the file's data");
    source_.skip(kMcapRecordHead + content.size());
    source_.restart_crc();
    summary_.begin_at(source_.offset());
    section_ = McapSection::kSummary;
    return std::nullopt;
  }

  std::optional<BagMessage> read_footer(std::span<const std::byte> content, const McapPlace& place) {
    const McapFooter footer = mcap_footer(content, place);
    source_.skip(kMcapRecordHead + kMcapFooter - sizeof(footer.summary_crc));
    summary_.check(footer, source_.crc(), place);
    source_.skip(sizeof(footer.summary_crc));
    const auto magic = source_.peek(kMcapMagic.size() + 1);
    section_ = McapSection::kEnd;
    unfinished_ = magic.size() < kMcapMagic.size();
    if (!unfinished_ && !std::equal(magic.begin(), magic.end(), kMcapMagic.begin(), kMcapMagic.end()))
      throw mcap_error(place, {.problem = "is not followed by the end of an MCAP file"});
    return std::nullopt;
  }

  ByteSource source_;
  McapChunk chunk_;
  McapTopics topics_;
  McapSummaryCheck summary_;
  McapSection section_ = McapSection::kHeader;
  std::size_t held_ = 0;  ///< bytes at the front of source_ that the last message shares
  bool unfinished_ = false;
};

}  // namespace

std::unique_ptr<BagReader> open_mcap(const std::filesystem::path& path) {
  return std::make_unique<McapReader>(path);
}

}  // namespace armtune::internal
