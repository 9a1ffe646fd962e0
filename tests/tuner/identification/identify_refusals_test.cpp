// Identification refuses wrong logs and accepts right ones.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/tuner/identification/identify_rig.hpp"
#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/identification/theta_doubts.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace identify_refusals_test {

using test::differing_arm;
using test::Identify;
using test::kNever;
using test::refused_at;
using test::true_theta;

TEST_F(Identify, AVelocityThatIsNotThePositionsDerivativeIsRefused) {
  const Scenario scenario = differing_arm(37, 1.0);
  ExcitationLog wrong = simulate_excitation(scenario, exciting_, {}, kNever);
  for (LogSample& sample : wrong.samples) sample.qd[2] *= -1.0;
  const std::string path = folder_.write("log.csv", log_csv(arm_, wrong));
  EXPECT_THAT([&] { identified({path}); }, refused_at({.file = path,
                                                       .key = "elbow_joint/velocity",
                                                       .value = testing::StartsWith("-"),
                                                       .limit = "1 times the derivative of the position"}));
}

TEST_F(Identify, ARightLogInWhichAJointStandsStillIsNotDoubted) {
  const ParameterVector truth = true_theta(differing_arm(41, 1.0));
  for (int still = 0; still < arm_.n(); ++still) {
    std::vector<int> moving;
    for (int j = 0; j < arm_.n(); ++j) {
      if (j != still) moving.push_back(j);
    }
    for (const double noise : {1e-4, 1e-3}) {
      const std::string path =
          folder_.write("still.csv", log_csv(arm_, log_of_some_joints(moving, truth, noise)));
      const Identification found = identified({path});
      EXPECT_FALSE(found.comparison.mistake.has_value())
          << still << ", noise " << noise << ": " << to_text(*found.comparison.mistake, arm_);
      EXPECT_THAT(theta_doubts(arm_, found), testing::IsEmpty()) << still << ", noise " << noise;
    }
  }
}

TEST_F(Identify, WhatStillJointsDoNotExciteKeepsTheMassesOfTheRobotFile) {
  // The upper arm lies: its weight and the still shoulder say nothing of each other.
  exciting_.center.setZero();
  const ParameterVector file = theta_of(arm_.chain);
  const ParameterVector other = true_theta(differing_arm(41, 1.0));
  for (const std::vector<int>& moving :
       {std::vector{0, 2, 3, 4, 5}, {0, 2, 3, 4}, {0, 2, 3, 5}, {2, 3, 4, 5}, {0, 2, 4, 5}}) {
    for (const ParameterVector* truth : {&file, &other}) {
      const std::string path =
          folder_.write("still.csv", log_csv(arm_, log_of_some_joints(moving, *truth, 1e-4)));
      const Identification found = identified({path});
      EXPECT_FALSE(found.estimate.not_excited.empty());
      EXPECT_THAT(theta_doubts(arm_, found), testing::IsEmpty()) << fmt::format("{}", moving.size());
      for (int i = 0; i < arm_.n(); ++i) {
        const double lightest = std::min(file[i * kLinkParameters], (*truth)[i * kLinkParameters]);
        const double heaviest = std::max(file[i * kLinkParameters], (*truth)[i * kLinkParameters]);
        EXPECT_GT(found.theta[i * kLinkParameters], 0.6 * lightest) << i;
        EXPECT_LT(found.theta[i * kLinkParameters], 1.3 * heaviest) << i;
      }
    }
  }
}

TEST_F(Identify, ALogWithoutMotionIsRefused) {
  const ParameterVector truth = true_theta(differing_arm(42, 1.0));
  for (const double noise : {0.0, 1e-4}) {
    ExcitationLog still = log_of_some_joints({}, truth, noise);
    const std::string path = folder_.write("still.csv", log_csv(arm_, still));
    EXPECT_THAT([&] { identified({path}); }, refused_at({.file = path, .limit = "above 0.01 rad or m"}))
        << noise;
  }
}

TEST_F(Identify, TheHashIsThatOfTheLogAsItWasRead) {
  const std::string path = log(nominal_, 0.0);
  const Identification found = identified({path});
  ASSERT_EQ(found.log_hashes.size(), 1U);
  EXPECT_EQ(found.log_hashes[0], hash_of_file(path));
}

