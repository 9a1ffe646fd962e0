#include "sim/csv/partial_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/csv/text_file.hpp"
#include "tests/core/support/refused_at.hpp"
#include "tests/sim/support/files.hpp"

namespace armtune::internal {
namespace partial_file_test {

namespace fs = std::filesystem;

TEST(PartialFile, AppearsWholeAndOnlyAtTheEnd) {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.bin", "old");
  PartialFile file(path);
  file.write(std::string_view("a\0b", 3));
  EXPECT_EQ(test::read_text(path), "old");
  file.write("c");
  file.replace();
  EXPECT_EQ(test::read_text(path), std::string("a\0bc", 4));
  EXPECT_FALSE(fs::exists(partial_path(path)));
}

TEST(PartialFile, IsGoneIfItIsNotPutInItsPlace) {
  const test::TemporaryFolder folder;
  { PartialFile(folder / "a.bin").write("text"); }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(PartialFile, PlaceNewDoesNotReplace) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.bin";
  {
    PartialFile file(path);
    file.write("new");
    folder.write("a.bin", "appeared meanwhile");
    EXPECT_THAT([&] { file.place_new(); }, test::refused_at({.file = path}));
  }
  EXPECT_EQ(test::read_text(path), "appeared meanwhile");
  EXPECT_FALSE(fs::exists(partial_path(path)));
}

}  // namespace partial_file_test
}  // namespace armtune::internal
