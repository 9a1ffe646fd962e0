#include "sim/logs/mcap_chunk.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/common/message_text.hpp"
#include "sim/logs/byte_cursor.hpp"
#include "sim/logs/mcap_summary_check.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kChunkHead =
    128;  // bytes: enough for the fields before the records, with the name of a compression
constexpr std::size_t kPiece = 256U << 10;  // bytes that are decompressed at once

bool may_stand_in_chunk(McapRecord kind) {
  return kind == McapRecord::kMessage || kind == McapRecord::kSchema || kind == McapRecord::kChannel ||
         kind > McapRecord::kDataEnd;
}

[[noreturn]] void refuse_outcome(const McapPlace& place, ChunkDecoder::Outcome outcome, std::uint64_t size) {
  using enum ChunkDecoder::Outcome;
  std::string problem = "cannot be decompressed: its compressed bytes are damaged";
  if (outcome == kTooLarge) problem = fmt::format("is larger than the {} bytes that it states", size);
  if (outcome == kTooSmall)
    problem = fmt::format("is smaller than the {} bytes that it states, or is cut off", size);
  throw mcap_error(place, {.problem = std::move(problem), .limit = std::to_string(size)});
}

}  // namespace

McapChunk::Head McapChunk::head_of(std::span<const std::byte> record, std::uint64_t length,
                                   const McapPlace& place) {
  ByteCursor fields(record.subspan(kMcapRecordHead), place);
  Head head;
  fields.number<std::uint64_t>();  // time of the first message
  fields.number<std::uint64_t>();  // time of the last message
  head.size = fields.number<std::uint64_t>();
  head.crc = fields.number<std::uint32_t>();
  const std::string_view name = fields.text();
  head.compressed_size = fields.number<std::uint64_t>();
  head.bytes = record.size() - fields.left().size();
  const auto compression = chunk_compression_of(name);
  if (!compression) {
    throw mcap_error(
        place, {.problem = fmt::format("has the compression {}, which armtune does not know", shown(name)),
                .value = std::string(name),
                .limit = "none, lz4 or zstd"});
  }
  head.compression = *compression;
  if (head.size > kLargestMcapRecord) throw too_long_mcap_record(place, head.size);
  const std::uint64_t room = kMcapRecordHead + length - head.bytes;
  if (head.compressed_size > room) {
    throw mcap_error(place, {.problem = "has a field that is longer than the rest of the record",
                             .value = std::to_string(head.compressed_size),
                             .limit = fmt::format("at most {} bytes", room)});
  }
  return head;
}

void McapChunk::check_expansion(std::uint64_t length, const McapPlace& place) {
  expanded_ += decoder_.content().size();
  const std::uint64_t most = kFreeMcapExpansion + kMostMcapExpansion * (place.offset + length);
  if (expanded_ > most) {
    throw mcap_error(place,
                     {.problem = fmt::format(
                          "makes the file decompress to {} bytes, which is too many for its size", expanded_),
                      .value = std::to_string(expanded_),
                      .limit = fmt::format("at most {} times its own size", kMostMcapExpansion)});
  }
}

bool McapChunk::decompress(const Head& head, const McapPlace& place) {
  decoder_.begin(head.compression, static_cast<std::size_t>(head.size));
  for (std::uint64_t left = head.compressed_size; left > 0;) {
    const auto piece = source_.peek(static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece)));
    if (piece.empty()) return false;
    const auto outcome = decoder_.add(piece);
    if (outcome != ChunkDecoder::Outcome::kGood) refuse_outcome(place, outcome, head.size);
    left -= piece.size();
    source_.skip(piece.size());
  }
  if (const auto outcome = decoder_.end(); outcome != ChunkDecoder::Outcome::kGood)
    refuse_outcome(place, outcome, head.size);
  return true;
}

bool McapChunk::read(std::uint64_t length, const McapPlace& place) {
  content_ = {};
  at_ = 0;
  offset_ = place.offset;
  if (length > 2 * kLargestMcapRecord) throw too_long_mcap_record(place, length);
  const std::size_t wanted =
      kMcapRecordHead + static_cast<std::size_t>(std::min<std::uint64_t>(length, kChunkHead));
  const auto record = source_.peek(wanted);
  if (record.size() < wanted) return false;
  const Head head = head_of(record, length, place);
  source_.skip(head.bytes);
  if (!decompress(head, place)) return false;
  // Fields that a later version may append.
  if (!source_.pass(kMcapRecordHead + length - head.bytes - head.compressed_size)) return false;
  check_expansion(length, place);
  if (head.crc != 0) check_mcap_crc(place, head.crc, crc32_of(decoder_.content()), "its content");
  content_ = decoder_.content();
  return true;
}

std::optional<McapChunkRecord> McapChunk::next_record() {
  const std::size_t left = content_.size() - at_;
  if (left == 0) return std::nullopt;
  McapPlace place{source_.path(), static_cast<McapRecord>(content_[at_]), offset_,
                  static_cast<std::int64_t>(at_)};
  const auto length = left < kMcapRecordHead ? 0 : little_endian_at<std::uint64_t>(&content_[at_ + 1]);
  if (left < kMcapRecordHead || length > left - kMcapRecordHead)
    throw mcap_error(place, {.problem = "is longer than the rest of the chunk"});
  if (!may_stand_in_chunk(place.kind)) throw mcap_error(place, {.problem = "is not allowed in a chunk"});
  const auto content = content_.subspan(at_ + kMcapRecordHead, static_cast<std::size_t>(length));
  at_ += kMcapRecordHead + content.size();
  return McapChunkRecord{content, place};
}

}  // namespace armtune::internal
