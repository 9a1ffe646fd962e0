#include "core/control/laws/position_streaming_law.hpp"

#include "core/control/laws/arm_torque_law.hpp"
#include "core/control/laws/first_gains.hpp"

namespace armtune::internal {
namespace {

constexpr double kServoGain = 300.0;  // 1/s^2, UR's default
constexpr double kLookahead = 0.1;    // s, UR's default

}  // namespace

ControllerKind position_streaming_controller() {
  constexpr auto kScalar = GainShape::kScalar;
  GainField position = positive(own_gain(
      kScalar, "servo_position_gain", "1/s",
      "gain of the robot's position loop, which commands its velocity drives; if the robot's file gives a "
      "position_gain, the loop uses position_gain * (this value / 15) instead",
      kDrivePositionGain));
  position.search = SearchRange::kNone;  // the robot's own
  return {kPositionStreaming,
          "streamed joint positions: the robot's servo smooths them by a gain and a look-ahead time, as UR's "
          "servoj does, and its simulated position and velocity drives follow",
          {},
          {not_in_loop(positive(own_gain(kScalar, "servo_gain", "1/s^2",
                                         "gain on the difference between the streamed position and the "
                                         "projected one; UR allows 100 to 2000",
                                         kServoGain, 1.0 / 3.0, 20.0 / 3.0))),
           not_in_loop(positive(own_gain(kScalar, "servo_lookahead_time", "s",
                                         "time by which the present position is projected ahead; UR allows "
                                         "0.03 to 0.2 s",
                                         kLookahead, 0.3, 2.0))),
           position},
          [](const LawSetup& setup) { return make_torque_law(ArmLawKind::kPositionStreaming, setup); },
          [](const RobotModel&, const JointVector&, Gains& gains) { without_velocity_limits(gains); },
          false,
          ArmLawKind::kPositionStreaming};
}

}  // namespace armtune::internal
