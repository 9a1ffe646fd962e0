#include "sim/rollout/shake_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

constexpr double kSmallest = 0.5;   // smallest swing between turning points, divided by the effort limit
constexpr double kSlowest = 0.1;    // s, longest time between turning points: 5 Hz
constexpr int kFewest = 10;         // fewest swings: five whole periods
constexpr double kSameTime = 0.05;  // s: among joints that begin within this time, the fastest is the cause

}  // namespace

ShakeWatch::ShakeWatch(const RobotModel& model)
    : joints_(joint_names(model)), effort_(model.effort_limits()), turning_(joints_.size()) {}

/// Records that the torque turned at its extreme.
void ShakeWatch::turn(Turning& joint) {
  Run& run = joint.run;
  if (run.turns == 0 || joint.at - run.ended > kSlowest)
    run = {0, joint.at, joint.at, 0.0};
  else
    run.swing = std::max(run.swing, std::abs(joint.extreme - joint.turned));
  ++run.turns;
  run.ended = joint.at;
  joint.turned = joint.extreme;
  if (run.turns > kFewest && (joint.first.turns == 0 || joint.first.began == run.began)) joint.first = run;
}

void ShakeWatch::look(const Observation& o) {
  o.each_instant([this](double time, const JointVector&, const JointVector&, const JointVector& commanded,
                        const JointVector&) { look(time, commanded); });
}

void ShakeWatch::look(double time, const JointVector& commanded) {
  for (std::size_t i = 0; i < turning_.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    Turning& joint = turning_[i];
    const double share = std::clamp(commanded[k] / effort_[k], -1.0, 1.0);
    if (std::isnan(share)) continue;
    if (joint.direction == 0) {
      // While the direction is not known: the lowest and the highest torque so far.
      joint.turned = looked_ ? std::min(joint.turned, share) : share;
      joint.extreme = looked_ ? std::max(joint.extreme, share) : share;
      if (joint.extreme - joint.turned < kSmallest) continue;
      joint.direction = share > joint.turned ? 1 : -1;
      if (joint.direction < 0) joint.turned = joint.extreme;
    } else if (joint.direction * (share - joint.extreme) <= 0.0) {
      if (std::abs(share - joint.extreme) < kSmallest) continue;
      turn(joint);
      joint.direction = -joint.direction;
    }
    joint.extreme = share;
    joint.at = time;
  }
  looked_ = true;
}

std::optional<Shake> ShakeWatch::first() const {
  std::optional<Shake> found;
  for (std::size_t i = 0; i < turning_.size(); ++i) {
    const Run& run = turning_[i].first;
    if (run.turns == 0) continue;
    const bool sooner = !found || run.began < found->time - kSameTime;
    const bool faster = found && run.began < found->time + kSameTime && run.frequency() > found->frequency;
    if (sooner || faster) found = Shake{joints_[i], run.began, run.frequency(), run.swing};
  }
  return found;
}

std::string to_string(const Shake& shake) {
  return fmt::format(
      "{} shakes: its torque swings by {:.2g} of its effort limit, at {:.3g} Hz, from {:.3f} s on",
      shake.joint, shake.swing, shake.frequency, shake.time);
}

}  // namespace armtune::internal
