#include "sim/logs/crc32.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace armtune::internal {
namespace crc32_test {

std::span<const std::byte> raw(std::string_view text) {
  return std::as_bytes(std::span(text));
}

/// The definition, bit by bit (ISO 3309): the remainder of the reflected polynomial 0xEDB88320.
std::uint32_t crc_by_bits(std::string_view text) {
  std::uint32_t state = 0xFFFFFFFFU;
  for (const char c : text) {
    state ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) state = (state >> 1) ^ ((state & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~state;
}

TEST(Crc32, HasTheCheckValueOfThePublishedAlgorithm) {
  // "123456789" is the check input of the catalogue of parametrised CRC algorithms (CRC-32/ISO-HDLC).
  EXPECT_EQ(crc32_of(raw("123456789")), 0xCBF43926U);
  EXPECT_EQ(crc32_of({}), 0U);
}

TEST(Crc32, IsTheDefinitionForEveryLengthAndEveryDivisionIntoPieces) {
  std::string text;
  for (int n = 0; n < 100; ++n) {
    EXPECT_EQ(crc32_of(raw(text)), crc_by_bits(text)) << n;
    for (std::size_t cut = 0; cut <= text.size(); cut += 7) {
      Crc32 crc;
      crc.add(raw(text).first(cut));
      crc.add(raw(text).subspan(cut));
      EXPECT_EQ(crc.value(), crc_by_bits(text)) << n << " cut at " << cut;
    }
    text += static_cast<char>(37 * n + 200);
  }
}

}  // namespace crc32_test
}  // namespace armtune::internal
