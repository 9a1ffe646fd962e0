#pragma once
// Values as bytes and back, the same to the bit: what ranks send each other. Little-endian; a text is its
// length and its bytes.

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
  /// NaN keeps its payload, -0 its sign.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(std::uint64_t{text.size()});
    bytes_.append(text);
  }
  /// Nothing else is turned into one of these by accident.
  template <typename T>
  void add(T) requires std::integral<T> || std::floating_point<T>
  = delete;

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes values out in the order they were added. Throws FailedError where the message is too short.
class ByteReader {
 public:
  /// bytes: outlive the reader.
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
  /// Throws FailedError unless everything was taken.
  void end() const {
    if (!left_.empty()) {
      throw FailedError("a message is " + std::to_string(left_.size()) + " bytes too long");
    }
  }

 private:
  std::string_view take(std::uint64_t count) {
    if (count > left_.size()) {
      throw FailedError("a message ends where " + std::to_string(count) + " more bytes should be, " +
                        std::to_string(left_.size()) + " are left");
    }
    const std::string_view taken = left_.substr(0, count);
    left_.remove_prefix(count);
    return taken;
  }

  std::string_view left_;
};

}  // namespace armtune::internal
