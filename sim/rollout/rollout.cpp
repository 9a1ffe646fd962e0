#include "sim/rollout/rollout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/robot/theta.hpp"
#include "sim/metrics/accumulator.hpp"
#include "sim/metrics/stimulus_response.hpp"
#include "sim/plant/flush_denormals.hpp"
#include "sim/plant/sensors.hpp"
#include "sim/plant/target_camera.hpp"
#include "sim/plant/torque_delay.hpp"
#include "sim/rollout/true_state.hpp"

namespace armtune {
namespace {

/// A joint this many times faster than its limit will not come back.
constexpr double kDivergedRatio = 20.0;

/// Why the state is beyond use, or empty.
std::string divergence(const RobotModel& model, const JointVector& q, const JointVector& qd) {
  for (int i = 0; i < model.n(); ++i) {
    const JointInfo& joint = model.joints[static_cast<std::size_t>(i)];
    if (!std::isfinite(q[i]) || !std::isfinite(qd[i])) return fmt::format("{} is not finite", joint.name);
    if (std::abs(qd[i]) > kDivergedRatio * joint.limits.velocity) {
      return fmt::format("{} moves at {:.3g}, over {} times its velocity limit {:.3g}", joint.name, qd[i],
                         kDivergedRatio, joint.limits.velocity);
    }
  }
  return {};
}

/// The first limit that is reached, or null.
const EndLimit* reached(const EndLimits& limits, const MetricAccumulator& metrics) {
  for (const EndLimit& limit : limits) {
    if (limit.reached_by(metrics.so_far(limit.metric))) return &limit;
  }
  return nullptr;
}

double cost_so_far(const EndCost& cost, const MetricAccumulator& metrics) {
  double sum = 0.0;
  for (const EndCost::Share& share : cost.shares) sum += share.at(metrics.so_far(share.metric));
  return sum;
}

}  // namespace

Rollout::Rollout(const Scenario& scenario, Stepper stepper, Engine engine)
    : scenario_(scenario),
      plant_model_(plant_model(scenario)),
      theta_start_(start_theta(scenario)),
      theta_true_(theta_of(plant_model_.chain)),
      plant_(make_plant(plant_model_, stepper, engine)) {}

RolloutResult Rollout::run(const Gains& gains, const Observer& observer, const EndLimits& limits,
                           const EndCost& cost) {
  const FlushDenormals flush;
  const double period = scenario_.control_period;
  const int periods = scenario_.periods();
  Controller controller(scenario_.robot, gains, theta_start_, period);
  Sensors sensors(scenario_.plant.position_noise, scenario_.plant.velocity_noise, scenario_.seed);
  TargetCamera camera(scenario_);
  TorqueDelay delay(scenario_.robot->n(), scenario_.plant.torque_delay_periods);
  MetricAccumulator metrics(*scenario_.robot, gains.slerpAngularErrorThreshold, period);
  if (scenario_.planned)
    metrics.look_from(scenario_.active_target(std::max(0.0, scenario_.start_time - period)));
  TrueState truth(*scenario_.robot, theta_true_);
  JointState measured;
  std::vector<Vec3> centers(scenario_.obstacles.size());
  HarmonicPath path = scenario_.path;
  Scene scene{&path, {}, centers, scenario_.planned.get()};
  const std::optional<Stimulus>& stimulus = scenario_.stimulus;
  std::optional<StimulusResponse> response;
  if (stimulus) response.emplace(scenario_);
  Observation o;
  o.theta = &controller.theta();
  o.q = &plant_->q();
  o.qd = &plant_->qd();

  const JointVector at_rest = JointVector::Zero(scenario_.robot->n());
  plant_->set_state(scenario_.start_position,
                    scenario_.start_velocity.size() > 0 ? scenario_.start_velocity : at_rest);
  RolloutResult result;
  int k = 0;
  for (; k < periods; ++k) {
    const double time = scenario_.start_time + k * period;
    sensors.measure(plant_->q(), plant_->qd(), measured);
    o.time = time;
    o.target = scenario_.active_target(time);
    o.target_motion = scenario_.targets[o.target].path.at(time);
    if (stimulus) {
      const Vec3 offset = stimulus->at(time);
      if (stimulus->on == Stimulus::On::kPath) path.center = scenario_.path.center + offset;
      if (stimulus->on == Stimulus::On::kTarget) o.target_motion.position += offset;
    }
    scene.target = camera.see(o.target, o.target_motion, time);
    for (std::size_t i = 0; i < centers.size(); ++i) {
      centers[i] = scenario_.obstacles[i].path.at(time).position;
    }
    o.control = &controller.update(measured, scene, time);
    const JointVector& torque = delay.pass(o.control->torque);
    o.applied = &torque;
    truth.observe(centers, o);
    metrics.add(o);
    if (response) response->add(o);
    if (observer && !observer(o)) {
      result.status = RolloutStatus::kInterrupted;
      result.reason = fmt::format("interrupted at {:.3f} s", time);
      break;
    }
    if (const EndLimit* limit = reached(limits, metrics)) {
      result.status = RolloutStatus::kHopeless;
      result.reason = fmt::format("{} reached {:.4g} at {:.3f} s in {}; beyond repair from {:.4g} on",
                                  name(limit->metric), metrics.so_far(limit->metric), time,
                                  name(o.control->state), limit->value);
      break;
    }
    if (cost_so_far(cost, metrics) > cost.beyond) {
      result.status = RolloutStatus::kOutdone;
      result.reason = fmt::format(
          "objective and penalties reached {:.4g} at {:.3f} s in {}; of no use to the search from {:.4g} on",
          cost_so_far(cost, metrics), time, name(o.control->state), cost.beyond);
      break;
    }
    try {
      plant_->step(torque, period);
      result.reason = divergence(*scenario_.robot, plant_->q(), plant_->qd());
    } catch (const std::exception& e) {
      result.reason = fmt::format("the engine gave up: {}", e.what());
    }
    if (!result.reason.empty()) {
      result.status = RolloutStatus::kDiverged;
      result.reason =
          fmt::format("diverged at {:.3f} s in {}: {}", time + period, name(o.control->state), result.reason);
      ++k;
      break;
    }
  }
  result.end_time = k * period;
  result.metrics = metrics.result(scenario_.start_time + result.end_time);
  if (response) response->write(result.metrics);
  if (result.status == RolloutStatus::kCompleted && !scenario_.planned &&
      !(result.metrics[Metric::kSamples] > 0.0)) {
    result.status = RolloutStatus::kNoSamples;
    result.reason = fmt::format(
        "no period of {} s counted as tracking: followTrajectory was never held for "
        "1 s outside a slerp; last state {}",
        scenario_.duration, name(o.control->state));
  }
  return result;
}

}  // namespace armtune
