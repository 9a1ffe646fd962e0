#include "core/control/laws/ros_pid.hpp"
#include "tests/core/support/source_dir.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace armtune::internal {
namespace ros_pid_test {

const std::map<std::string, AntiWindup> kAntiWindup = {{"contribution", AntiWindup::kOfContribution},
                                                       {"integral", AntiWindup::kOfIntegral},
                                                       {"none", AntiWindup::kNone},
                                                       {"conditional", AntiWindup::kConditional},
                                                       {"back_calculation", AntiWindup::kBackCalculation}};

/// "inf" and "-inf" too.
double number(std::istringstream& words) {
  std::string word;
  words >> word;
  return std::stod(word);
}

RosPidGains gains_of(std::istringstream& words) {
  RosPidGains gains;
  std::string anti_windup;
  words >> anti_windup;
  gains.anti_windup = kAntiWindup.at(anti_windup);
  for (double* to : {&gains.p, &gains.i, &gains.d, &gains.i_max, &gains.i_min, &gains.u_max, &gains.u_min,
                     &gains.tracking_time, &gains.deadband})
    *to = number(words);
  return gains;
}

TEST(RosPid, GivesTheOutputsThatFollowFromTheSourceOfControlToolbox) {
  std::ifstream file(test::source_dir() + "/tests/core/control/laws/data/ros_pid.txt");
  ASSERT_TRUE(file);
  RosPid pid;
  RosPidGains gains;
  std::string name, line;
  int cases = 0, periods = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    if (line.starts_with("case ")) {
      std::string word, version;
      words >> word >> name >> version;
      gains = gains_of(words);
      pid.start(0, gains);
      ++cases;
      continue;
    }
    const double error = number(words), rate = number(words), dt = number(words), output = number(words);
    EXPECT_NEAR(pid.output(error, rate, dt), output, 1e-12 * (1.0 + std::abs(output)))
        << name << ", " << gains.i_max << ", error " << error;
    ++periods;
  }
  EXPECT_GE(cases, 25);
  EXPECT_GE(periods, 150);
}

// An error of a second's length and its opposite: what each kind gives back, and when.
TEST(RosPid, ReleasesWhatWoundUpAsItsKindSays) {
  const auto last_after = [](AntiWindup kind, int back) {
    RosPidGains gains;
    gains.i = 10.0;
    gains.i_max = 1.0;
    gains.i_min = -1.0;
    gains.anti_windup = kind;
    RosPid pid;
    pid.start(0, gains);
    double output = 0.0;
    for (int k = 0; k < 100; ++k) output = pid.output(1.0, 0.0, 0.01);
    EXPECT_DOUBLE_EQ(output, 1.0);
    for (int k = 0; k < back; ++k) output = pid.output(-1.0, 0.0, 0.01);
    return output;
  };
  // The integral of 10 takes 0.9 s to come to the clamp.
  EXPECT_DOUBLE_EQ(last_after(AntiWindup::kOfContribution, 89), 1.0);
  EXPECT_NEAR(last_after(AntiWindup::kOfContribution, 100), 0.0, 1e-12);
  EXPECT_NEAR(last_after(AntiWindup::kOfIntegral, 10), 0.0, 1e-12);
  // Used as it was before the period.
  EXPECT_NEAR(last_after(AntiWindup::kNone, 11), 0.0, 1e-12);
}

}  // namespace ros_pid_test
}  // namespace armtune::internal
