#pragma once
// Compresses and decompresses the chunks of MCAP files. A chunk is an LZ4 frame, a Zstandard frame, or not
// compressed. The libraries liblz4 and libzstd stay behind this header.

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace armtune::internal {

enum class ChunkCompression { kNone, kLz4, kZstd };

/// Returns the name by which MCAP files state the compression: "", "lz4" or "zstd".
std::string_view chunk_compression_name(ChunkCompression compression);

/// Returns the compression of that name; nothing if armtune does not know it.
std::optional<ChunkCompression> chunk_compression_of(std::string_view name);

/// Returns the bytes as one frame. The same bytes give the same frame with the same version of the library.
std::vector<std::byte> compressed_chunk(ChunkCompression compression, std::span<const std::byte> bytes);

/// Decompresses one chunk after another, each of them piece by piece. Memory grows only by what was really
/// decompressed, up to the size that the file states for the chunk.
class ChunkDecoder {
 public:
  enum class Outcome {
    kGood,
    kDamaged,   ///< not a frame of this compression, or its own checksum is wrong
    kTooLarge,  ///< more than the stated size
    kTooSmall,  ///< less than the stated size, or the frame does not end
  };

  ChunkDecoder();
  ~ChunkDecoder();
  ChunkDecoder(const ChunkDecoder&) = delete;
  ChunkDecoder& operator=(const ChunkDecoder&) = delete;

  /// Begins a chunk and forgets the one before. size: bytes after decompression, as the file states them.
  void begin(ChunkCompression compression, std::size_t size);

  /// Decompresses the next piece. After anything but kGood only begin() may follow.
  Outcome add(std::span<const std::byte> piece);

  /// Returns kGood if the chunk is complete and has the stated size.
  Outcome end() const;

  /// Returns what was decompressed since begin(). Valid until the next call of begin() or add().
  std::span<const std::byte> content() const noexcept { return std::span(content_).first(filled_); }

 private:
  struct Frames;  // the libraries' states

  Outcome add_plain(std::span<const std::byte> piece);
  Outcome add_frame(std::span<const std::byte> piece);
  void make_room(std::size_t wanted);

  std::unique_ptr<Frames> frames_;
  ChunkCompression compression_ = ChunkCompression::kNone;
  std::size_t size_ = 0;
  std::vector<std::byte> content_;  // larger than what is filled: it is not cleared for each chunk
  std::size_t filled_ = 0;
  bool between_frames_ = true;
};

}  // namespace armtune::internal
