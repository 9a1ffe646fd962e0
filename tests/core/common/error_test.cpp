// An InputError says where the error is: in its message for people, and as fields for programs.

#include "armtune/error.hpp"

#include <gtest/gtest.h>

#include "core/common/input_file.hpp"
#include "core/common/input_place.hpp"

namespace armtune::internal {
namespace {

TEST(InputErrors, BeginWithWhatIsKnownOfTheirPlace) {
  EXPECT_STREQ(InputError("no arm").what(), "no arm");
  EXPECT_STREQ(InputError(InputPlace{"a.csv"}, "empty").what(), "a.csv: empty");
  EXPECT_STREQ(InputError(at_line("a.csv", 7, "time"), "not a number").what(), "a.csv:7: not a number");
}

TEST(InputErrors, KeepTheirPlaceInCopiesAndWithMoreText) {
  const InputError error(at_line("a.yaml", 7u, "targets/1"), "not a list");
  for (const InputError& same : {error, error.with(""), InputError(InputError(error))}) {
    EXPECT_EQ(same.place().file, "a.yaml");
    EXPECT_EQ(same.place().line, 7);
    EXPECT_EQ(same.place().key, "targets/1");
  }
  EXPECT_STREQ(error.with("; see the copy").what(), "a.yaml:7: not a list; see the copy");
}

TEST(InputErrors, HaveNoPlaceIfNoFileIsTheCause) {
  const InputPlace place = InputError("--workers: 0 is given").place();
  EXPECT_EQ(place.file + place.key, "");
  EXPECT_EQ(place.line, 0);
}

TEST(InputErrors, NameAFileThatCannotBeRead) {
  try {
    read_file("nowhere/a.yaml", 1000, "a YAML file");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.place().file, "nowhere/a.yaml");
    EXPECT_EQ(error.place().line, 0);
  }
}

}  // namespace
}  // namespace armtune::internal
