#include "tuner/report/base64.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/tuner/report/support/decode.hpp"

namespace armtune::internal::report {
namespace base64_test {

std::string of_text(const std::string& text) {
  return base64(std::vector<unsigned char>(text.begin(), text.end()));
}

TEST(Base64, GivesTheExamplesOfRfc4648) {
  // RFC 4648, section 10.
  EXPECT_EQ(of_text(""), "");
  EXPECT_EQ(of_text("f"), "Zg==");
  EXPECT_EQ(of_text("fo"), "Zm8=");
  EXPECT_EQ(of_text("foo"), "Zm9v");
  EXPECT_EQ(of_text("foob"), "Zm9vYg==");
  EXPECT_EQ(of_text("fooba"), "Zm9vYmE=");
  EXPECT_EQ(of_text("foobar"), "Zm9vYmFy");
}

TEST(Base64, ReadsBackToTheSameBytes) {
  std::mt19937 random(1);
  for (std::size_t size = 0; size < 70; ++size) {
    std::vector<unsigned char> bytes;
    for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<unsigned char>(random() & 0xffU));
    EXPECT_EQ(test::base64_bytes(base64(bytes)), bytes) << size;
  }
}

TEST(Base64, PutsTheLowestByteOfANumberFirst) {
  const std::vector<std::uint16_t> numbers = {0, 1, 256, 65534, 65535, 0x1234};
  EXPECT_EQ(test::base64_bytes(base64_u16(numbers)),
            (std::vector<unsigned char>{0, 0, 1, 0, 0, 1, 0xfe, 0xff, 0xff, 0xff, 0x34, 0x12}));
  // IEEE 754: 1 is 0x3f800000, -2 is 0xc0000000.
  const std::vector<float> singles = {1.0F, -2.0F};
  EXPECT_EQ(test::base64_bytes(base64_f32(singles)),
            (std::vector<unsigned char>{0, 0, 0x80, 0x3f, 0, 0, 0, 0xc0}));
}

}  // namespace base64_test
}  // namespace armtune::internal::report
