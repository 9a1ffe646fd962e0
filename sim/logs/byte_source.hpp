#pragma once
// Streams the bytes of a file of any size through a buffer that is as large as the largest piece that was
// asked for.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/logs/crc32.hpp"

namespace armtune::internal {

/// Reads a file, pipe or device from front to back, in memory that grows only by bytes that were really read:
///
///     const auto head = source.peek(9);  // fewer than 9 bytes: the file ends here
///     source.skip(head.size());
class ByteSource {
 public:
  /// Opens the file. Throws InputError with the path if it is missing, is a directory or cannot be opened.
  /// `kind` describes the expected content in messages, for example "an MCAP file".
  ByteSource(const std::filesystem::path& path, const std::string& kind);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Returns the next `count` bytes, or all that are left if the file ends before. It does not move past
  /// them, so the next call returns the same bytes. The span is valid until the next call of a function that
  /// is not const. Throws InputError if the file cannot be read.
  std::span<const std::byte> peek(std::size_t count);

  /// Moves past bytes that peek() returned; count: at most as many.
  void skip(std::size_t count) noexcept { begin_ += count; }

  /// Moves past the next bytes in bounded memory. Returns false if the file ends before, and is then at its
  /// end. Throws InputError if the file cannot be read.
  bool pass(std::uint64_t count);

  /// Returns how many bytes were skipped or passed.
  std::uint64_t offset() const noexcept { return offset_of_buffer_ + begin_; }

  /// Returns the CRC-32 of the bytes that were skipped or passed since restart_crc(), or since the file's
  /// first byte.
  std::uint32_t crc();
  void restart_crc();

  /// True if this is a regular file whose last bytes are these. Does not move the position of reading.
  bool ends_with(std::span<const std::byte> bytes) const;

  /// Returns the path as it was given.
  const std::string& path() const noexcept { return path_; }

 private:
  std::size_t read(std::byte* to, std::size_t most) const;
  void hash_skipped();

  std::string path_;
  int descriptor_ = -1;
  std::vector<std::byte> buffer_;
  std::size_t begin_ = 0;   ///< of the bytes that were read and not skipped
  std::size_t end_ = 0;     ///< of the same
  std::size_t hashed_ = 0;  ///< how many bytes at the front of the buffer crc_ has
  std::uint64_t offset_of_buffer_ = 0;
  Crc32 crc_;
};

}  // namespace armtune::internal
