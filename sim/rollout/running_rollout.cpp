#include "sim/rollout/running_rollout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/common/message_text.hpp"
#include "sim/rollout/divergence.hpp"

namespace armtune::internal {
namespace {

/// Returns the first limit that is reached, or null.
const EndLimit* reached(const EndLimits& limits, const MetricAccumulator& metrics) {
  for (const EndLimit& limit : limits) {
    if (limit.reached_by(metrics.so_far(limit.metric))) return &limit;
  }
  return nullptr;
}

}  // namespace

RunningRollout::RunningRollout(const PreparedScenario& prepared, double threshold, const EndLimits& limits,
                               int torque_delay, int drive_steps)
    : prepared_(prepared),
      scenario_(prepared.scenario),
      limits_(limits),
      threshold_(threshold),
      periods_(scenario_.periods()),
      drive_steps_(drive_steps),
      sensors_(scenario_.plant.position_noise, scenario_.plant.velocity_noise, scenario_.seed,
               scenario_.plant.encoder_offset),
      camera_(scenario_),
      delay_(scenario_.robot->n(), torque_delay),
      metrics_(*scenario_.robot, threshold, scenario_.control_period),
      diverged_velocity_(kDivergedRatio * scenario_.robot->velocity_limits()),
      path_(scenario_.path),
      scene_{&path_, {}, {}, scenario_.planned.get(), scenario_.holds_end} {
  between_.reserve(static_cast<std::size_t>(drive_steps));
  metrics_.sample_every(scenario_.control_period / drive_steps);
  if (scenario_.planned) {
    metrics_.end_plan(scenario_.planned->end());
    metrics_.look_from(
        scenario_.active_target(std::max(0.0, scenario_.start_time - scenario_.control_period)));
  }
  if (scenario_.holds_end) metrics_.aim_at_nothing();
  if (scenario_.stimulus) response_.emplace(scenario_);
  if (scenario_.holds_goal()) goal_.emplace(*scenario_.planned, scenario_.goal_tolerance);
  if (scenario_.clearance) {
    cell_.emplace(scenario_.clearance);
    observation_.cell = &*cell_;
  }
}

void RunningRollout::record(const std::vector<Metric>& metrics) {
  if (!metrics.empty()) series_.emplace(metrics, scenario_, threshold_, metrics_);
}

JointVector RunningRollout::start_velocity() const {
  if (scenario_.start_velocity.size() > 0) return scenario_.start_velocity;
  return JointVector::Zero(scenario_.robot->n());
}

void RunningRollout::end(RolloutStatus status, std::string reason) {
  ended_ = true;
  result_.status = status;
  result_.reason = std::move(reason);
}

void RunningRollout::sense(const JointVector& q, const JointVector& qd, const World& world) {
  Observation& o = observation_;
  o.q = &q;
  o.qd = &qd;
  o.time = world.time;
  o.target = world.target;
  o.target_motion = world.target_motion;
  o.orientation = world.orientation ? &*world.orientation : nullptr;
  o.mask = scenario_.mask;
  sensors_.measure(q, qd, measured_);
  if (scenario_.stimulus) path_.center = scenario_.path.center + world.path_shift;
  scene_.on_path = &world.on_path;
  scene_.target = camera_.see(o.target, o.target_motion, o.time);
  scene_.orientation = o.orientation;
  scene_.obstacles = world.obstacles;
}

DriveInstant& RunningRollout::begin_drive_period(double after, const JointVector& q, const JointVector& qd) {
  sensors_.measure(q, qd, between_measured_);
  return between_.emplace_back(DriveInstant{observation_.time + after, q, qd, {}, {}});
}

Observation& RunningRollout::act(const ControlOutput& control, const ParameterVector& theta,
                                 const JointVector* Kd) {
  Kd_ = Kd;
  observation_.control = &control;
  observation_.between = between_;
  observation_.theta = &theta;
  observation_.applied = &delay_.pass(control.torque);
  return observation_;
}

bool RunningRollout::judge(const Observer& observer) {
  if (cell_) cell_->see(observation_.time, *observation_.q);
  const Observation& o = observation_;
  metrics_.add(o);
  if (series_) series_->add(o, scenario_.control_period / drive_steps_);
  if (response_) response_->add(o);
  if (goal_) goal_->add(o.time, *o.q);
  if (observer && !observer(o)) {
    end(RolloutStatus::kInterrupted, fmt::format("interrupted at {:.3f} s", o.time));
  } else if (const EndLimit* limit = reached(limits_, metrics_)) {
    end(RolloutStatus::kHopeless,
        fmt::format("{} reached {:.4g} at {:.3f} s in the state {}; rollouts are abandoned when this metric "
                    "reaches {:.4g}",
                    name(limit->metric), metrics_.so_far(limit->metric), o.time, name(o.control->state),
                    limit->value));
  }
  between_.clear();
  observation_.between = {};
  return !ended_;
}

void RunningRollout::moved(const JointVector& q, const JointVector& qd, const std::string& failure) {
  ++k_;
  // A sum with a term that is not finite is not finite either.
  const bool sane = (qd.array().abs() <= diverged_velocity_.array()).all() && std::isfinite(q.sum());
  if (sane && failure.empty()) return;
  std::string why = failure.empty() ? diverged_joint(*scenario_.robot, q, qd)
                                    : "the simulation engine failed: " + one_line(failure);
  if (why.empty()) return;
  const std::string cause = Kd_ == nullptr ? "" : unstable_damping(prepared_, measured_, *Kd_);
  if (!cause.empty()) why += "; " + cause;
  end(RolloutStatus::kDiverged,
      fmt::format("diverged at {:.3f} s in the state {}: {}", observation_.time + scenario_.control_period,
                  name(observation_.control->state), why));
}

RolloutResult RunningRollout::result() {
  result_.end_time = k_ * scenario_.control_period;
  result_.metrics = metrics_.result(scenario_.start_time + result_.end_time);
  if (series_) result_.series = std::move(*series_).take();
  if (response_) response_->write(result_.metrics);
  if (goal_) goal_->write(scenario_.start_time + result_.end_time, result_.metrics);
  if (result_.status == RolloutStatus::kCompleted && !scenario_.planned &&
      !(result_.metrics[Metric::kSamples] > 0.0)) {
    result_.status = RolloutStatus::kNoSamples;
    result_.reason = fmt::format(
        "no control period in {} s counted as tracking; a period counts only outside slerps and from 1 s "
        "after the start of the state followTrajectory on; the last state was {}",
        scenario_.duration, name(observation_.control->state));
  }
  return std::move(result_);
}

}  // namespace armtune::internal
