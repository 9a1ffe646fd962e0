#pragma once
// The checksum CRC-32 of ISO 3309 and zlib, by which readers of MCAP files detect damaged bytes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace armtune::internal {

/// Computes the CRC-32 of bytes that are passed piece by piece: polynomial 0x04C11DB7, reflected, begun with
/// all bits set and inverted at the end. Source: ISO 3309, section 8.1.1.6.2. It takes 16 bytes at a time by
/// tables (Kounavis and Berry, "A systematic approach to building high performance software-based CRC
/// generators", ISCC 2005).
class Crc32 {
 public:
  void add(std::span<const std::byte> bytes) noexcept;

  /// Returns the checksum of all bytes so far; 0 if there were none.
  std::uint32_t value() const noexcept { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFFU;
};

/// Returns the CRC-32 of the bytes.
std::uint32_t crc32_of(std::span<const std::byte> bytes) noexcept;

}  // namespace armtune::internal
