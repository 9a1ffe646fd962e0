#include "sim/metrics/stimulus_response.hpp"

#include <cmath>

namespace armtune::internal {

StimulusSignals path_signals(const Stimulus& stimulus, double t, const Vec3& path, const Poses& poses) {
  return {stimulus.value(t), stimulus.direction.dot(poses.p_0T - path)};
}

StimulusSignals target_signals(const Stimulus& stimulus, double t, const Vec3& target, const Poses& poses) {
  const Vec3 line = target - poses.p_0T;
  const Vec3 u = line.normalized();
  const Vec3 across = stimulus.direction - stimulus.direction.dot(u) * u;
  constexpr double kAlong = 1e-9;
  if (!(across.norm() > kAlong)) return {};
  const Vec3 e = across.normalized();
  const auto angle = [&u, &e](const Vec3& v) { return std::atan2(v.dot(e), v.dot(u)); };
  return {angle(line + stimulus.at(t)), angle(poses.R_0T.col(2))};
}

StimulusResponse::StimulusResponse(const Scenario& scenario)
    : scenario_(scenario), stimulus_(*scenario.stimulus) {
  if (const Multisine* sines = std::get_if<Multisine>(&stimulus_.shape)) {
    sines_.emplace(sines->orders, sines->base_period);
  } else {
    step_.emplace(scenario.duration - stimulus_.start());
  }
}

StimulusSignals StimulusResponse::signals(const Observation& o) const {
  if (stimulus_.on == Stimulus::On::kPath) {
    return path_signals(stimulus_, o.time, scenario_.path.at(o.time).position, *o.poses);
  }
  return target_signals(stimulus_, o.time, scenario_.targets[o.target].path.at(o.time).position, *o.poses);
}

void StimulusResponse::add(const Observation& o) {
  const bool following = o.control->state == ControlState::kFollowTrajectory;
  if (const Multisine* sines = std::get_if<Multisine>(&stimulus_.shape)) {
    if (reached(o.time, sines->window_start()) && !reached(o.time, sines->window_end())) {
      started_ = true;
      valid_ = valid_ && following && !o.control->slerping;
      ++window_periods_;
      const StimulusSignals s = signals(o);
      sines_->add(o.time, s.reference, s.response);
    }
  } else if (reached(o.time, stimulus_.start())) {
    if (!started_) {
      started_ = true;
      start_ = o.time;
      valid_ = was_tracking_;
    }
    const StimulusSignals s = signals(o);
    if (s.reference == 0.0) {
      valid_ = false;
    } else {
      step_->add(o.time - start_, s.response / s.reference);
    }
  }
  was_tracking_ = following && !o.control->slerping;
}

void StimulusResponse::write(Metrics& m) const {
  if (!started_ || !valid_) return;
  if (step_) {
    m[Metric::kResponseRiseTime] = step_->rise_time();
    m[Metric::kResponseOvershoot] = step_->overshoot();
    m[Metric::kResponseSettlingTime] = step_->settling_time(scenario_.control_period);
    m[Metric::kResponseSteadyStateError] = step_->steady_state_error();
    return;
  }
  const auto& sines = std::get<Multisine>(stimulus_.shape);
  const long whole = std::lround(sines.periods * sines.base_period / scenario_.control_period);
  if (window_periods_ == whole) m[Metric::kResponseBandwidth] = sines_->bandwidth();
}

}  // namespace armtune::internal
