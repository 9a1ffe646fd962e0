// Why the adaptive law is stable: with V = S^T (M + D) S / 2 + |theta_hat - theta|^2 / (2 gamma) the closed
// loop has V' = -S^T Kd S (Slotine and Li 1987), whatever theta is. It uses that Y theta is linear in theta,
// that M' - 2C is skew and that theta_hat moves against Y^T S: a sign that is wrong in any of them breaks it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace lyapunov_test {

/// A leaveSingularity under way in a noise-free closed loop: of its reference qr'' is the exact derivative of
/// qr', which V' needs.
struct Energy {
  double start = 0.0;        ///< V at the start
  double end = 0.0;          ///< V at the end
  double dissipated = 0.0;   ///< integral of S^T Kd S dt
  double discrepancy = 0.0;  ///< integral of |V' + S^T Kd S| dt, V' by the difference of a period
  double moved = 0.0;        ///< |theta at the end - theta at the start|

  Energy(const Chain& chain, double period) {
    constexpr double kGamma = 20.0;
    constexpr double kSeconds = 0.5;
    test::Rig rig;
    RobotModel model = *rig.model;
    model.chain = chain;
    rig.model = std::make_shared<const RobotModel>(model);
    rig.period = period;
    rig.gains.adaptation_gain = kGamma;
    rig.gains.joint_trajectory_duration = 1.0;
    const ParameterVector truth = theta_of(chain);
    const std::unique_ptr<Controller> controller = rig.controller(ParameterVector::Zero(truth.size()));
    JointState state = rig.goal();
    state.q -= (JointVector(6) << 0.5, 0.4, -0.5, 0.4, -0.5, 0.5).finished();
    state.qd << 0.1, -0.1, 0.2, 0.3, -0.2, 0.4;

    const long periods = std::lround(kSeconds / period);
    double last = 0.0;
    double last_power = 0.0;
    for (long k = 0; k <= periods; ++k) {
      const ParameterVector theta = controller->theta();
      const ControlOutput& out = controller->update(state, rig.scene(), static_cast<double>(k) * period);
      EXPECT_EQ(out.state, ControlState::kLeaveSingularity);
      EXPECT_FALSE(out.saturated);
      JointMatrix M = test::mass_matrix_at(chain, state.q);
      M.diagonal() += chain.rotor_inertia;
      const double V = 0.5 * out.S.dot(M * out.S) + 0.5 / kGamma * (theta - truth).squaredNorm();
      const double power = out.S.dot(rig.gains.joint_space_gains_d.cwiseProduct(out.S));
      if (k == 0) start = V;
      if (k > 0) {
        const double mean = 0.5 * (power + last_power);
        dissipated += period * mean;
        discrepancy += std::abs(V - last + period * mean);
      }
      end = V;
      moved = theta.norm();
      last = V;
      last_power = power;
      test::integrate(chain, out.torque, period, 1, state);
    }
  }
};

Chain ur10_with_friction() {
  Chain chain = test::ur10().chain;
  chain.viscous_friction << 4, 4, 2.5, 0.75, 0.75, 0.5;
  chain.coulomb_friction << 4, 4, 2.5, 0.75, 0.75, 0.5;
  return chain;
}

/// The torque is held over a period and theta steps by Euler's rule: both are of first order in the period,
/// and nothing else is.
void expect_balanced(const Chain& chain) {
  const Energy coarse(chain, 0.0004);
  const Energy fine(chain, 0.0002);
  testing::Test::RecordProperty("V", fmt::format("{:.3g} -> {:.3g}, dissipated {:.3g}, theta moved {:.3g}",
                                                 fine.start, fine.end, fine.dissipated, fine.moved));
  testing::Test::RecordProperty("discrepancy",
                                fmt::format("{:.3g} {:.3g}", coarse.discrepancy / coarse.dissipated,
                                            fine.discrepancy / fine.dissipated));
  EXPECT_GT(fine.moved, 0.5) << "theta adapted";
  EXPECT_GT(fine.dissipated, 0.1) << "there was something to balance [J]";
  EXPECT_NEAR(fine.start - fine.end, fine.dissipated, 0.02 * fine.dissipated);
  EXPECT_LT(fine.discrepancy, 0.02 * fine.dissipated);
  EXPECT_GT(fine.discrepancy, 0.4 * coarse.discrepancy);
  EXPECT_LT(fine.discrepancy, 0.6 * coarse.discrepancy);
}

TEST(Lyapunov, FallsByWhatKdDissipatesWithThetaUnknown) {
  expect_balanced(test::ur10().chain);
}

TEST(Lyapunov, FallsByWhatKdDissipatesWithFrictionUnknownToo) {
  expect_balanced(ur10_with_friction());
}

}  // namespace lyapunov_test
}  // namespace armtune::internal
