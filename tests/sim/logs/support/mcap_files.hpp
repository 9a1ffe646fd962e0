#pragma once
// MCAP files for tests: recordings that armtune writes, and records that it would never write.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "sim/logs/byte_buffer.hpp"
#include "sim/logs/chunk_compression.hpp"
#include "sim/logs/crc32.hpp"
#include "sim/logs/mcap_reader.hpp"
#include "sim/logs/mcap_writer.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal::test {

/// A message with its bytes copied.
struct KeptMessage {
  std::string topic;
  std::int64_t time = 0;
  std::string bytes;
  bool operator==(const KeptMessage&) const = default;
};

struct KeptBag {
  std::vector<BagTopic> topics;
  std::vector<KeptMessage> messages;
  bool unfinished = false;
};

inline std::string as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // bytes as text
}

inline std::span<const std::byte> as_raw(std::string_view text) {
  return std::as_bytes(std::span(text));
}

inline KeptBag read_whole(const std::string& path) {
  const auto bag = open_mcap(path);
  KeptBag kept;
  while (const auto message = bag->next())
    kept.messages.push_back({bag->topics()[message->topic].name, message->time, as_text(message->bytes)});
  kept.topics = bag->topics();
  kept.unfinished = bag->unfinished();
  return kept;
}

/// Writes `count` messages on two topics in chunks of `chunk_size` bytes, and returns them.
inline std::vector<KeptMessage> write_bag(const std::string& path, ChunkCompression compression, int count,
                                          std::size_t chunk_size = 200) {
  McapWriter bag(path, {.compression = compression, .chunk_size = chunk_size});
  const std::size_t a = bag.add_topic({"/a", "pkg/msg/A", "cdr", "float64 data\n", "ros2msg"});
  const std::size_t b = bag.add_topic({"/b", "", "json", "", ""});
  std::vector<KeptMessage> written;
  for (int n = 0; n < count; ++n) {
    const bool first = n % 3 != 2;
    const std::string bytes =
        "message " + std::to_string(n) + std::string(static_cast<std::size_t>(n % 7), 'x');
    written.push_back({first ? "/a" : "/b", 1000 + 10 * n - 25 * (n % 2), bytes});
    bag.write(first ? a : b, written.back().time, as_raw(bytes));
  }
  bag.finish();
  return written;
}

/// Appends a record with this content.
inline void add_record(ByteBuffer& out, McapRecord kind, std::span<const std::byte> content = {}) {
  const std::size_t record = out.begin(kind);
  out.add(content);
  out.end(record);
}

/// The beginning of a file: magic and Header.
inline ByteBuffer mcap_begin() {
  ByteBuffer out;
  out.add(kMcapMagic);
  const std::size_t header = out.begin(McapRecord::kHeader);
  out.text("");
  out.text("a test");
  out.end(header);
  return out;
}

/// The end of a file without a summary: Footer and magic.
inline void add_mcap_end(ByteBuffer& out) {
  ByteBuffer footer;
  footer.number<std::uint64_t>(0);
  footer.number<std::uint64_t>(0);
  footer.number<std::uint32_t>(0);
  add_record(out, McapRecord::kFooter, footer.bytes());
  out.add(kMcapMagic);
}

inline void add_schema(ByteBuffer& out, std::uint16_t number, std::string_view type,
                       std::string_view data = "") {
  const std::size_t record = out.begin(McapRecord::kSchema);
  out.number<std::uint16_t>(number);
  out.text(type);
  out.text("ros2msg");
  out.text(data);
  out.end(record);
}

inline void add_channel(ByteBuffer& out, std::uint16_t number, std::uint16_t schema, std::string_view topic) {
  const std::size_t record = out.begin(McapRecord::kChannel);
  out.number<std::uint16_t>(number);
  out.number<std::uint16_t>(schema);
  out.text(topic);
  out.text("cdr");
  out.number<std::uint32_t>(0);
  out.end(record);
}

inline void add_message(ByteBuffer& out, std::uint16_t channel, std::uint64_t time, std::string_view bytes) {
  const std::size_t record = out.begin(McapRecord::kMessage);
  out.number<std::uint16_t>(channel);
  out.number<std::uint32_t>(0);
  out.number<std::uint64_t>(time);
  out.number<std::uint64_t>(time);
  out.add(as_raw(bytes));
  out.end(record);
}

/// What a Chunk record states; what is left out is the truth about `records`.
struct ChunkClaims {
  std::string_view compression = "";
  std::optional<std::uint64_t> size = {};
  std::uint32_t crc = 0;
  std::optional<std::uint64_t> compressed_size = {};
};

/// Appends a Chunk record that holds the bytes, which are compressed already.
inline void add_chunk(ByteBuffer& out, std::span<const std::byte> records, const ChunkClaims& claims = {}) {
  const std::size_t record = out.begin(McapRecord::kChunk);
  out.number<std::uint64_t>(0);
  out.number<std::uint64_t>(0);
  out.number<std::uint64_t>(claims.size.value_or(records.size()));
  out.number<std::uint32_t>(claims.crc);
  out.text(claims.compression);
  out.number<std::uint64_t>(claims.compressed_size.value_or(records.size()));
  out.add(records);
  out.end(record);
}

}  // namespace armtune::internal::test
