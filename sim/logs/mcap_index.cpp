#include "sim/logs/mcap_index.hpp"

#include <utility>

#include "sim/logs/crc32.hpp"

namespace armtune::internal {

void McapIndex::add_message(std::uint16_t channel, std::uint64_t time, std::uint64_t offset) {
  times_.add(time);
  chunk_times_.add(time);
  ++count_of_channel_[channel];
  chunk_messages_[channel].emplace_back(time, offset);
}

void McapIndex::end_chunk(const McapChunkPlace& place, ByteBuffer& out) {
  Chunk chunk{place, std::exchange(chunk_times_, {}), {}, 0};
  const std::size_t begin = out.size();
  for (auto& [channel, messages] : chunk_messages_) {
    if (messages.empty()) continue;
    chunk.message_indexes.emplace_back(channel, place.offset + place.length + out.size() - begin);
    // Readers that follow the index expect it in the order of time.
    std::stable_sort(messages.begin(), messages.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t record = out.begin(McapRecord::kMessageIndex);
    out.number<std::uint16_t>(channel);
    out.number<std::uint32_t>(static_cast<std::uint32_t>(16 * messages.size()));
    for (const auto& [time, offset] : messages) {
      out.number<std::uint64_t>(time);
      out.number<std::uint64_t>(offset);
    }
    out.end(record);
    messages.clear();
  }
  chunk.indexes_length = out.size() - begin;
  chunks_.push_back(std::move(chunk));
}

void McapIndex::add_statistics(ByteBuffer& out) const {
  const std::size_t record = out.begin(McapRecord::kStatistics);
  out.number<std::uint64_t>(times_.count);
  out.number<std::uint16_t>(static_cast<std::uint16_t>(schemas_.size()));
  out.number<std::uint32_t>(static_cast<std::uint32_t>(channels_.size()));
  out.number<std::uint32_t>(0);  // attachments
  out.number<std::uint32_t>(0);  // metadata
  out.number<std::uint32_t>(static_cast<std::uint32_t>(chunks_.size()));
  out.number<std::uint64_t>(times_.first);
  out.number<std::uint64_t>(times_.last);
  out.number<std::uint32_t>(static_cast<std::uint32_t>(10 * count_of_channel_.size()));
  for (const auto& [channel, count] : count_of_channel_) {
    out.number<std::uint16_t>(channel);
    out.number<std::uint64_t>(count);
  }
  out.end(record);
}

void McapIndex::add_chunk_index(const Chunk& chunk, ByteBuffer& out) {
  const std::size_t record = out.begin(McapRecord::kChunkIndex);
  out.number<std::uint64_t>(chunk.times.first);
  out.number<std::uint64_t>(chunk.times.last);
  out.number<std::uint64_t>(chunk.place.offset);
  out.number<std::uint64_t>(chunk.place.length);
  out.number<std::uint32_t>(static_cast<std::uint32_t>(10 * chunk.message_indexes.size()));
  for (const auto& [channel, offset] : chunk.message_indexes) {
    out.number<std::uint16_t>(channel);
    out.number<std::uint64_t>(offset);
  }
  out.number<std::uint64_t>(chunk.indexes_length);
  out.text(chunk.place.compression);
  out.number<std::uint64_t>(chunk.place.compressed_size);
  out.number<std::uint64_t>(chunk.place.size);
  out.end(record);
}

void McapIndex::write_end(std::uint64_t offset, ByteBuffer& out) const {
  const std::size_t begin = out.size();
  ByteBuffer offsets;
  const auto group = [&](McapRecord kind, auto write) {
    const std::size_t start = out.size();
    write();
    if (out.size() == start) return;
    const std::size_t record = offsets.begin(McapRecord::kSummaryOffset);
    offsets.number<std::uint8_t>(static_cast<std::uint8_t>(kind));
    offsets.number<std::uint64_t>(offset + start - begin);
    offsets.number<std::uint64_t>(out.size() - start);
    offsets.end(record);
  };
  group(McapRecord::kSchema, [&] {
    for (const Bytes& record : schemas_) out.add(record);
  });
  group(McapRecord::kChannel, [&] {
    for (const Bytes& record : channels_) out.add(record);
  });
  group(McapRecord::kStatistics, [&] { add_statistics(out); });
  group(McapRecord::kChunkIndex, [&] {
    for (const Chunk& chunk : chunks_) add_chunk_index(chunk, out);
  });
  const std::uint64_t offsets_begin = offset + out.size() - begin;
  out.add(offsets.bytes());
  const std::size_t footer = out.begin(McapRecord::kFooter);
  out.number<std::uint64_t>(offset);
  out.number<std::uint64_t>(offsets_begin);
  out.put<std::uint64_t>(footer + 1, kMcapFooter);  // the checksum covers the length as well
  out.number<std::uint32_t>(crc32_of(out.bytes().subspan(begin)));
  out.end(footer);
  out.add(kMcapMagic);
}

}  // namespace armtune::internal
