#include "core/common/file_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace file_name_test {

using test::refusal;
using test::refused_at;
using testing::HasSubstr;

TEST(FileName, TheLongestThatIsAcceptedLeavesRoomForWhatIsPutAroundIt) {
  const std::string longest(kLongestName, 'n');
  EXPECT_NO_THROW(check_file_name(longest, "p"));
  EXPECT_THAT([&] { check_file_name(longest + "n", "p.yaml"); },
              refused_at({.file = "p.yaml", .value = "201", .limit = "at most 200 bytes"}));
  const test::TemporaryFolder folder;
  for (const std::string& name : {"rollout_" + longest + ".csv.partial", "errors_" + longest + ".csv.partial",
                                  "pareto_" + longest + "_20261126-111927"}) {
    folder.write(name, "text");
    EXPECT_EQ(test::read_text(folder / name), "text");
  }
}

TEST(FileName, WhatATerminalOrAReaderTakesForMoreIsRefused) {
  for (const std::string name : {"a\x1b[31m", "a\x7f", "a\rb", "a\nb", "a\tb", "a\xC2\x85", "a\xC2\x9B",
                                 "a\xE2\x80\xA8", "a\xE2\x80\xA9",
                                 "\xEF\xBB\xBF"
                                 "a",
                                 "caf\xE9"}) {
    const std::string told = refusal([&] { check_file_name(name, name + ".yaml"); });
    EXPECT_THAT(told, HasSubstr("rename"));
    EXPECT_EQ(told.find_first_of("\x1b\x7f\r\t"), std::string::npos);
  }
  for (const std::string name : {"a: b", "a #b", "é", "it's $HOME; <b>"})
    EXPECT_NO_THROW(check_file_name(name, "p"));
}

TEST(ResultName, WhatBreaksACsvFileIsRefused) {
  for (const std::string name : {"a,b", "a\"b", "=a", "-a", "+a", "@a"})
    EXPECT_THAT(refusal([&] { check_result_name(name, "p.yaml"); }), HasSubstr("CSV"));
}

}  // namespace file_name_test
}  // namespace armtune::internal
