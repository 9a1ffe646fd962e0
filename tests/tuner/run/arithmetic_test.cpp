#include "tuner/run/arithmetic.hpp"

#include <gtest/gtest.h>

namespace armtune::internal {
namespace arithmetic_test {

TEST(BaselineTunables, KeepWhatTheUserHasSet) {
  const std::string wanted = baseline_tunables("");
  ASSERT_TRUE(wanted.starts_with("glibc.cpu.hwcaps=-"));
  const std::string list = wanted.substr(wanted.find('=') + 1);
  EXPECT_EQ(baseline_tunables("glibc.malloc.check=3"), "glibc.malloc.check=3:" + wanted);
  EXPECT_EQ(baseline_tunables("glibc.cpu.hwcaps=-ERMS"), "glibc.cpu.hwcaps=-ERMS," + list);
  EXPECT_EQ(baseline_tunables("glibc.malloc.check=3:glibc.cpu.hwcaps=-ERMS:glibc.malloc.perturb=1"),
            "glibc.malloc.check=3:glibc.cpu.hwcaps=-ERMS," + list + ":glibc.malloc.perturb=1");
}

}  // namespace arithmetic_test
}  // namespace armtune::internal
