#include "tuner/verdict/first_breach.hpp"

#include <fmt/format.h>

#include "sim/rollout/rollout.hpp"

namespace armtune::internal {
namespace {

/// Returns how near each joint is to the limit that the metric belongs to (n). The joint with the largest
/// value is the nearest. Empty for a metric that belongs to no joint.
JointVector nearness(Metric metric, const RobotModel& model, const JointVector& q, const JointVector& qd,
                     const JointVector& commanded) {
  switch (metric) {
    case Metric::kJointVelocityMaxRatio:
      return qd.cwiseAbs().cwiseQuotient(model.velocity_limits());
    case Metric::kJointEffortMaxRatio:
      return commanded.cwiseAbs().cwiseQuotient(model.effort_limits());
    case Metric::kJointPositionMinMargin:
      return (model.lower_limits() - q).cwiseMax(q - model.upper_limits());
    default:
      return {};
  }
}

/// Simulates one arm until the metric reaches the limit. Returns the breach, or nothing if there is none.
std::optional<Breach> breach_of(const Scenario& scenario, const Gains& gains, const EndLimit& limit,
                                Stepper stepper) {
  const Engine engine = stepper == Stepper::kReference ? Engine::kSimbody : Engine::kNative;
  Breach breach;
  JointVector near;
  const auto watch = [&](const Observation& o) {
    near.resize(0);
    o.each_instant([&](double, const JointVector& q, const JointVector& qd, const JointVector& commanded,
                       const JointVector&) {
      const JointVector now = nearness(limit.metric, *scenario.robot, q, qd, commanded);
      near = near.size() == 0 ? now : JointVector(near.cwiseMax(now));
    });
    breach.time = o.time;
    return true;
  };
  const RolloutResult result = Rollout(scenario, stepper, engine).run(gains, watch, {limit});
  if (!limit.reached_by(result.metrics[limit.metric])) return std::nullopt;
  if (near.size() > 0) {
    Eigen::Index joint = 0;
    near.maxCoeff(&joint);
    breach.joint = scenario.robot->joints[static_cast<std::size_t>(joint)].name;
  }
  return breach;
}

/// Returns the name of arm k of a study. The last arm is the scenario's own.
std::string arm_name(const SampleSet& set, std::size_t k) {
  if (k == set.samples) return "the scenario's own arm";
  return fmt::format("random arm {} of {}", k + 1, set.samples);
}

}  // namespace

std::optional<Breach> first_breach(const Study& study, const Scenario& scenario, const Gains& gains,
                                   const EndLimit& limit) {
  if (!only_worsens(limit.metric)) return std::nullopt;
  std::optional<Breach> first;
  const std::size_t count = study.robust ? arms(*study.robust) : 1;
  for (std::size_t k = 0; k < count; ++k) {
    const Scenario arm = study.robust ? arm_of(*study.robust, scenario, k) : scenario;
    const auto breach = breach_of(arm, gains, limit, study.stepper);
    if (!breach || (first && first->time <= breach->time)) continue;
    first = breach;
    if (study.robust) first->arm = arm_name(*study.robust, k);
  }
  return first;
}

}  // namespace armtune::internal
