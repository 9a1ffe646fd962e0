// The main job under every controller, on the bundled arms' tasks and on arms made at random.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/default_task.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/sim/support/random_job.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune::internal {
namespace controllers_test {

using test::Job;

/// The job's gains for another controller; the joint goal is on the task.
Gains for_kind(const ControllerKind& kind, const Job& job) {
  const RobotModel& robot = *job.scenario.robot;
  return convert_gains(kind, job.gains, robot, in_si(robot, job.gains.joint_space_goal));
}

class Controllers : public testing::TestWithParam<const char*> {
 protected:
  const ControllerKind& kind() const { return controller_kind(GetParam()); }
};

/// Those whose law has the arm's inertia and friction in it. A joint PD has neither: its law is the next one.
class ModelledControllers : public Controllers {};

TEST_P(ModelledControllers, FollowTheirPathAndLookWhereTheyCanOnArmsMadeAtRandom) {
  for (int n = 3; n <= 12; ++n) {
    for (const unsigned seed : {1U, 2U}) {
      const Job job = test::random_job(n, 100U * static_cast<unsigned>(n) + seed, seed == 2U);
      SCOPED_TRACE(fmt::format("{} joints, seed {}", n, seed));
      const RolloutResult result =
          Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(for_kind(kind(), job));
      ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
      EXPECT_GT(result.metrics[Metric::kSamples], 500.0);
      EXPECT_LT(result.metrics[Metric::kPositionMax], 4e-3);  // of a circle of 0.02 m
      if (tracks_orientation(job.scenario.mask)) {
        EXPECT_LT(result.metrics[Metric::kOrientationMax], 1e-2);
      }
    }
  }
}

// Where the task stands still all that a law must know is gravity (Takegaki and Arimoto 1981).
TEST_P(Controllers, ComeToRestOnATaskThatStandsStillOnArmsMadeAtRandom) {
  for (int n = 3; n <= 12; ++n) {
    Job job = test::random_job(n, 100U * static_cast<unsigned>(n) + 1U, n % 2 == 0);
    SCOPED_TRACE(fmt::format("{} joints", n));
    job.scenario.path = {job.scenario.path.center, 0.0, 0.0, {}};
    // Heavy arms whose joints move each other are slow under a PD.
    job.scenario.duration = kind().name == "joint_pd" ? 60.0 : 20.0;
    double position = 1.0, gaze = 1.0, speed = 1.0;
    const RolloutResult result = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative)
                                     .run(for_kind(kind(), job), [&](const Observation& o) {
                                       position = o.error.head<3>().norm();
                                       gaze = o.gaze_angle;
                                       speed = o.twist.head<3>().norm();
                                       return true;
                                     });
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    EXPECT_LT(position, 1e-3);
    if (tracks_orientation(job.scenario.mask)) {
      EXPECT_LT(gaze, 2e-3);
    }
    EXPECT_LT(speed, 1e-3);
  }
}

// Payload, noise, a torque delay and half-known parameters: what the first tuning starts from.
TEST_P(Controllers, DoTheFirstTaskOfEveryBundledRobotWithTheirStartingGains) {
  // It has no feed-forward, and lags. Its start gains are for arms as light as Franka's.
  const bool cartesian = kind().name == "cartesian_impedance";
  const double share = cartesian ? 1.0 : 0.5;
  for (const char* name : {"ur10", "panda", "youbot"}) {
    if (cartesian && name == std::string("ur10")) continue;
    const auto robot = load_robot(name);
    const DefaultTask task = default_task(robot);
    const Gains gains = convert_gains(
        kind(), starting_gains(*robot, task.scenario.start_position, task.goal, task.manipulability), *robot,
        task.goal);
    const RolloutResult result = Rollout(task.scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
    ASSERT_EQ(result.status, RolloutStatus::kCompleted) << name << ": " << result.reason;
    EXPECT_GT(result.metrics[Metric::kSamples], 5000.0) << name;
    EXPECT_LT(result.metrics[Metric::kPositionMax], share * task.scenario.path.terms[0].cosine.norm())
        << name;
    EXPECT_LT(result.metrics[Metric::kJointVelocityMaxRatio], 1.0) << name;
    EXPECT_GT(result.metrics[Metric::kJointPositionMinMargin], 0.0)
        << name << " within its limits, free joints too";
  }
}

TEST_P(Controllers, MoveInSimbodyAsInArmtunesOwnDynamics) {
  const Job job = test::random_job(7, 701, true);
  const Gains gains = for_kind(kind(), job);
  const auto simbody = Rollout(job.scenario, Stepper::kMidpoint, Engine::kSimbody).run(gains);
  const auto native = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(gains);
  for (const Metric m : {Metric::kPositionMax, Metric::kGazeMax, Metric::kJointVelocityMaxRatio,
                         Metric::kJointEffortMaxRatio, Metric::kCompensationErrorRms}) {
    EXPECT_NEAR(simbody.metrics[m], native.metrics[m], 1e-7 * (1.0 + std::abs(native.metrics[m]))) << name(m);
  }
}

/// Those whose theta stays: an adaptive one learns from its errors.
class FixedControllers : public Controllers {};

// What theta is wrong by is the same question for every law: of the model at the references.
TEST_P(FixedControllers, CompensateNothingWrongWithTheirModelExact) {
  const Job job = test::random_job(6, 601, false);
  const auto result = Rollout(job.scenario, Stepper::kMidpoint, Engine::kNative).run(for_kind(kind(), job));
  EXPECT_LT(result.metrics[Metric::kCompensationErrorRms], 1e-9);
}

std::string name_of(const testing::TestParamInfo<const char*>& kind) {
  return kind.param;
}

INSTANTIATE_TEST_SUITE_P(Kinds, Controllers,
                         testing::Values("adaptive", "joint_pd", "computed_torque", "impedance",
                                         "cartesian_impedance"),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Kinds, ModelledControllers,
                         testing::Values("adaptive", "computed_torque", "impedance"), name_of);
INSTANTIATE_TEST_SUITE_P(Kinds, FixedControllers, testing::Values("joint_pd", "computed_torque", "impedance"),
                         name_of);

}  // namespace controllers_test
}  // namespace armtune::internal
