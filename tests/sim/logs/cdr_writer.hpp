#pragma once
// Serialises messages for tests: CDR as DDS-XTypes 1.3, section 7.4, describes it, in either byte order.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace armtune::internal::test {

class CdrWriter {
 public:
  explicit CdrWriter(std::endian order = std::endian::little) : order_(order) {
    bytes_ = {std::byte{0}, order == std::endian::little ? std::byte{1} : std::byte{0}, std::byte{0},
              std::byte{0}};
  }

  template <typename Number>
  CdrWriter& number(Number value) {
    while ((bytes_.size() - 4) % sizeof(Number) != 0)
      bytes_.push_back(std::byte{0xee});  // padding is arbitrary
    std::byte raw[sizeof(Number)];
    std::memcpy(raw, &value, sizeof(Number));
    if (order_ != std::endian::native) std::reverse(raw, raw + sizeof(Number));
    bytes_.insert(bytes_.end(), raw, raw + sizeof(Number));
    return *this;
  }

  CdrWriter& string(const std::string& text) {
    length(text.size() + 1);
    for (const char c : text) bytes_.push_back(static_cast<std::byte>(c));
    bytes_.push_back(std::byte{0});
    return *this;
  }
  CdrWriter& length(std::size_t length) { return number(static_cast<std::uint32_t>(length)); }
  CdrWriter& strings(std::initializer_list<const char*> texts) {
    length(texts.size());
    for (const char* text : texts) string(text);
    return *this;
  }
  CdrWriter& doubles(const std::vector<double>& values) {
    length(values.size());
    for (const double value : values) number(value);
    return *this;
  }
  CdrWriter& header(std::int32_t sec, std::uint32_t nanosec, const std::string& frame = "base") {
    return number(sec).number(nanosec).string(frame);
  }
  /// A trajectory_msgs/JointTrajectoryPoint.
  CdrWriter& point(const std::vector<double>& positions) {
    return doubles(positions)
        .doubles({})
        .doubles({})
        .doubles({})
        .number(std::int32_t{1})
        .number(std::uint32_t{500'000'000});
  }
  /// A trajectory_msgs/MultiDOFJointTrajectoryPoint without content.
  CdrWriter& empty_multi_dof_point() {
    return length(0).length(0).length(0).number(std::int32_t{0}).number(std::uint32_t{0});
  }

  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::endian order_;
  std::vector<std::byte> bytes_;
};

}  // namespace armtune::internal::test
