#include "tuner/first_task/steady_start.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/tuner/support/short_study.hpp"

namespace armtune::internal {
namespace {

using testing::HasSubstr;

const std::string kParameters =
    "parameters:\n  - {name: task_space_gains_p/rx}\n  - {name: slerpDurationErrorGain}\n";

/// Scenarios long enough for gains that nobody has tuned.
class LongerStudy : public test::ShortStudy {
 public:
  explicit LongerStudy(const std::string& parameters) : ShortStudy(parameters) {
    write("short.yaml", "base: moving_target\nduration: 20\n");
    write("short_realistic.yaml", "base: realistic_moving_target\nduration: 20\n");
  }
};

/// Kp beyond the rate at which S dies: the wrist runs away.
Gains ringing() {
  Gains gains = test::quick_gains(test::scenario_of("moving_target"));
  gains.task_space_gains_p *= 100.0;
  return gains;
}

TEST(SteadyStart, IsTheStudyItselfWhereItsStartCompletesEveryScenario) {
  const LongerStudy files(kParameters);
  const Study study = load_steady_study(files.path(), "", 2);
  const Study as_read = load_study(files.path());
  EXPECT_FALSE(study.given);
  EXPECT_EQ(gains_yaml(study.space.start, {}), gains_yaml(as_read.space.start, {}));
}

TEST(SteadyStart, TakesThePlaceOfGainsThatRing) {
  const LongerStudy files(kParameters);
  const Gains bad = ringing();
  files.write("gains.yaml", gains_yaml(bad, {}));
  const Study study = load_steady_study(files.path(), "", 2);
  ASSERT_TRUE(study.given);
  EXPECT_EQ(study.given->task_space_gains_p, bad.task_space_gains_p);
  EXPECT_THAT(study.given_failure, HasSubstr("short"));
  EXPECT_EQ(study.gains, files / "gains.yaml") << "it is an input still";
  for (const Scenario& scenario : study.scenarios) {
    const RolloutResult result =
        Rollout(scenario, study.stepper, Engine::kSimbody).run(with_goal(study.space.start, scenario));
    EXPECT_EQ(result.status, RolloutStatus::kCompleted) << scenario.name << ": " << result.reason;
    EXPECT_LE(result.metrics[Metric::kJointVelocityMaxRatio], 1.0);
  }
  // Bounds that follow the start follow the new one.
  const Parameter& free = study.space.free[1];
  EXPECT_EQ(free.start, study.space.start.slerpDurationErrorGain);
  EXPECT_LT(free.lower, free.start);
  EXPECT_GT(free.upper, free.start);
}

TEST(SteadyStart, IsOfTheControllerThatTheFileAsksFor) {
  const LongerStudy files(kParameters);
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  const Study study = load_steady_study(files.path(), "computed_torque", 2);
  EXPECT_EQ(study.space.start.controller, "computed_torque");
}

TEST(SteadyStart, BoundsThatLeaveItOutAreNamed) {
  const LongerStudy files(
      "parameters:\n  - {name: task_space_gains_p/x, lower: 500, upper: 100000}\n"
      "  - {name: slerpDurationErrorGain}\n");
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  EXPECT_THAT(test::refusal([&] { load_steady_study(files.path(), "", 2); }),
              testing::AllOf(HasSubstr("cannot be a reference"), HasSubstr("lies outside its bounds")));
}

// Then the start is simulated as the file says, and the error is that of any study.
TEST(SteadyStart, AStudyWithStartsOfItsOwnThatRingIsLeftAsItIs) {
  const LongerStudy files(
      "parameters:\n"
      "  - {name: task_space_gains_p, start: 3000}\n"
      "  - {name: slerpDurationErrorGain}\n");
  files.write("gains.yaml", gains_yaml(ringing(), {}));
  EXPECT_FALSE(load_steady_study(files.path(), "", 2).given);
}

}  // namespace
}  // namespace armtune::internal
