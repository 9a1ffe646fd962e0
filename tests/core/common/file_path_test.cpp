#include "core/common/file_path.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace file_path_test {

namespace fs = std::filesystem;

TEST(WithoutDots, NamesTheSameFile) {
  const test::TemporaryFolder folder;
  fs::create_directories(folder / "real/below/deep");
  fs::create_directories(folder / "beside");
  fs::create_directory_symlink(folder / "real/below", folder / "link");
  for (const std::string at : {"", "real/", "real/below/", "beside/"}) folder.write(at + "file", at);
  for (const std::string path :
       {"file", "./file", "real/../file", "real//below/../file", "link/../file", "link/deep/../file",
        "link/deep/../../file", "beside/../link/../below/./file", "real/below/deep/../../../file"}) {
    const std::string before = folder / path;
    const std::string after = without_dots(before);
    EXPECT_TRUE(fs::equivalent(before, after)) << before << " became " << after;
    EXPECT_EQ(without_dots(after), after);
  }
  EXPECT_EQ(without_dots(folder / "real/../file"), folder / "file");
}

TEST(WithoutDots, KeepsWhatItCannotKnow) {
  EXPECT_EQ(without_dots("missing/../file"), "missing/../file") << "there is no such file, nor is this one";
  EXPECT_EQ(without_dots("../../file"), "../../file");
  EXPECT_EQ(without_dots("/../file"), "/file");
  EXPECT_EQ(without_dots(""), ".");
  EXPECT_EQ(without_dots("./"), ".");
}

TEST(AbsolutePath, BeginsAtTheRoot) {
  EXPECT_EQ(absolute_path("x/y"), (fs::current_path() / "x/y").string());
  EXPECT_EQ(absolute_path("/x/./y"), "/x/y");
}

}  // namespace file_path_test
}  // namespace armtune::internal
