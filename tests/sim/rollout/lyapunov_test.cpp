// The stability proof's balance in Simbody, over whole noise-free rollouts. With
// V = S^T (M + D) S / 2 + |theta_hat - theta|^2 / (2 gamma) the law makes V' = -S^T Kd S (Slotine and Li
// 1987) if qr'' is the derivative of qr'. In leaveSingularity it is. The Cartesian law's only nearly is
// (rotation vectors, the damped inverse, the published gaze that stands still), which adds S^T (M + D) (qr''
// - d qr'/dt).

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/robot/theta.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace lyapunov_test {

/// Integrals over the periods of one state that follow one another without a saturated torque.
struct Balance {
  double dissipated = 0.0;   ///< of S^T Kd S dt
  double correction = 0.0;   ///< of |S^T (M + D) (qr'' - d qr'/dt)| dt
  double discrepancy = 0.0;  ///< of |V' + S^T Kd S - correction| dt, V' by the difference of a period
};

struct Instant {
  ControlState state = ControlState::kLeaveSingularity;
  bool counts = false;
  double V = 0.0;
  double power = 0.0;
  JointVector S;
  JointReference reference;
  JointMatrix M;
};

Instant instant_of(const Observation& o, const Chain& chain, const ParameterVector& truth,
                   const ParameterVector& theta, const Gains& gains) {
  Instant now;
  const ControlOutput& out = *o.control;
  now.state = out.state;
  now.counts = !out.saturated;
  now.S = out.S;
  now.reference = out.reference;
  now.M = test::mass_matrix_at(chain, *o.q);
  now.M.diagonal() += chain.rotor_inertia;
  now.V = 0.5 * now.S.dot(now.M * now.S) + 0.5 / gains.adaptation_gain * (theta - truth).squaredNorm();
  const bool joint_space = out.state == ControlState::kLeaveSingularity;
  JointVector Kd = joint_space ? gains.joint_space_gains_d : gains.task_space_gains_d;
  if (out.slerping) Kd.tail<3>() *= gains.interpolation_gain_scale;
  now.power = now.S.dot(Kd.cwiseProduct(now.S));
  return now;
}

/// moving_target with theta unknown, on an arm with friction.
Balance balance(ControlState state, const std::string& gains_name, double period) {
  Scenario scenario = load_scenario("moving_target");
  scenario.duration = 14.0;
  scenario.control_period = period;
  scenario.plant.viscous_friction = JointVector::Constant(6, 2.0);
  Gains gains = load_gains(gains_name, joint_names(*scenario.robot));
  // What moves theta besides the law: projection, towards the truth in another norm, leakage, and a filter's
  // lag.
  gains.adaptation_projection = false;
  gains.adaptation_leakage = 0.0;
  gains.adaptation_inertia_leakage = 0.0;
  gains.adaptation_filter = 0.0;
  const Chain chain = plant_model(scenario).chain;
  const ParameterVector truth = theta_of(chain);
  // The observer sees theta after the period's step; the torque was made with the one before.
  ParameterVector theta = start_theta(scenario);
  Balance sum;
  Instant last;
  Rollout rollout(scenario, Stepper::kMidpoint);
  const RolloutResult result = rollout.run(gains, [&](const Observation& o) {
    const Instant now = instant_of(o, chain, truth, theta, gains);
    if (now.counts && last.counts && now.state == state && last.state == state) {
      const double dissipated = 0.5 * period * (now.power + last.power);
      const JointVector jump = 0.5 * period * (now.reference.acceleration + last.reference.acceleration) -
                               (now.reference.velocity - last.reference.velocity);
      const double correction = 0.5 * (now.S.dot(now.M * jump) + last.S.dot(last.M * jump));
      sum.dissipated += dissipated;
      sum.correction += std::abs(correction);
      sum.discrepancy += std::abs(now.V - last.V + dissipated - correction);
    }
    last = now;
    theta = *o.theta;
    return true;
  });
  EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
  return sum;
}

/// The torque is held over a period and theta steps by Euler's rule: what is left is of first order in it.
/// largest_correction: share of what is dissipated.
void expect_balanced(ControlState state, const std::string& gains, double largest_correction) {
  const Balance coarse = balance(state, gains, 0.001);
  const Balance fine = balance(state, gains, 0.0005);
  testing::Test::RecordProperty(
      "shares", fmt::format("discrepancy {:.3g} -> {:.3g} of what is dissipated, {:.3g} J; correction {:.3g}",
                            coarse.discrepancy / coarse.dissipated, fine.discrepancy / fine.dissipated,
                            fine.dissipated, fine.correction / fine.dissipated));
  EXPECT_GT(fine.dissipated, 0.1) << "there was something to balance [J]";
  EXPECT_LE(fine.correction, largest_correction * fine.dissipated);
  EXPECT_LT(fine.discrepancy, 1e-3 * fine.dissipated);
  EXPECT_GT(fine.discrepancy, 0.4 * coarse.discrepancy);
  EXPECT_LT(fine.discrepancy, 0.6 * coarse.discrepancy);
}

TEST(LyapunovInSimbody, FallsByWhatKdDissipatesWhileLeavingTheSingularity) {
  expect_balanced(ControlState::kLeaveSingularity, "published", 1e-5);
}

TEST(LyapunovInSimbody, FallsByWhatKdDissipatesAlongThePath) {
  expect_balanced(ControlState::kFollowTrajectory, "published", 0.3);  // the gaze that stands still
}

TEST(LyapunovInSimbody, FallsByWhatKdDissipatesUnderTheExtendedLaw) {
  expect_balanced(ControlState::kFollowTrajectory, "extended", 0.005);
}

}  // namespace lyapunov_test
}  // namespace armtune::internal
