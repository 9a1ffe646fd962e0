// The main job on arms made at random: three to twelve joints, turning and sliding, with the task that they
// have joints for.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/rollout/rollout.hpp"
#include "tests/sim/support/random_job.hpp"

namespace armtune::internal {
namespace random_arms_test {

using test::Job;
using test::random_job;

class RandomArms : public testing::TestWithParam<int> {};

TEST_P(RandomArms, FollowTheirPathAndLookWhereTheyCan) {
  const int n = GetParam();
  for (const unsigned seed : {1U, 2U, 3U}) {
    for (const bool sliding : {false, true}) {
      const Job job = random_job(n, 100U * static_cast<unsigned>(n) + seed, sliding);
      SCOPED_TRACE(fmt::format("{} joints, seed {}, {}", n, seed, sliding ? "sliding" : "turning"));
      const RolloutResult result = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
      ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
      EXPECT_GT(result.metrics[Metric::kSamples], 500.0);
      // A tenth of the circle: what gains that were made for any arm leave.
      EXPECT_LT(result.metrics[Metric::kPositionMax], 2e-3);
      if (tracks_orientation(job.scenario.mask)) {
        EXPECT_LT(result.metrics[Metric::kOrientationMax], 5e-3);
      }
    }
  }
}

TEST_P(RandomArms, DoTheWholeJobWithinTheirVelocityLimits) {
  const int n = GetParam();
  for (const unsigned seed : {1U, 2U}) {
    for (const bool sliding : {false, true}) {
      Job job = test::whole_job(n, 100U * static_cast<unsigned>(n) + seed, sliding);
      SCOPED_TRACE(fmt::format("{} joints, seed {}, {}", n, seed, sliding ? "sliding" : "turning"));
      const auto run = [&job] {
        return Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
      };
      const RolloutResult result = run();
      ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
      // Of 8000 periods: it avoids the obstacle, returns, and follows again.
      EXPECT_GT(result.metrics[Metric::kSamples], 4000.0);
      EXPECT_LT(result.metrics[Metric::kSamples], 7500.0);
      EXPECT_LT(result.metrics[Metric::kObstacleMinClearance], job.gains.obstacleInfluenceRadius);
      EXPECT_GT(result.metrics[Metric::kObstacleMinClearance], 0.02) << "a ball of 5 cm is let past";
      // The governor keeps the references under its margin; what is measured may be a little above them.
      EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], job.gains.velocity_margin + 0.05);
      EXPECT_LT(result.metrics[Metric::kPositionRms], 5e-3) << "a quarter of the circle";
      if (tracks_orientation(job.scenario.mask)) {
        EXPECT_LT(result.metrics[Metric::kOrientationMax], 0.02);
        EXPECT_LT(result.metrics[Metric::kReacquisitionTime], 1.0) << "of the 4 s that a target has";
      }
      job.gains.adaptation_gain = 0.0;
      const RolloutResult unlearned = run();
      EXPECT_LT(result.metrics[Metric::kCompensationErrorRms],
                0.9 * unlearned.metrics[Metric::kCompensationErrorRms]);
    }
  }
}

TEST_P(RandomArms, MoveInSimbodyAsInArmtunesOwnDynamics) {
  const int n = GetParam();
  const Job job = random_job(n, 100U * static_cast<unsigned>(n) + 1U, true);
  const auto simbody = Rollout(job.scenario, Stepper::kMidpoint, Engine::kSimbody).run(job.gains);
  const auto native = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(job.gains);
  for (const Metric m : {Metric::kPositionMax, Metric::kGazeMax, Metric::kJointVelocityMaxRatio,
                         Metric::kJointEffortMaxRatio, Metric::kCompensationErrorRms}) {
    EXPECT_NEAR(simbody.metrics[m], native.metrics[m], 1e-7 * (1.0 + std::abs(native.metrics[m]))) << name(m);
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, RandomArms, testing::Range(3, 13));

}  // namespace random_arms_test
}  // namespace armtune::internal
