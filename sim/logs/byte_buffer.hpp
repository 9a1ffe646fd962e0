#pragma once
// Builds the records of MCAP files: little-endian numbers, and strings with their length in front.

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "sim/logs/mcap_format.hpp"

namespace armtune::internal {

/// Appends fields to bytes in memory. A record is begun with begin(), and end() states its length:
///
///     const std::size_t begin = buffer.begin(McapRecord::kDataEnd);
///     buffer.number<std::uint32_t>(crc);
///     buffer.end(begin);
class ByteBuffer {
 public:
  template <std::unsigned_integral Number>
  void number(std::type_identity_t<Number> value) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof(Number));
    put<Number>(at, value);
  }

  void add(std::span<const std::byte> bytes) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + bytes.size());  // g++ 12 warns of an overflow where a vector inserts
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(at));
  }

  /// Appends the length of the text as 32 bits, and the text.
  void text(std::string_view text) {
    number<std::uint32_t>(static_cast<std::uint32_t>(text.size()));
    add(std::as_bytes(std::span(text)));
  }

  /// Appends the head of a record and returns its offset.
  std::size_t begin(McapRecord kind) {
    const std::size_t begin = bytes_.size();
    bytes_.push_back(static_cast<std::byte>(kind));
    number<std::uint64_t>(0);
    return begin;
  }

  /// Ends the record that begins at the offset.
  void end(std::size_t begin) { put<std::uint64_t>(begin + 1, bytes_.size() - begin - kMcapRecordHead); }

  /// Overwrites the number at the offset.
  template <std::unsigned_integral Number>
  void put(std::size_t at, std::type_identity_t<Number> value) {
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      bytes_[at + byte] = static_cast<std::byte>((static_cast<std::uint64_t>(value) >> (8 * byte)) & 0xFFU);
  }

  std::span<const std::byte> bytes() const noexcept { return bytes_; }
  std::size_t size() const noexcept { return bytes_.size(); }
  void clear() noexcept { bytes_.clear(); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace armtune::internal
