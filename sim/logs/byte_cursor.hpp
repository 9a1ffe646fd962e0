#pragma once
// Reads the fields of an MCAP record one after another; a field that does not fit into the record is refused.

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "sim/logs/mcap_place.hpp"

namespace armtune::internal {

/// Returns the little-endian number at the beginning of the bytes. There must be enough bytes for it.
template <std::unsigned_integral Number>
Number little_endian_at(const std::byte* at) noexcept {
  Number number = 0;
  for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
    number =
        static_cast<Number>(number | static_cast<Number>(std::to_integer<Number>(at[byte]) << (8 * byte)));
  return number;
}

/// Walks through the content of one record. Every function throws the InputError of the record's place if the
/// content ends before the field does.
class ByteCursor {
 public:
  ByteCursor(std::span<const std::byte> content, const McapPlace& place) : left_(content), place_(place) {}

  template <std::unsigned_integral Number>
  Number number() {
    return little_endian_at<Number>(take(sizeof(Number)).data());
  }

  /// Reads a byte count of 32 bits, and returns that many bytes after it: a string, a schema's data, an array
  /// or a map.
  std::span<const std::byte> counted_bytes() { return take(number<std::uint32_t>()); }

  /// Does the same, and returns the bytes as text, which shares the memory of the content.
  std::string_view text() {
    const std::span<const std::byte> bytes = counted_bytes();
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // bytes as text
  }

  std::span<const std::byte> left() const noexcept { return left_; }

 private:
  std::span<const std::byte> take(std::size_t count) {
    if (count > left_.size()) {
      throw mcap_error(place_, {.problem = "has a field that is longer than the rest of the record",
                                .value = std::to_string(count),
                                .limit = "at most " + std::to_string(left_.size()) + " bytes"});
    }
    const auto taken = left_.first(count);
    left_ = left_.subspan(count);
    return taken;
  }

  std::span<const std::byte> left_;
  const McapPlace& place_;
};

}  // namespace armtune::internal
