#include "tuner/ranks/call_watch.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace armtune::internal {
namespace call_watch_test {

TEST(CallWatch, SaysOnceAndGivesUpOnce) {
  std::atomic<int> said{0};
  std::atomic<int> given_up{0};
  {
    const CallWatch watch(
        0.02, [&said] { ++said; }, 0.2, [&given_up] { ++given_up; });
    while (given_up == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    EXPECT_EQ(said, 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(said, 1);
  EXPECT_EQ(given_up, 1);
}

TEST(CallWatch, IsSilentWhenTheCallReturnsInTime) {
  std::atomic<int> calls{0};
  const auto began = std::chrono::steady_clock::now();
  {
    const CallWatch watch(
        30.0, [&calls] { ++calls; }, 60.0, [&calls] { ++calls; });
  }
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(10)) << "it does not wait";
  EXPECT_EQ(calls, 0);
}

}  // namespace call_watch_test
}  // namespace armtune::internal
