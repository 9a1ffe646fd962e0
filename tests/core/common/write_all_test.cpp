#include "core/common/write_all.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string>
#include <thread>

namespace armtune::internal {
namespace write_all_test {

TEST(WriteAll, WaitsForAPipeThatIsFull) {
  int ends[2];
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  const std::string text(1 << 20, 'x');
  std::string read;
  std::thread reader([&] {
    char part[5000];
    while (read.size() < text.size()) {
      const ssize_t size = ::read(ends[0], part, sizeof part);
      if (size > 0) read.append(part, static_cast<std::size_t>(size));
    }
  });
  EXPECT_TRUE(write_all(ends[1], text));
  reader.join();
  EXPECT_EQ(read, text);
  ::close(ends[0]);
  ::close(ends[1]);
}

TEST(WriteAll, SaysWhyADescriptorTakesNoMore) {
  const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
  ASSERT_GE(full, 0);
  EXPECT_TRUE(write_all(full, ""));
  EXPECT_FALSE(write_all(full, "x"));
  EXPECT_EQ(errno, ENOSPC);
  ::close(full);
}

// The memory of a process that has ended accepts no byte, and reports no error either.
TEST(WriteAll, EndsWhereNothingIsAccepted) {
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::pause();
    ::_exit(0);
  }
  const int memory = ::open(fmt::format("/proc/{}/mem", child).c_str(), O_WRONLY | O_CLOEXEC);
  ::kill(child, SIGKILL);
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);
  if (memory < 0) GTEST_SKIP() << "the memory of other processes may not be opened";
  EXPECT_FALSE(write_all(memory, "x"));
  EXPECT_EQ(errno, EIO);
  ::close(memory);
}

}  // namespace write_all_test
}  // namespace armtune::internal
