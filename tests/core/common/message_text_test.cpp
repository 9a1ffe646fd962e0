#include "core/common/message_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "armtune/error.hpp"
#include "core/common/utf8.hpp"

namespace armtune::internal {
namespace message_text_test {

TEST(OneLine, EscapesLineBreaksAndControlCharacters) {
  EXPECT_EQ(one_line("a\nb\tc\x1b[31m \x7f é"), "a\\nb\\x09c\\x1b[31m \\x7f é");
  EXPECT_EQ(one_line("  two  spaces "), "  two  spaces ");
  EXPECT_EQ(one_line(""), "");
}

TEST(OneLine, IsUtf8WhateverBytesItQuotes) {
  EXPECT_EQ(one_line("caf\xe9/s.yaml"), "caf\\xe9/s.yaml");
  EXPECT_EQ(one_line("\xe2\x82 \xe2\x82\xac"), "\\xe2\\x82 \xe2\x82\xac");
  for (int first = 1; first < 256; ++first) {
    for (int second = 1; second < 256; ++second) {
      const std::string text = {static_cast<char>(first), static_cast<char>(second)};
      EXPECT_TRUE(is_utf8(one_line(text))) << first << " " << second;
      EXPECT_TRUE(is_utf8(as_utf8(text))) << first << " " << second;
      if (is_utf8(text)) {
        EXPECT_EQ(as_utf8(text), text);
      }
    }
  }
}

TEST(OneLine, EscapesWhatSomeReaderTakesForTheEndOfALineAndWhatIsNotUtf8) {
  EXPECT_EQ(one_line("a\xC2\x85"
                     "b\xE2\x80\xA8"
                     "c\xE2\x80\xA9"
                     "d\xEF\xBB\xBF"
                     "e"),
            "a\\x85b\\u2028c\\u2029d\\ufeffe");
  EXPECT_EQ(one_line("caf\xE9 \xC2\x9B[31m \xF0\x9F\xA4\x96 \xF0\x9F\xBF\xBE"),
            "caf\\xe9 \\x9b[31m \xF0\x9F\xA4\x96 \\U0001fffe");
}

TEST(OneLine, CutsWordsThatAreLongerThanAnyPath) {
  const std::string path(4096, 'p');
  EXPECT_EQ(one_line(path + ": no such file"), path + ": no such file");
  // A two-byte character across the 60th byte is left out whole.
  const std::string name = std::string(59, 'n') + "é" + std::string(1'000'000, 'n');
  EXPECT_EQ(one_line("link '" + name + "' is bad"),
            "link '" + std::string(58, 'n') + "n... (1000063 bytes) is bad");
}

TEST(OneLine, IsWhatEveryInputErrorSays) {
  EXPECT_STREQ(InputError("arm\n.urdf: is empty").what(), "arm\\n.urdf: is empty");
}

TEST(Shown, QuotesAndCuts) {
  EXPECT_EQ(shown("a b"), "'a b'");
  EXPECT_EQ(shown(std::string(60, 'x')), "'" + std::string(60, 'x') + "'");
  EXPECT_EQ(shown(std::string(59, 'x') + "éé"), "'" + std::string(59, 'x') + "...'");
}

TEST(IsUtf8, FollowsTheTableOfUnicode) {
  for (const char* good : {"", "abc", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
                           "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF", "a\xE2\x82\xACz"}) {
    EXPECT_TRUE(is_utf8(good)) << testing::PrintToString(good);
  }
  for (const char* bad : {"\x80", "\xC1\x80", "\xC2", "\xC2\x7F", "\xC2\xC0", "\xE0\x9F\xBF", "\xE2\x82",
                          "\xE2\x82\x28", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF", "\xF0\x90\x80",
                          "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF", "ab\xE9"}) {
    EXPECT_FALSE(is_utf8(bad)) << testing::PrintToString(bad);
  }
}

}  // namespace message_text_test
}  // namespace armtune::internal
