#include "core/control/laws/position_streaming_law.hpp"

#include <cmath>

#include "core/control/laws/desired_joints.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/held_drives.hpp"
#include "core/control/laws/position_servo.hpp"

namespace armtune::internal {
namespace {

constexpr double kServoGain = 300.0;    // 1/s^2, UR's default
constexpr double kLookahead = 0.1;      // s, UR's default
constexpr double kPositionRate = 0.25;  // of the rate of the velocity drives

/// Rounding must not move a command by a period.
constexpr double kRounding = 1e-6;

class PositionStreamingLaw final : public TorqueLaw {
 public:
  explicit PositionStreamingLaw(const LawSetup& setup)
      : TorqueLaw(setup),
        stream_period_(own(setup.gains, "servo_stream_period")[0]),
        position_gain_(own(setup.gains, "servo_position_gain")[0]),
        period_(setup.period),
        servo_(setup.model, {own(setup.gains, "servo_gain")[0], own(setup.gains, "servo_lookahead_time")[0]},
               setup.period),
        drives_(setup.model, setup.period),
        desired_(setup.model.n(), setup.period) {}

  void torque(const LawInput& in, JointVector& tau) override {
    const MotionPoint<JointVector> desired = desired_.next(in);
    if (!begun_) servo_.start(in.measured.q);
    if (is_time_to_send(in.time)) commanded_ = desired.position;
    begun_ = true;
    const JointVector from = servo_.position();
    servo_.step(commanded_);
    // The first term is the mean of q_s' over the period.
    velocity_ = (servo_.position() - from) / period_ + position_gain_ * (from - in.measured.q);
    if (drives_.need_weight()) gravity_torque(in.arm, weight_);
    drives_.torque(velocity_, in.measured.qd, weight_, tau);
  }

 private:
  /// True in the first control period, and in the first one of each period of the stream.
  bool is_time_to_send(double time) {
    if (stream_period_ <= period_) return true;
    const double now = std::floor(time / stream_period_ + kRounding);
    const bool is_new = !begun_ || now != sent_;
    sent_ = now;
    return is_new;
  }

  double stream_period_, position_gain_, period_;
  PositionServo servo_;
  HeldDrives drives_;
  DesiredJoints desired_;
  bool begun_ = false;     ///< there was a period before
  double sent_ = 0.0;      ///< period of the stream of the last position sent
  JointVector commanded_;  ///< the last position sent
  JointVector velocity_;   ///< command for the drives
  JointVector weight_;
};

}  // namespace

ControllerKind position_streaming_controller() {
  constexpr auto kScalar = GainShape::kScalar;
  GainField position = positive(own_gain(
      kScalar, "servo_position_gain", "1/s",
      "gain of the robot's position loop, which commands its velocity drives", kPositionRate * kDriveRate));
  position.search = SearchRange::kNone;  // the robot's own
  return {
      kPositionStreaming,
      "streamed joint positions: the robot's servo smooths them by a gain and a look-ahead time, as UR's "
      "servoj, and its simulated position and velocity drives follow",
      {},
      {not_in_loop(positive(own_gain(kScalar, "servo_gain", "1/s^2",
                                     "gain on the difference between the streamed position and the "
                                     "projected one; UR allows 100 to 2000",
                                     kServoGain, 1.0 / 3.0, 20.0 / 3.0))),
       not_in_loop(positive(own_gain(kScalar, "servo_lookahead_time", "s",
                                     "time by which the present position is projected ahead; UR allows "
                                     "0.03 to 0.2 s",
                                     kLookahead, 0.3, 2.0))),
       not_tuned(own_gain(kScalar, "servo_stream_period", "s",
                          "time between two positions that are sent; 0: one in every control period", 0.0)),
       position},
      [](const LawSetup& setup) { return std::make_unique<PositionStreamingLaw>(setup); },
      [](const RobotModel&, const JointVector&, Gains& gains) { without_velocity_limits(gains); }};
}

}  // namespace armtune::internal
