#include "tuner/record/json_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/tuner/run/support/records.hpp"
#include "tuner/record/json_writer.hpp"

namespace armtune::internal::record {
namespace json_lines_test {

TEST(JsonLines, BreakObjectsAndListsDownToTheirDepth) {
  const std::string json = R"({"a":1,"b":{"c":[1,2],"d":"x"},"e":[],"f":{}})";
  EXPECT_EQ(in_lines(json, 0), R"({"a": 1, "b": {"c": [1, 2], "d": "x"}, "e": [], "f": {}})");
  EXPECT_EQ(in_lines(json, 1), R"({
  "a": 1,
  "b": {"c": [1, 2], "d": "x"},
  "e": [],
  "f": {}
})");
  EXPECT_EQ(in_lines(json, 2), R"({
  "a": 1,
  "b": {
    "c": [1, 2],
    "d": "x"
  },
  "e": [],
  "f": {}
})");
}

TEST(JsonLines, LeaveTextsAsTheyAre) {
  const std::string json = R"(["{\"a\":[1,2]}","5\",[1:2]","\\","a:b, c]"])";
  EXPECT_EQ(in_lines(json, 0), R"(["{\"a\":[1,2]}", "5\",[1:2]", "\\", "a:b, c]"])");
}

TEST(JsonLines, AddNothingButSpaceBetweenTokens) {
  const std::string json = json_of(test::whole_record());
  for (int depth = 0; depth < 6; ++depth) {
    const std::string lines = in_lines(json, depth);
    RunRecord read = parse_run_record(lines, "run.json");
    EXPECT_EQ(read, test::whole_record()) << depth;
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n') == 0, depth == 0);
  }
}

}  // namespace json_lines_test
}  // namespace armtune::internal::record
