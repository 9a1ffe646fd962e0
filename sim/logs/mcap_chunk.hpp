#pragma once
// Reads the Chunk records of MCAP files: decompresses one at a time and walks through the records in it.

#include <cstdint>
#include <optional>
#include <span>

#include "sim/logs/byte_source.hpp"
#include "sim/logs/chunk_compression.hpp"
#include "sim/logs/mcap_place.hpp"

namespace armtune::internal {

/// A record in a chunk; the content shares the chunk's memory until the next chunk is read.
struct McapChunkRecord {
  std::span<const std::byte> content;
  McapPlace place;
};

class McapChunk {
 public:
  explicit McapChunk(ByteSource& source) : source_(source) {}

  /// Reads and decompresses the Chunk record at which the source stands, and moves the source past it.
  /// length: of its content, as stated before it. Returns false, with no record in the chunk, if the file
  /// ends before the record does. Throws InputError at the place if the chunk is damaged, if its compression
  /// is unknown, if its checksum or size is not the stated one, or if it exceeds a limit of mcap_format.hpp.
  bool read(std::uint64_t length, const McapPlace& place);

  /// Returns the next record of the chunk: a Schema, Channel or Message, or one of a kind that the
  /// specification does not know yet. Returns nothing at its end. Throws InputError if the record is longer
  /// than the rest of the chunk, or if records of its kind must not be in a chunk.
  std::optional<McapChunkRecord> next_record();

 private:
  struct Head {
    std::uint64_t size = 0;
    std::uint32_t crc = 0;
    ChunkCompression compression = ChunkCompression::kNone;
    std::uint64_t compressed_size = 0;
    std::size_t bytes = 0;  ///< of the record before the compressed ones, with the kind and length
  };

  static Head head_of(std::span<const std::byte> record, std::uint64_t length, const McapPlace& place);
  void check_expansion(std::uint64_t length, const McapPlace& place);
  bool decompress(const Head& head, const McapPlace& place);

  ByteSource& source_;
  ChunkDecoder decoder_;
  std::uint64_t offset_ = 0;  ///< of the Chunk record in the file
  std::span<const std::byte> content_;
  std::size_t at_ = 0;
  std::uint64_t expanded_ = 0;  ///< bytes of all chunks after decompression
};

}  // namespace armtune::internal
