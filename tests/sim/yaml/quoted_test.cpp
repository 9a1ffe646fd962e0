#include "sim/yaml/quoted.hpp"

#include <gtest/gtest.h>

#include "sim/yaml/document.hpp"

namespace armtune::yaml {
namespace {

TEST(Quoted, AnyTextReadsBackAsItself) {
  for (const std::string text :
       {"", "plain", "1.0", "true", "it's", "say \"no\"", "back\\slash\\n", "two\nlines\n", "a\ttab",
        " spaces ", "a: b", "# none", "- item", "[1, 2]", "{a: b}", "100 %", "é"}) {
    EXPECT_EQ(parse_text("key: " + quoted(text) + "\n", "text").find("key")->as_string(), text);
    EXPECT_EQ(quoted(text).find('\n'), std::string::npos) << "one line";
  }
}

TEST(Quoted, BytesThatAreNotUtf8CanStillBeRead) {
  EXPECT_EQ(parse_text("key: " + quoted("caf\xe9/\xff") + "\n", "text").find("key")->as_string(), "café/ÿ");
}

}  // namespace
}  // namespace armtune::yaml
