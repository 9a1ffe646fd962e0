// Serialised messages against bytes that follow from the standard, and against the reader.

#include "sim/logs/cdr_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "sim/logs/cdr_reader.hpp"

namespace armtune::internal {
namespace cdr_writer_test {

std::vector<int> bytes_of(const CdrWriter& writer) {
  std::vector<int> bytes;
  for (const std::byte byte : writer.bytes()) bytes.push_back(std::to_integer<int>(byte));
  return bytes;
}

TEST(CdrWriter, AlignsEachNumberToItsSizeBehindTheHeader) {
  CdrWriter writer;
  writer.number(std::uint8_t{7}).number(1.0).number(std::uint16_t{0x0102}).number(std::int32_t{-2});
  // 1.0 is 0x3ff0000000000000. It begins 8 bytes behind the header, which has 4 bytes.
  EXPECT_THAT(bytes_of(writer),
              testing::ElementsAreArray({0,    1,    0,    0,                      // header
                                         7,    0,    0,    0,   0, 0, 0,    0,     // 7, padding
                                         0,    0,    0,    0,   0, 0, 0xf0, 0x3f,  // 1.0
                                         2,    1,    0,    0,                      // 0x0102, padding
                                         0xfe, 0xff, 0xff, 0xff}));                // -2
}

TEST(CdrWriter, StringsEndWithAZeroAndEmptySequencesHaveOnlyTheirLength) {
  CdrWriter writer;
  writer.string("ab").numbers({}).string("");
  EXPECT_THAT(bytes_of(writer), testing::ElementsAreArray({0, 1, 0, 0,             //
                                                           3, 0, 0, 0, 97, 98, 0,  // "ab" with its zero
                                                           0,                      // padding
                                                           0, 0, 0, 0,             // no numbers
                                                           1, 0, 0, 0, 0}));
  EXPECT_THAT(bytes_of(writer.begin()), testing::ElementsAre(0, 1, 0, 0))
      << "nothing is left of the last one";
}

TEST(CdrWriter, TheReaderReadsBackWhatWasWritten) {
  std::mt19937 generator(3);
  CdrWriter writer;
  for (int message = 0; message < 200; ++message) {
    const auto order = static_cast<unsigned>(generator());
    const std::string text(generator() % 9, 'x');
    const std::vector<double> values(generator() % 4, 0.1 * message);
    writer.begin();
    for (unsigned k = 0; k < 6; ++k) {
      switch ((order >> (2 * k)) % 4) {
        case 0:
          writer.number(static_cast<std::uint8_t>(k));
          break;
        case 1:
          writer.number(std::int64_t{-5} * k);
          break;
        case 2:
          writer.string(text);
          break;
        default:
          writer.numbers(values);
      }
    }
    CdrReader reader(writer.bytes());
    for (unsigned k = 0; k < 6; ++k) {
      switch ((order >> (2 * k)) % 4) {
        case 0:
          EXPECT_EQ(reader.number<std::uint8_t>(), k);
          break;
        case 1:
          EXPECT_EQ(reader.number<std::int64_t>(), std::int64_t{-5} * k);
          break;
        case 2:
          EXPECT_EQ(reader.string(0), text);
          break;
        default:
          ASSERT_EQ(reader.length(0), values.size());
          for (const double value : values) EXPECT_EQ(reader.number<double>(), value);
      }
    }
    EXPECT_EQ(reader.fault(), CdrFault::kNone);
    EXPECT_EQ(reader.rest(), 0U);
  }
}

}  // namespace cdr_writer_test
}  // namespace armtune::internal
