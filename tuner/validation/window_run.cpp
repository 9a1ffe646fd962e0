#include "tuner/validation/window_run.hpp"

#include <algorithm>
#include <cmath>

#include "sim/plant/flush_denormals.hpp"
#include "sim/rollout/divergence.hpp"

namespace armtune::internal {
namespace {

/// Returns the first joint outside its position limits, or -1.
int joint_outside(const RobotModel& model, const JointVector& q) {
  for (int j = 0; j < model.n(); ++j) {
    const JointLimits& limits = model.joints[static_cast<std::size_t>(j)].limits;
    if (limits.has_position && (q[j] < limits.lower || q[j] > limits.upper)) return j;
  }
  return -1;
}

}  // namespace

WindowSimulator::WindowSimulator(const RobotModel& model, const MotionCommands& commands)
    : model_(model), commands_(commands), plant_(make_native_plant(model, Stepper::kMidpoint)) {}

WindowRun WindowSimulator::run(const MotionStretch& stretch, const WindowPlace& place) {
  const FlushDenormals flush;
  if (stretch.sample_period != sample_period_) {
    sample_period_ = stretch.sample_period;
    follower_ = make_command_follower(model_, commands_, sample_period_);
  }
  const FilteredMotion& at = stretch.instants[place.first];
  const double since = static_cast<double>(place.first) * stretch.period;
  const ArmStart start{stretch.begin + since, at.q, at.qd, at.qdd};
  follower_->start(start);
  plant_->set_state(start.q, start.qd);

  WindowRun out;
  out.begin = start.time;
  out.start_velocity = start.qd;
  const double step = follower_->step();
  const auto instants = static_cast<Eigen::Index>(horizon_count(place.duration));
  out.measured.resize(instants, model_.n());
  out.simulated.resize(instants, model_.n());
  JointVector tau;
  long k = 0;
  for (Eigen::Index i = 0; i < instants; ++i) {
    const long end = std::lround(static_cast<double>(i) * kHorizonStep / step);
    for (; k < end; ++k) {
      follower_->torque(k, plant_->q(), plant_->qd(), tau);
      plant_->step(tau, step);
    }
    const double time = static_cast<double>(k) * step;
    if (i > 0 && !diverged_joint(model_, plant_->q(), plant_->qd()).empty()) {
      out.failed_at = time;
      break;
    }
    out.time.push_back(time);
    out.measured.row(i) = position_at(stretch, since + time);
    out.simulated.row(i) = plant_->q();
    if (out.limit_joint < 0) {
      out.limit_joint = joint_outside(model_, plant_->q());
      if (out.limit_joint >= 0) out.limit_at = time;
    }
  }
  const auto reached = static_cast<Eigen::Index>(out.time.size());
  out.measured.conservativeResize(reached, Eigen::NoChange);
  out.simulated.conservativeResize(reached, Eigen::NoChange);
  return out;
}

}  // namespace armtune::internal
