#include "sim/yaml/quoted.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/common/utf8.hpp"
#include "sim/yaml/document.hpp"
#include "tests/sim/support/hostile_texts.hpp"

namespace armtune::internal::yaml {
namespace quoted_test {

/// True for a text of printable lines: no reader ends one of them anywhere else.
bool has_printable_lines(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return is_printable(text);
}

TEST(Quoted, AnyTextReadsBackAsItself) {
  for (const std::string& text : internal::test::hostile_texts()) {
    EXPECT_EQ(parse_text("key: " + quoted(text) + "\n", "text").find("key")->as_string(), text);
    EXPECT_EQ(parse_text("key: " + word(text) + "\n", "text").find("key")->as_string(), text);
    EXPECT_EQ(parse_text("[" + word(text) + ", " + word(text) + "]\n", "text").as_strings(),
              std::vector<std::string>(2, text));
    EXPECT_TRUE(is_printable(quoted(text))) << "one line, which everybody takes for one";
  }
}

TEST(Quoted, AWordThatCanBeTakenForNothingElseStaysAsItIs) {
  for (const std::string text : {"a", "task_space_gains_p/rx", "_2", "ur10.v2", "a-b", "nothing"})
    EXPECT_EQ(word(text), text);
}

TEST(Quoted, ABytesThatIsNotUtf8BecomesTheCharacterOfItsNumber) {
  EXPECT_EQ(parse_text("key: " + quoted("caf\xE9") + "\n", "text").find("key")->as_string(), "café");
}

TEST(Entry, AnyKeyReadsBackAsItself) {
  std::string text;
  std::vector<std::string> keys = internal::test::hostile_texts();
  for (std::size_t i = 0; i < keys.size(); ++i) text += entry("  ", keys[i], fmt::format("{}", i));
  EXPECT_TRUE(has_printable_lines(text));
  const Node root = parse_text("map:\n" + text, "text");
  const auto& entries = root.find("map")->entries();
  ASSERT_EQ(entries.size(), keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    EXPECT_EQ(entries[i].first, keys[i]);
    EXPECT_EQ(entries[i].second.as_integer(), static_cast<long>(i));
  }
}

TEST(Comment, IsOneLineForEveryReader) {
  for (const std::string& text : internal::test::hostile_texts()) {
    const std::string line = comment(text);
    EXPECT_EQ(line.find('\n'), line.size() - 1);
    EXPECT_TRUE(has_printable_lines(line)) << testing::PrintToString(text);
    EXPECT_EQ(parse_text(line + "a: 1\n", "text").entries().size(), 1U);
  }
}

TEST(Quoted, BytesThatAreNotUtf8CanStillBeRead) {
  EXPECT_EQ(parse_text("key: " + quoted("caf\xe9/\xff") + "\n", "text").find("key")->as_string(), "café/ÿ");
}

}  // namespace quoted_test
}  // namespace armtune::internal::yaml
