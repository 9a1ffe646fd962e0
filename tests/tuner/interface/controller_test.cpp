// A law of the interface against the same law inside.

#include "armtune/controller.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "armtune/error.hpp"
#include "armtune/rollout.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/rollout/rollout.hpp"
#include "tests/sim/support/rollouts.hpp"

namespace armtune {
namespace controller_test {

std::optional<Robot> kept;  ///< by a law that is gone
int periods = 0;

/// tau = Y theta - stiffness S.
class Outside final : public Law {
 public:
  explicit Outside(const LawSetup& setup) : stiffness_(setup.gains.numbers("outside_stiffness")[0]) {
    EXPECT_EQ(setup.robot.joints(), setup.gains.joints());
    EXPECT_GT(setup.period, 0.0);
    EXPECT_EQ(setup.theta.size(), 13 * setup.robot.joints().size());
    kept = setup.robot;
  }
  void torque(const LawState& state, Eigen::Ref<Eigen::VectorXd> tau) override {
    state.model_torque(state.reference_velocity(), state.reference_acceleration(), tau);
    tau -= stiffness_ * state.sliding();
    EXPECT_EQ(state.sliding(), state.velocity() - state.reference_velocity());
    EXPECT_EQ(state.jacobian().cols(), state.position().size());
    EXPECT_EQ(state.tracks_joints(), std::string(state.state()) == "leaveSingularity");
  }
  void conclude(bool) override { ++periods; }

 private:
  double stiffness_;
};

class Inside final : public internal::TorqueLaw {
 public:
  explicit Inside(const internal::LawSetup& setup)
      : TorqueLaw(setup), stiffness_(internal::own(setup.gains, "inside_stiffness")[0]) {}
  void torque(const internal::LawInput& in, internal::JointVector& tau) override {
    const internal::JointReference& reference = in.control.reference;
    model_torque(in.arm, in.measured.qd, reference.velocity, reference.acceleration, tau);
    tau -= stiffness_ * in.control.S;
  }

 private:
  double stiffness_;
};

const std::vector<std::string> kUses = {"task_space_gains_p", "task_space_gains_i"};

void register_both() {
  static const bool once = [] {
    ControllerKind outside;
    outside.name = "outside";
    outside.meaning = "of a test";
    outside.uses = kUses;
    outside.own = {{.name = "outside_stiffness", .unit = "N m s/rad", .meaning = "of S", .otherwise = 20.0}};
    outside.make = [](const LawSetup& setup) { return std::make_unique<Outside>(setup); };
    outside.start = [](const Robot& robot, std::span<const double> q, Gains& gains) {
      gains.numbers("outside_stiffness")[0] = first_rate() * joint_inertia(robot, q)[0];
    };
    register_controller(outside);
    internal::ControllerKind inside;
    inside.name = "inside";
    inside.meaning = "of a test";
    inside.uses = kUses;
    inside.own = {
        internal::own_gain(internal::GainShape::kScalar, "inside_stiffness", "N m s/rad", "of S", 20.0)};
    inside.make = [](const internal::LawSetup& setup) { return std::make_unique<Inside>(setup); };
    internal::register_controller(inside);
    return true;
  }();
  static_cast<void>(once);
}

TEST(InterfaceOfControllers, ALawGivesTheRolloutOfTheSameLawInside) {
  register_both();
  internal::Scenario scenario = internal::test::scenario_of("moving_target", 6.0);
  scenario.theta.model_scale = 1.0;  // a law that learns nothing has to know the arm
  internal::Gains gains = internal::test::quick_gains(scenario);
  const int n = scenario.robot->n();
  internal::change_controller(gains, "outside", n);
  const auto outside = internal::Rollout(scenario, internal::Stepper::kMidpoint).run(gains);
  internal::change_controller(gains, "inside", n);
  const auto inside = internal::Rollout(scenario, internal::Stepper::kMidpoint).run(gains);
  EXPECT_EQ(outside.status, internal::RolloutStatus::kCompleted);
  EXPECT_EQ(outside.metrics[internal::Metric::kPositionMax], inside.metrics[internal::Metric::kPositionMax]);
  EXPECT_EQ(outside.metrics[internal::Metric::kEffortRateRms],
            inside.metrics[internal::Metric::kEffortRateRms]);
  EXPECT_EQ(periods, scenario.periods());
  EXPECT_EQ(kept->joints(), internal::joint_names(*scenario.robot)) << "whoever is given a robot may keep it";
  internal::own(gains, "inside_stiffness")[0] = 40.0;
  EXPECT_NE(internal::Rollout(scenario, internal::Stepper::kMidpoint)
                .run(gains)
                .metrics[internal::Metric::kPositionMax],
            inside.metrics[internal::Metric::kPositionMax]);
}

TEST(InterfaceOfControllers, StartsFromWhatTheInertiaAsks) {
  register_both();
  const internal::Scenario scenario = internal::test::scenario_of("moving_target", 6.0);
  const internal::JointVector& q = scenario.start_position;
  const internal::Gains gains = internal::convert_gains(
      internal::controller_kind("outside"), internal::test::quick_gains(scenario), *scenario.robot, q);
  const std::vector<double> inertia =
      joint_inertia(Robot(scenario.robot), {q.data(), static_cast<std::size_t>(q.size())});
  EXPECT_EQ(internal::own(gains, "outside_stiffness")[0], first_rate() * inertia[0]);
}

TEST(InterfaceOfControllers, VectorsOfOtherSizesAreRefused) {
  register_both();
  EXPECT_THROW(joint_inertia(Robot::load("ur10"), std::vector<double>(40, 0.0)), InputError);
  class Wrong final : public Law {
   public:
    void torque(const LawState& state, Eigen::Ref<Eigen::VectorXd> tau) override {
      const Eigen::VectorXd long_one = Eigen::VectorXd::Zero(40);
      state.model_torque(long_one, state.reference_acceleration(), tau);
    }
  };
  ControllerKind wrong;
  wrong.name = "wrong_sizes";
  wrong.uses = kUses;
  wrong.make = [](const LawSetup&) { return std::make_unique<Wrong>(); };
  register_controller(wrong);
  internal::Scenario scenario = internal::test::scenario_of("moving_target", 1.0);
  internal::Gains gains = internal::test::quick_gains(scenario);
  internal::change_controller(gains, "wrong_sizes", scenario.robot->n());
  EXPECT_THROW(internal::Rollout(scenario, internal::Stepper::kMidpoint).run(gains), InputError);
}

TEST(InterfaceOfControllers, ANameThatIsTakenIsRefused) {
  register_both();
  ControllerKind again;
  again.name = "outside";
  again.make = [](const LawSetup& setup) { return std::make_unique<Outside>(setup); };
  EXPECT_THROW(register_controller(again), InputError);
}

}  // namespace controller_test
}  // namespace armtune
