// Gains beyond use under the reference stepper, whose error control could be busy with them for ever: the
// rollout ends, with a status that says when, where and why.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <functional>
#include <ostream>

#include "sim/rollout/rollout.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace reference_extremes_test {

struct Beyond {
  const char* name;
  const char* scenario;
  std::function<void(Gains&)> change;
  bool diverges;  ///< for sure: a torque is no number
};

std::ostream& operator<<(std::ostream& out, const Beyond& beyond) {
  return out << beyond.name;
}

/// In a second of a scenario the Cartesian law comes to act only if leaving the start pose takes less.
void leave_soon(Gains& gains) {
  gains.joint_trajectory_duration = 0.25;
}

const std::vector<Beyond> kBeyond = {
    {"JointKdNaN", "moving_target", [](Gains& g) { g.joint_space_gains_d[3] = NAN; }, true},
    {"JointKpNaN", "moving_target", [](Gains& g) { g.joint_space_gains_p[0] = NAN; }, true},
    {"CartesianKpNaN", "moving_target",
     [](Gains& g) {
       leave_soon(g);
       g.task_space_gains_p[0] = NAN;
     },
     true},
    {"CartesianKdNaN", "realistic_moving_target",
     [](Gains& g) {
       leave_soon(g);
       g.task_space_gains_d[5] = NAN;
     },
     true},
    {"KdChatters", "realistic_moving_target",
     [](Gains& g) {
       leave_soon(g);
       g.task_space_gains_d *= 1e4;
     },
     false},
    {"KdChattersFromTheStart", "realistic_moving_target",
     [](Gains& g) {
       g.joint_space_gains_d *= 1e4;
       g.task_space_gains_d *= 1e4;
     },
     false},
};

class ReferenceExtremes : public testing::TestWithParam<Beyond> {};

TEST_P(ReferenceExtremes, EndWithAStatusBeforeTheDeadline) {
  // Of this process's own time, whatever else runs on the machine; the release build needs a few.
  constexpr double kDeadline = 60.0;  // s
  const auto used = [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; };
  const Scenario scenario = test::scenario_of(GetParam().scenario, 1.0);
  Gains gains = test::quick_gains(scenario);
  GetParam().change(gains);
  const double begin = used();
  const RolloutResult result = Rollout(scenario, Stepper::kReference).run(gains, [&](const Observation&) {
    return used() - begin < kDeadline;
  });
  EXPECT_NE(result.status, RolloutStatus::kInterrupted) << "not done after 60 s: " << result.reason;
  EXPECT_LE(result.end_time, scenario.duration + 1e-9);
  for (const Metric metric : all_metrics()) EXPECT_FALSE(std::isinf(result.metrics[metric])) << name(metric);
  switch (result.status) {
    case RolloutStatus::kDiverged:
      EXPECT_THAT(result.reason, testing::MatchesRegex("diverged at [0-9.]+ s in the state [a-zA-Z]+: .*"));
      break;
    case RolloutStatus::kCompleted:
      EXPECT_EQ(result.reason, "");
      break;
    default:
      EXPECT_EQ(result.status, RolloutStatus::kNoSamples) << result.reason;
      EXPECT_NE(result.reason, "");
  }
  if (GetParam().diverges) {
    EXPECT_EQ(result.status, RolloutStatus::kDiverged);
    EXPECT_LE(result.end_time, gains.joint_trajectory_duration + 0.01);
  }
  RecordProperty("ended_as", name(result.status));
  RecordProperty("reason", result.reason);
}

INSTANTIATE_TEST_SUITE_P(Each, ReferenceExtremes, testing::ValuesIn(kBeyond),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace reference_extremes_test
}  // namespace armtune::internal
