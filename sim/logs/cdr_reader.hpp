#pragma once
// Reads the serialised form of ROS 2 messages: CDR (Common Data Representation) in its first version, XCDR1
// in DDS-XTypes 1.3, section 7.4, with the encapsulation header of DDSI-RTPS 2.5, section 10.2. A primitive
// value is aligned to its size, counted from the end of the header.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>

namespace armtune::internal {

/// Why a message cannot be read.
enum class CdrFault : std::uint8_t {
  kNone,
  kTruncated,      ///< it ends before a value
  kLength,         ///< it gives a length that is longer than the rest of the message
  kBound,          ///< a sequence or string is longer than its definition allows
  kEncapsulation,  ///< its header is not that of CDR in either byte order
  kCompressed      ///< it is compressed by Zstandard
};

/// Reads the values of one message from the front to the back. After the first fault every value is 0 and
/// every length is 0. So a caller needs to look for faults only once, at the end.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::byte> message) : bytes_(message) {
    constexpr std::uint8_t kLittleEndian = 1;
    if (bytes_.size() < kHeader) {
      fail(CdrFault::kTruncated);
    } else if (bytes_[0] != std::byte{0} || std::to_integer<std::uint8_t>(bytes_[1]) > kLittleEndian) {
      fail(is_zstd(bytes_) ? CdrFault::kCompressed : CdrFault::kEncapsulation);
    } else {
      const bool is_little = std::to_integer<std::uint8_t>(bytes_[1]) == kLittleEndian;
      swaps_ = is_little != (std::endian::native == std::endian::little);
      at_ = kHeader;
    }
  }

  CdrFault fault() const { return fault_; }
  /// Returns the offset of the next value, or of the value at which reading failed [byte].
  std::size_t offset() const { return at_; }
  /// Returns the number of bytes that were not read; 0 after a fault.
  std::size_t rest() const { return fault_ == CdrFault::kNone ? bytes_.size() - at_ : 0; }

  /// Reads an integer or floating point number of 1, 2, 4 or 8 bytes.
  template <typename Number>
  Number number() {
    Number value{};
    align(sizeof(Number));
    if (rest() < sizeof(Number)) {
      fail(CdrFault::kTruncated);
      return value;
    }
    std::byte raw[sizeof(Number)];
    std::memcpy(raw, &bytes_[at_], sizeof(Number));
    if (swaps_) std::reverse(raw, raw + sizeof(Number));
    std::memcpy(&value, raw, sizeof(Number));
    at_ += sizeof(Number);
    return value;
  }

  /// Reads the length of a sequence. Each element has at least one byte. bound: the longest that the
  /// definition allows; 0: any.
  std::size_t length(std::size_t bound) {
    const std::size_t at = at_;
    const std::size_t length = number<std::uint32_t>();
    if (fault_ != CdrFault::kNone) return 0;
    const bool is_too_long = length > rest();
    if (!is_too_long && (bound == 0 || length <= bound)) return length;
    at_ = at;
    fail(is_too_long ? CdrFault::kLength : CdrFault::kBound);
    return 0;
  }

  /// Reads a string, which is serialised with its length and a final zero. The result points into the
  /// message.
  std::string_view string(std::size_t bound) {
    const std::size_t length = this->length(bound == 0 ? 0 : bound + 1);
    const char* begin = reinterpret_cast<const char*>(bytes_.data()) + at_;  // bytes are characters here
    skip(length);
    std::string_view text(begin, length);
    if (text.ends_with('\0')) text.remove_suffix(1);
    return text;
  }

  /// Passes over `count` values of `size` bytes each, which are aligned to `size`.
  void skip(std::size_t count, std::size_t size) {
    if (count == 0) return;
    align(size);
    if (count > rest() / size) return fail(CdrFault::kTruncated);
    skip(count * size);
  }

  /// Passes over bytes that have no alignment.
  void skip(std::size_t bytes) {
    if (bytes > rest()) return fail(CdrFault::kTruncated);
    at_ += bytes;
  }

 private:
  static constexpr std::size_t kHeader = 4;

  static bool is_zstd(std::span<const std::byte> bytes) {
    return bytes[0] == std::byte{0x28} && bytes[1] == std::byte{0xb5} && bytes[2] == std::byte{0x2f} &&
           bytes[3] == std::byte{0xfd};
  }

  void align(std::size_t size) {
    const std::size_t over = (at_ - kHeader) % size;
    if (over > 0) skip(size - over);
  }

  void fail(CdrFault fault) {
    if (fault_ == CdrFault::kNone) fault_ = fault;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  bool swaps_ = false;
  CdrFault fault_ = CdrFault::kNone;
};

}  // namespace armtune::internal
