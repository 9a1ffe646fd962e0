#pragma once
// Converts values to bytes and back, for messages between MPI ranks. The values that are read are
// bit-identical to those written. Numbers are little-endian. A text is stored as its length and its bytes.

#include <bit>
#include <concepts>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "armtune/error.hpp"

namespace armtune::internal {

class ByteWriter {
 public:
  void add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i, value >>= 8U) bytes_.push_back(static_cast<char>(value & 0xFFU));
  }
  /// Adds all bits of the number, also the payload of a NaN and the sign of -0.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    bytes_.append(text);
  }
  /// Prevents implicit conversions from other number types.
  template <typename T>
  void add(T) requires std::integral<T> || std::floating_point<T>
  = delete;

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// A reader that returns values in the order in which they were added. Throws FailedError if the message is
/// too short.
class ByteReader {
 public:
  /// The bytes must outlive the reader.
  explicit ByteReader(std::string_view bytes) : left_(bytes) {}

  std::uint64_t integer() {
    const std::string_view eight = take(8);
    std::uint64_t value = 0;
    for (int i = 7; i >= 0; --i) {
      value = value << 8U | static_cast<unsigned char>(eight[static_cast<std::size_t>(i)]);
    }
    return value;
  }
  double number() { return std::bit_cast<double>(integer()); }
  std::string text() { return std::string(take(integer())); }
  /// Throws FailedError if some bytes were not read.
  void end() const {
    if (!left_.empty()) {
      throw FailedError("a message between ranks is " + std::to_string(left_.size()) + " bytes too long");
    }
  }

 private:
  std::string_view take(std::uint64_t count) {
    if (count > left_.size()) {
      throw FailedError("a message between ranks is too short: expected " + std::to_string(count) +
                        " more bytes, but " + std::to_string(left_.size()) + " are left");
    }
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

  std::string_view left_;
};

}  // namespace armtune::internal
