#include "sim/rollout/shake_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kSmallest = 0.5;   // smallest swing of a torque, divided by the effort limit
constexpr double kSlowest = 0.1;    // s, longest time between turning points of a torque: 5 Hz
constexpr int kFewest = 10;         // fewest swings: five whole periods
constexpr double kSameTime = 0.05;  // s: among joints that begin within this time, the fastest is the cause

constexpr double kSmallestMoved = 0.01;  // smallest swing of a velocity, divided by its limit
constexpr double kShortest = 0.05;       // s, shortest time between turning points of a velocity: 10 Hz
constexpr double kLongest = 1.0;         // s, longest time between them: 0.5 Hz
constexpr double kRegular = 1.5;         // largest ratio of two successive times between turning points
constexpr double kGrown = 2.0;           // last swing divided by the first swing of the run
constexpr double kNoticed = 0.05;        // last swing divided by the velocity limit

}  // namespace

ShakeWatch::ShakeWatch(const RobotModel& model)
    : names_(joint_names(model)),
      effort_(model.effort_limits()),
      speed_(model.velocity_limits()),
      joints_(names_.size()) {}

/// Adds a turning point of the torque to the run.
void ShakeWatch::torque_turned(Joint& joint) {
  Run& run = joint.run;
  const double at = joint.torque.at();
  if (run.turns == 0 || at - run.ended > kSlowest)
    run = {0, at, at, 0.0};
  else
    run.swing = std::max(run.swing, joint.torque.swing());
  ++run.turns;
  run.ended = at;
  if (run.turns > kFewest && (joint.shook.turns == 0 || joint.shook.began == run.began)) joint.shook = run;
}

/// Adds a turning point of the velocity to the growing swings, or starts again with it.
void ShakeWatch::velocity_turned(Joint& joint) {
  Growth& growth = joint.growth;
  Run& run = growth.run;
  const double at = joint.velocity.at();
  const double swing = joint.velocity.swing();
  const double interval = at - run.ended;
  const bool regular =
      growth.interval == 0.0 || std::max(interval / growth.interval, growth.interval / interval) <= kRegular;
  // A swing is compared with the one before the last: on a velocity that rises, swings up are larger than
  // swings down.
  const bool follows = run.turns > 0 && interval >= kShortest && interval <= kLongest && regular &&
                       (run.turns < 3 || swing > growth.before);
  if (!follows) {
    growth = {{1, at, at, 0.0}, 0.0, 0.0, 0.0, 0.0};
    return;
  }
  ++run.turns;
  run.ended = at;
  run.swing = std::max(run.swing, swing);
  if (run.turns == 2) growth.first = swing;
  growth.interval = interval;
  growth.before = growth.last;
  growth.last = swing;
  if (run.turns <= kFewest || swing < kGrown * growth.first || swing < kNoticed) return;
  if (joint.grew.turns == 0 || joint.grew.began == run.began) joint.grew = run;
}

void ShakeWatch::look(const Observation& o) {
  // Only while the arm follows its task: on the way to it, the velocities of a periodic task may grow.
  const bool follows =
      o.control->state == ControlState::kFollowTrajectory || o.control->state == ControlState::kFollowPlan;
  o.each_instant([&](double time, const JointVector&, const JointVector& qd, const JointVector& commanded,
                     const JointVector&) {
    if (follows)
      look(time, qd - o.control->reference.velocity, commanded);
    else
      look(time, JointVector::Zero(qd.size()), commanded);
  });
}

void ShakeWatch::look(double time, const JointVector& velocity_error, const JointVector& commanded) {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    Joint& joint = joints_[i];
    if (joint.torque.look(time, std::clamp(commanded[k] / effort_[k], -1.0, 1.0), kSmallest))
      torque_turned(joint);
    if (joint.velocity.look(time, velocity_error[k] / speed_[k], kSmallestMoved)) velocity_turned(joint);
  }
}

std::optional<Shake> ShakeWatch::first() const {
  std::optional<Shake> found;
  const auto look_at = [&](std::size_t i, const Run& run, bool growing) {
    if (run.turns == 0) return;
    const bool sooner = !found || run.began < found->time - kSameTime;
    const bool faster = found && run.began < found->time + kSameTime && run.frequency() > found->frequency;
    if (sooner || faster) found = Shake{names_[i], run.began, run.frequency(), run.swing, growing};
  };
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    look_at(i, joints_[i].shook, false);
    look_at(i, joints_[i].grew, true);
  }
  return found;
}

std::string swing_text(const Shake& shake) {
  if (shake.growing) {
    return fmt::format("its velocity swings more and more, by {:.2g} of its limit, at {:.3g} Hz", shake.swing,
                       shake.frequency);
  }
  return fmt::format("its torque swings by {:.2g} of its effort limit, at {:.3g} Hz", shake.swing,
                     shake.frequency);
}

std::string to_string(const Shake& shake) {
  return fmt::format("{} {}: {}, from {:.3f} s on", shake.joint, shake.growing ? "oscillates" : "shakes",
                     swing_text(shake), shake.time);
}

}  // namespace armtune::internal
