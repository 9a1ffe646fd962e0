#include "sim/rollout/divergence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/control/laws/first_gains.hpp"
#include "core/robot/friction.hpp"

namespace armtune::internal {

std::string diverged_joint(const RobotModel& model, const JointVector& q, const JointVector& qd) {
  for (int i = 0; i < model.n(); ++i) {
    const JointInfo& joint = model.joints[static_cast<std::size_t>(i)];
    if (!std::isfinite(q[i]) || !std::isfinite(qd[i]))
      return fmt::format("the position or velocity of {} is not finite", joint.name);
    if (std::abs(qd[i]) > kDivergedRatio * joint.limits.velocity) {
      return fmt::format("{} moves at {:.3g}, over {} times its velocity limit {:.3g}", joint.name, qd[i],
                         kDivergedRatio, joint.limits.velocity);
    }
  }
  return {};
}

double damping_limit(int delay_periods) {
  return 2.0 * std::cos(delay_periods * std::numbers::pi / (2.0 * delay_periods + 1.0));
}

std::string unstable_damping(const PreparedScenario& prepared, const JointState& measured,
                             const JointVector& Kd) {
  const RobotModel& plant = prepared.plant;
  if (!measured.q.allFinite() || !measured.qd.allFinite() || !Kd.allFinite()) return {};
  const double h = prepared.scenario.control_period;
  const double limit = damping_limit(prepared.scenario.plant.torque_delay_periods);
  // The largest eigenvalue of M^-1 Kd h is at least (M^-1)_ii Kd_i h. If this exceeds the limit for any
  // joint, the loop is unstable. c: coefficient of the joint's friction, which damps too.
  const JointVector inertia = joint_inertia(plant, measured.q);
  int worst = -1;
  double largest = limit;
  for (int i = 0; i < plant.n(); ++i) {
    const double c = plant.chain.viscous_friction[i] +
                     plant.chain.coulomb_friction[i] / std::max(std::abs(measured.qd[i]), kCoulombVelocity);
    const double ratio = h * (Kd[i] - c) / (inertia[i] + h * c);
    if (!(ratio > largest)) continue;
    largest = ratio;
    worst = i;
  }
  if (worst < 0) return {};
  return fmt::format(
      "the damping of {} is unstable at this control period: Kd * period / inertia is {:.3g} * {:.3g} / "
      "{:.3g} = {:.3g} for this joint. Because the torque is constant for one period{}, this number may be "
      "at most {:.3g}. Lower Kd, shorten the period, or give the joint's 'rotor_inertia'",
      plant.joints[static_cast<std::size_t>(worst)].name, Kd[worst], h, inertia[worst],
      h * Kd[worst] / inertia[worst], prepared.scenario.plant.torque_delay_periods > 0 ? " and delayed" : "",
      limit);
}

}  // namespace armtune::internal
