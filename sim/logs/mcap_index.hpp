#pragma once
// The index of an MCAP file that is being written: where each chunk and each message is, and the summary that
// follows the data.

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/logs/byte_buffer.hpp"

namespace armtune::internal {

/// The earliest and the latest of some times [ns]; 0 and 0 as long as there are none.
struct McapTimes {
  std::uint64_t first = 0;
  std::uint64_t last = 0;
  std::uint64_t count = 0;

  void add(std::uint64_t time) {
    first = count == 0 ? time : std::min(first, time);
    last = count == 0 ? time : std::max(last, time);
    ++count;
  }
};

/// The place of a chunk that was written; offsets in bytes from the beginning of the file.
struct McapChunkPlace {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;  ///< bytes of the whole record
  std::string_view compression;
  std::uint64_t compressed_size = 0;
  std::uint64_t size = 0;
};

class McapIndex {
 public:
  /// Keeps a Schema or Channel record, because the summary repeats it.
  void add_schema(std::span<const std::byte> record) { schemas_.push_back({record.begin(), record.end()}); }
  void add_channel(std::span<const std::byte> record) { channels_.push_back({record.begin(), record.end()}); }

  /// Enters a message of the chunk that is being filled. offset: bytes from the beginning of the chunk's
  /// content to the record.
  void add_message(std::uint16_t channel, std::uint64_t time, std::uint64_t offset);

  /// Returns the times of the messages in the chunk that is being filled.
  const McapTimes& chunk_times() const noexcept { return chunk_times_; }

  /// Enters the chunk that was written, and appends the MessageIndex records that stand behind it.
  void end_chunk(const McapChunkPlace& place, ByteBuffer& out);

  /// Appends all that stands behind the DataEnd record: summary, summary offsets, Footer and magic. offset:
  /// of the first of these bytes in the file.
  void write_end(std::uint64_t offset, ByteBuffer& out) const;

 private:
  struct Chunk {
    McapChunkPlace place;
    McapTimes times;
    std::vector<std::pair<std::uint16_t, std::uint64_t>> message_indexes;  // channel, offset in the file
    std::uint64_t indexes_length = 0;
  };
  using Bytes = std::vector<std::byte>;

  void add_statistics(ByteBuffer& out) const;
  static void add_chunk_index(const Chunk& chunk, ByteBuffer& out);

  std::vector<Bytes> schemas_;
  std::vector<Bytes> channels_;
  std::vector<Chunk> chunks_;
  std::map<std::uint16_t, std::uint64_t> count_of_channel_;
  McapTimes times_;
  McapTimes chunk_times_;
  std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>
      chunk_messages_;  // time, offset
};

}  // namespace armtune::internal
