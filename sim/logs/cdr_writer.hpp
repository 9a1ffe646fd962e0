#pragma once
// Writes the serialised form of ROS 2 messages that CdrReader reads: CDR in its first version, XCDR1 in
// DDS-XTypes 1.3, section 7.4, little-endian, with the encapsulation header of DDSI-RTPS 2.5, section 10.2. A
// primitive value is aligned to its size, counted from the end of the header.
//
//     CdrWriter message;
//     bag.write(topic, time, message.begin().number(0.5).bytes());  // a std_msgs/Float64

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace armtune::internal {

/// Writes one message after another, each from its first field to its last, into the same memory.
class CdrWriter {
 public:
  CdrWriter() { begin(); }

  /// Begins the next message.
  CdrWriter& begin() {
    constexpr std::byte kLittleEndian{1};
    bytes_.assign(kHeader, std::byte{0});
    bytes_[1] = kLittleEndian;
    return *this;
  }

  /// Writes an integer or floating point number of 1, 2, 4 or 8 bytes.
  template <typename Number>
  CdrWriter& number(Number value) {
    const std::size_t over = (bytes_.size() - kHeader) % sizeof(Number);
    const std::size_t at = bytes_.size() + (over > 0 ? sizeof(Number) - over : 0);
    bytes_.resize(at + sizeof(Number), std::byte{0});  // padding is zero, so that equal messages are equal
    std::memcpy(&bytes_[at], &value, sizeof(Number));
    if constexpr (std::endian::native == std::endian::big)
      std::reverse(bytes_.begin() + static_cast<std::ptrdiff_t>(at), bytes_.end());
    return *this;
  }

  /// Writes the length of a sequence, whose elements follow.
  CdrWriter& length(std::size_t length) { return number(static_cast<std::uint32_t>(length)); }

  /// Writes a string, with its length and a final zero.
  CdrWriter& string(std::string_view text) {
    length(text.size() + 1);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + text.size() + 1, std::byte{0});
    if (!text.empty()) std::memcpy(&bytes_[at], text.data(), text.size());
    return *this;
  }

  /// Writes a sequence of numbers.
  CdrWriter& numbers(std::span<const double> values) {
    length(values.size());
    for (const double value : values) number(value);
    return *this;
  }

  /// Returns the message as far as it is written. Valid until the next call.
  std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  static constexpr std::size_t kHeader = 4;

  std::vector<std::byte> bytes_;
};

}  // namespace armtune::internal
