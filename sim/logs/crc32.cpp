#include "sim/logs/crc32.hpp"

#include <array>

namespace armtune::internal {
namespace {

constexpr std::size_t kStride = 16;
constexpr std::uint32_t kReflectedPolynomial = 0xEDB88320U;  // the bits of 0x04C11DB7 in reverse order

using CrcTables = std::array<std::array<std::uint32_t, 256>, kStride>;

/// tables[k][b]: the remainder of the byte b that is followed by k bytes of zeros.
constexpr CrcTables make_crc_tables() {
  CrcTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = (rest >> 1) ^ ((rest & 1U) != 0 ? kReflectedPolynomial : 0U);
    tables[0][byte] = rest;
  }
  for (std::size_t k = 1; k < kStride; ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = tables[k - 1][byte];
      tables[k][byte] = (before >> 8) ^ tables[0][before & 0xFFU];
    }
  }
  return tables;
}

constexpr CrcTables kTables = make_crc_tables();

std::uint32_t word_at(const std::byte* at) {
  return std::to_integer<std::uint32_t>(at[0]) | std::to_integer<std::uint32_t>(at[1]) << 8 |
         std::to_integer<std::uint32_t>(at[2]) << 16 | std::to_integer<std::uint32_t>(at[3]) << 24;
}

/// The part of four bytes of a stride; `zeros` bytes of it follow them.
std::uint32_t word_part(std::uint32_t word, std::size_t zeros) {
  return kTables[zeros + 3][word & 0xFFU] ^ kTables[zeros + 2][(word >> 8) & 0xFFU] ^
         kTables[zeros + 1][(word >> 16) & 0xFFU] ^ kTables[zeros][word >> 24];
}

}  // namespace

void Crc32::add(std::span<const std::byte> bytes) noexcept {
  std::uint32_t state = state_;
  const std::byte* at = bytes.data();
  std::size_t left = bytes.size();
  for (; left >= kStride; left -= kStride, at += kStride) {
    state = word_part(word_at(at) ^ state, 12) ^ word_part(word_at(at + 4), 8) ^
            word_part(word_at(at + 8), 4) ^ word_part(word_at(at + 12), 0);
  }
  for (; left > 0; --left, ++at)
    state = (state >> 8) ^ kTables[0][(state ^ std::to_integer<std::uint32_t>(*at)) & 0xFFU];
  state_ = state;
}

std::uint32_t crc32_of(std::span<const std::byte> bytes) noexcept {
  Crc32 crc;
  crc.add(bytes);
  return crc.value();
}

}  // namespace armtune::internal
