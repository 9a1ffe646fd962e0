#include "sim/scenario/data_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace data_files_test {

using test::refused_at;
using testing::HasSubstr;

TEST(DataFiles, BundledFilesAreFoundByName) {
  for (const char* folder : {"robots", "scenarios", "gains", "studies"}) {
    const auto names = bundled_names(folder);
    EXPECT_FALSE(names.empty()) << folder;
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string& name : names) {
      const std::string path = find_data_file(folder, name);
      EXPECT_EQ(stem(path), name);
      EXPECT_TRUE(std::filesystem::exists(path)) << path;
    }
  }
  EXPECT_THAT(bundled_names("scenarios"),
              testing::IsSupersetOf({"fixed_target", "moving_target", "target_switch", "obstacle_pass",
                                     "realistic_fixed_target", "realistic_moving_target",
                                     "realistic_target_switch", "realistic_obstacle_pass"}));
}

TEST(DataFiles, OwnFilesAreFoundByPathAndBesideTheFileThatNamesThem) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("own.yaml", "a: 1\n");
  EXPECT_EQ(find_data_file("scenarios", path), path);
  EXPECT_EQ(find_data_file("scenarios", "own.yaml", folder.path()), path);
  // A name without extension is never taken from the folder: what is bundled stays what it is.
  folder.write("moving_target", "not this one");
  EXPECT_NE(find_data_file("scenarios", "moving_target", folder.path()), folder / "moving_target");
}

TEST(DataFiles, AnUnknownNameIsRefusedWithTheNearestAndTheList) {
  const InputError unknown = test::input_error([] { find_data_file("scenarios", "moving_tagret"); });
  EXPECT_THAT(unknown, refused_at({.value = "moving_tagret", .limit = HasSubstr("obstacle_pass")}));
  EXPECT_THAT(unknown.what(), testing::AllOf(HasSubstr("did you mean 'moving_target'"), HasSubstr(".yaml")));
  EXPECT_THAT([] { find_data_file("scenarios", "somewhere/none.yaml"); },
              refused_at({.file = "somewhere/none.yaml", .line = 0}));
}

TEST(DataFiles, PathsComeApart) {
  EXPECT_EQ(stem("/a/b/moving.yaml"), "moving");
  EXPECT_EQ(folder_of("/a/b/moving.yaml"), "/a/b");
  EXPECT_EQ(folder_of("moving.yaml"), ".");
}

}  // namespace data_files_test
}  // namespace armtune::internal