TEST_F(Identify, ALogThatChangesBetweenTwoPassesIsRefused) {
  const std::string path = log(nominal_, 0.0);
  const std::string text = test::read_text(path);
  IdentifyOptions robust;
  robust.robust = true;
  robust.progress = [&](int pass, std::size_t, long) {
    if (pass == 1) folder_.write("log.csv", text.substr(0, text.size() - text.size() / 4));
  };
  EXPECT_THAT([&] { identified({path}, robust); }, refused_at({.file = path}));
}

TEST_F(Identify, ATorqueThatIsAlwaysZeroIsRefusedWithItsJoint) {
  ExcitationLog silent = simulate_excitation(nominal_, exciting_, {}, kNever);
  for (LogSample& sample : silent.samples) sample.torque[4] = 0.0;
  const std::string path = folder_.write("log.csv", log_csv(arm_, silent));
  EXPECT_THAT([&] { identified({path}); },
              refused_at({.file = path, .key = arm_.joints[4].name + "/torque", .value = "0"}));
}

TEST_F(Identify, ATorqueThatNeverChangesIsRefusedIfItsJointMoves) {
  ExcitationLog frozen = simulate_excitation(nominal_, exciting_, {}, kNever);
  for (LogSample& sample : frozen.samples) sample.torque[1] = -107.4;
  const std::string path = folder_.write("log.csv", log_csv(arm_, frozen));
  EXPECT_THAT([&] { identified({path}); }, refused_at({.file = path,
                                                       .key = "shoulder_lift_joint/torque",
                                                       .value = "-107.4",
                                                       .limit = "a torque that changes with the motion"}));
}

TEST_F(Identify, OtherUnitsAreRefusedWithTheScaleThatBringsThemBack) {
  const ExcitationLog right = simulate_excitation(nominal_, exciting_, {}, kNever);
  const auto refused = [&](const std::function<void(LogSample&)>& change) {
    ExcitationLog wrong = right;
    for (LogSample& sample : wrong.samples) change(sample);
    const std::string path = folder_.write("log.csv", log_csv(arm_, wrong));
    return test::input_error([&] { identified({path}); });
  };
  const InputError degrees = refused([](LogSample& at) {
    at.q *= 180.0 / M_PI;
    at.qd *= 180.0 / M_PI;
  });
  EXPECT_THAT(degrees,
              refused_at({.key = testing::EndsWith("/position"), .limit = testing::EndsWith(" rad")}));
  EXPECT_THAT(degrees.what(), testing::AllOf(testing::HasSubstr("degrees"), testing::HasSubstr("0.0174")));
  const InputError torques = refused([](LogSample& at) { at.torque *= 1000.0; });
  EXPECT_THAT(torques, refused_at({.key = testing::EndsWith("/torque"), .limit = testing::EndsWith(" N m")}));
  EXPECT_THAT(torques.what(), testing::AllOf(testing::HasSubstr("N mm"), testing::HasSubstr("scale: 0.001")));
  const InputError times = refused([](LogSample& at) {
    at.time *= 1000.0;
    at.qd *= 1e-3;
  });
  EXPECT_THAT(times, refused_at({.file = folder_ / "log.csv",
                                 .value = fmt::format("{}", IdentifyOptions{}.rows.cutoff),
                                 .limit = testing::StartsWith("a cutoff of at most ")}));
  EXPECT_THAT(times.what(), testing::HasSubstr("time_scale: 0.001"));
}

TEST_F(Identify, ALogThatIsTooShortOrTooCoarseIsRefused) {
  Scenario scenario = differing_arm(36, 0.0);
  ExcitationLog cut = simulate_excitation(scenario, exciting_, {}, kNever);
  cut.samples.resize(700);
  const std::string path = folder_.write("log.csv", log_csv(arm_, cut));
  EXPECT_THAT([&] { identified({path}); },
              refused_at({.file = path, .value = "700", .limit = "enough samples for the filters"}));
  IdentifyOptions high;
  high.rows.cutoff = 100.0;
  EXPECT_THAT(
      [&] { identified({path}, high); },
      refused_at({.file = path, .value = "100", .limit = testing::StartsWith("a cutoff of at most ")}));
}

}  // namespace identify_refusals_test
}  // namespace armtune::internal
