#include "core/common/path_state.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "tests/core/support/refused_at.hpp"

namespace armtune::internal {
namespace path_state_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

template <typename Action>
std::string refusal(Action&& action) {
  return test::input_error(action).what();
}

class PathState : public testing::Test {
 protected:
  PathState() { fs::create_directories(folder_); }
  ~PathState() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  const fs::path folder_ = testing::TempDir() + "armtune_path_" + std::to_string(getpid());
};

TEST_F(PathState, SaysWhatIsThereAndWhatIsNot) {
  const std::string file = folder_ / "file";
  EXPECT_FALSE(is_there(file));
  EXPECT_NO_THROW(refuse_existing(file));
  std::ofstream(file) << "text";
  EXPECT_TRUE(is_there(file));
  EXPECT_THAT([&] { refuse_existing(file); }, test::refused_at({.file = file}));
  EXPECT_FALSE(is_there(file + "/below"));
  EXPECT_TRUE(is_there(folder_));
}

TEST_F(PathState, AFolderIsEmptyOnlyIfItCanBeRead) {
  const std::string inner = folder_ / "inner";
  EXPECT_TRUE(is_missing_or_empty(inner));
  fs::create_directories(inner);
  EXPECT_TRUE(is_missing_or_empty(inner));
  fs::create_directories(inner + "/a/b");
  fs::create_directories(inner + "/c");
  EXPECT_TRUE(is_missing_or_empty(inner)) << "a run for which there was no room leaves empty folders";
  fs::create_symlink(folder_, inner + "/a/b/link");
  EXPECT_FALSE(is_missing_or_empty(inner));
  fs::remove(inner + "/a/b/link");
  std::ofstream(inner + "/a/b/file") << "text";
  EXPECT_FALSE(is_missing_or_empty(inner));
  std::ofstream(inner + "/file") << "text";
  EXPECT_FALSE(is_missing_or_empty(inner));
  EXPECT_THAT([&] { is_missing_or_empty(inner + "/file"); }, test::refused_at({.file = inner + "/file"}));
}

TEST_F(PathState, WhatCannotBeToldIsAnErrorWithItsReason) {
  const std::string loop = folder_ / "loop";
  fs::create_symlink(loop, loop);
  const std::string name = folder_ / std::string(300, 'n');
  for (const auto& [path, reason] : {std::pair(loop, "symbolic links"), std::pair(name, "too long")}) {
    EXPECT_THAT(refusal([&, p = path] { is_there(p); }),
                AllOf(HasSubstr(reason), HasSubstr("cannot be accessed")));
    EXPECT_THAT(refusal([&, p = path] { refuse_existing(p + "/below"); }), HasSubstr(reason));
    EXPECT_THAT(refusal([&, p = path] { is_missing_or_empty(p); }), HasSubstr(reason));
  }
}

TEST_F(PathState, ALinkIsInTheWayWhereverItLeads) {
  const std::string link = folder_ / "link";
  fs::create_symlink(folder_ / "nowhere", link);
  EXPECT_FALSE(is_there(link));
  EXPECT_THAT([&] { refuse_existing(link); }, test::refused_at({.file = link}));
}

TEST_F(PathState, ARelativePathNeedsTheCurrentFolder) {
  const fs::path before = fs::current_path();
  EXPECT_EQ(absolute_path("/a/./c"), "/a/c");
  fs::current_path(folder_);
  EXPECT_EQ(absolute_path("file"), (fs::current_path() / "file").string());
  fs::remove_all(folder_);
  EXPECT_THAT(refusal([] { absolute_path("file"); }), HasSubstr("current folder"));
  EXPECT_EQ(absolute_path("/a/c"), "/a/c") << "needs no current folder";
  fs::current_path(before);
}

}  // namespace path_state_test
}  // namespace armtune::internal
