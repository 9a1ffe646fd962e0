#include "tuner/rollouts/recording_memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <fstream>

#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/rollouts/simulate.hpp"

namespace armtune::internal {
namespace recording_memory_test {

using test::refused_at;
using testing::AllOf;
using testing::HasSubstr;

constexpr double kGigabyte = 1e9;

std::vector<Scenario> two_of(double shorter, double longer) {
  std::vector<Scenario> scenarios = {test::scenario_of("moving_target", shorter),
                                     test::scenario_of("moving_target", longer)};
  scenarios[1].name = "longer";
  return scenarios;
}

TEST(RecordingMemory, IsThatOfTheRecordersOwnNumbers) {
  const Scenario scenario = test::scenario_of("moving_target", 1.0);
  for (const int stride : {1, 5, 7}) {
    Recorder recorder(scenario, stride);
    Rollout(scenario, Stepper::kMidpoint).run(test::published_gains(scenario), std::ref(recorder));
    const double bytes = static_cast<double>(recorder.rows().size() * sizeof(double));
    const double row = static_cast<double>(recorder.columns().size() * sizeof(double));
    const double said = recording_bytes(scenario, stride, RecordingUse::kKept);
    EXPECT_GE(said, bytes);
    EXPECT_LE(said, bytes + 3.0 * row) << "a first and a last row at most, and rounding";
    EXPECT_GT(recording_bytes(scenario, stride, RecordingUse::kWritten), said);
  }
}

TEST(RecordingMemory, CountsWhatIsInMemoryAtTheSameTime) {
  const std::vector<Scenario> scenarios = two_of(10.0, 20.0);
  const double shorter = recording_bytes(scenarios[0], 5, RecordingUse::kWritten);
  const double longer = recording_bytes(scenarios[1], 5, RecordingUse::kWritten);
  const auto fits = [&](int workers, double usable) {
    return test::refusal([&] {
             require_recording_memory(scenarios, 5, workers, RecordingUse::kWritten, usable);
           }) == "nothing was refused";
  };
  EXPECT_TRUE(fits(1, longer));
  EXPECT_FALSE(fits(1, longer - 1.0));
  EXPECT_FALSE(fits(2, longer + shorter - 1.0));
  EXPECT_TRUE(fits(2, longer + shorter));
  EXPECT_TRUE(fits(64, longer + shorter));
}

TEST(RecordingMemory, IsRefusedWithTheScenarioItsSizeAndAStrideThatFits) {
  const std::vector<Scenario> scenarios = two_of(10.0, 2e5);
  const double usable = 0.1 * kGigabyte;
  const InputError error =
      test::input_error([&] { require_recording_memory(scenarios, 5, 1, RecordingUse::kWritten, usable); });
  EXPECT_THAT(error, refused_at({.file = scenarios[1].source,
                                 .key = "duration",
                                 .value = testing::EndsWith(" GB"),
                                 .limit = "at most 0.1 GB"}));
  EXPECT_GT(std::stod(error.value()), 0.1);
  const std::string message = error.what();
  EXPECT_THAT(message, AllOf(HasSubstr("recording of longer"), HasSubstr("--record-every")));
  const std::string before = " only one in ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  const int stride = std::stoi(message.substr(at + before.size()));
  EXPECT_NO_THROW(require_recording_memory(scenarios, stride, 1, RecordingUse::kWritten, usable)) << stride;
}

TEST(RecordingMemory, IsAskedForBeforeAnythingIsSimulated) {
  std::vector<Scenario> scenarios = two_of(1.0, 2e5);
  scenarios[1].control_period = 1e-5;  // 2e10 periods are beyond any machine
  SimulateOptions options;
  options.record_stride = 1;
  options.recorded = [](std::size_t, const Recorder&, bool) { FAIL() << "something was recorded"; };
  const std::atomic<bool> never{false};
  const InputError error = test::input_error([&] {
    simulate(
        scenarios, [](const Scenario& s) { return test::published_gains(s); }, options, never);
  });
  EXPECT_THAT(error, refused_at({.file = scenarios[1].source, .key = "duration"}));
  EXPECT_THAT(error.what(), HasSubstr("recording of longer"));
}

TEST(RecordingMemory, OfALimitOfTheShellWhatIsInUseAlreadyDoesNotCount) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
  double pages = 0.0;
  ASSERT_TRUE(std::ifstream("/proc/self/statm") >> pages);
  const double used = pages * static_cast<double>(sysconf(_SC_PAGESIZE));
  rlimit lower = before;
  lower.rlim_cur = static_cast<rlim_t>(used + kGigabyte);
  if (lower.rlim_cur > before.rlim_max) GTEST_SKIP() << "a lower limit is set already";
  ASSERT_EQ(setrlimit(RLIMIT_AS, &lower), 0);
  const double usable = usable_memory();
  setrlimit(RLIMIT_AS, &before);
  EXPECT_LT(usable, 0.95 * kGigabyte);
  EXPECT_GT(usable, 0.85 * kGigabyte);
}

}  // namespace recording_memory_test
}  // namespace armtune::internal
