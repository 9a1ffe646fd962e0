#pragma once
// Bytes as text (RFC 4648, the standard alphabet, padded).

#include <cstdint>
#include <span>
#include <string>

namespace armtune::internal::report {

std::string base64(std::span<const unsigned char> bytes);

/// Each number as two bytes, the lower one first.
std::string base64_u16(std::span<const std::uint16_t> numbers);

/// Each number as the four bytes of an IEEE single, the lowest one first.
std::string base64_f32(std::span<const float> numbers);

}  // namespace armtune::internal::report
