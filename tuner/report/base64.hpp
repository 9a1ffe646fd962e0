#pragma once
// Encodes bytes and numbers as base64 text (RFC 4648, standard alphabet, padded).

#include <cstdint>
#include <span>
#include <string>

namespace armtune::internal::report {

std::string base64(std::span<const unsigned char> bytes);

/// Encodes each number as two bytes, lowest byte first.
std::string base64_u16(std::span<const std::uint16_t> numbers);

/// Encodes each number as the four bytes of an IEEE single, lowest byte first.
std::string base64_f32(std::span<const float> numbers);

}  // namespace armtune::internal::report
