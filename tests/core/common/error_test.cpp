// An InputError says where the error is: in its message for people, and as fields for programs.

#include "armtune/error.hpp"

#include <gtest/gtest.h>

#include "core/common/input_file.hpp"
#include "core/common/input_place.hpp"

namespace armtune::internal {
namespace error_test {

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

TEST(InputErrors, MakeTheirMessageFromTheFieldsOfAFault) {
  const InputError error(at_line("a.yaml", 7, "mass"), InputFault{"9 is out of range", "9", "0 to 5.5"});
  EXPECT_STREQ(error.what(), "a.yaml:7: 9 is out of range; expected 0 to 5.5");
  EXPECT_EQ(error.place().key, "mass");
  EXPECT_EQ(error.value(), "9");
  EXPECT_EQ(error.limit(), "0 to 5.5");
  const InputError unlimited(InputPlace{"a.yaml"}, InputFault{"9 is too much", "9"});
  EXPECT_STREQ(unlimited.what(), "a.yaml: 9 is too much");
}

TEST(InputErrors, KeepTheirMessageAndPlaceWithAValueAndALimit) {
  const InputError error(at_line("a.yaml", 7, "mass"), "9 kg are too heavy");
  EXPECT_EQ(error.value() + error.limit(), "");
  const InputError full = error.with_value("9", "at most 5");
  EXPECT_STREQ(full.what(), error.what());
  EXPECT_EQ(full.place().line, 7);
  for (const InputError& same : {full, full.with("; see the copy")}) {
    EXPECT_EQ(same.value(), "9");
    EXPECT_EQ(same.limit(), "at most 5");
  }
}

TEST(InputErrors, BeginWithTheArgumentIfThereIsNoFile) {
  const InputError error(InputPlace{.key = "workers"}, "0; it must be at least 1");
  EXPECT_STREQ(error.what(), "workers: 0; it must be at least 1");
  EXPECT_EQ(error.place().key, "workers");
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

}  // namespace error_test
}  // namespace armtune::internal
