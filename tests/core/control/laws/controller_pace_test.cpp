// The velocity governor in the controller: bounded references, and interpolations that wait for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "core/control/laws/controller.hpp"
#include "core/control/velocity_governor.hpp"
#include "core/robot/theta.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/controller_rig.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace controller_pace_test {

constexpr double kMargin = 0.85;

/// Largest share of its velocity limit that a joint's reference takes.
double share(const test::Rig& rig, const JointReference& reference) {
  return reference.velocity.cwiseQuotient(rig.model->velocity_limits()).cwiseAbs().maxCoeff();
}

TEST(ControllerPace, KeepsEveryReferenceBelowTheMarginInEveryStateWhateverIsMeasured) {
  for (const double margin : {0.0, kMargin}) {
    test::Rig rig;
    rig.gains.velocity_margin = margin;
    rig.path.frequency = 0.5;
    rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
    const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
    const std::vector<Obstacle> near = {{poses.p_0B[2] + Vec3(0.1, 0.1, 0.0)}};
    std::mt19937 generator(781);
    const std::unique_ptr<Controller> controller = rig.controller();
    double largest = 0.0;
    std::array<int, 4> visits{};
    for (int step = 0; step < 6000; ++step) {
      Scene scene = rig.scene();
      if (step >= 4000 && step < 4200) scene.obstacles = near;
      if (step >= 4100) scene.target.position += Vec3(0.4, 0.3, 0.2);
      // Some 0.5 rad off: through the wrist's singularity, far from the path.
      const JointState measured{rig.goal().q + test::random_vector(generator, 6, 0.5),
                                test::random_vector(generator, 6, 1.0)};
      const ControlOutput& out = controller->update(measured, scene, step * rig.period);
      ++visits[static_cast<std::size_t>(out.state)];
      largest = std::max(largest, share(rig, out.reference));
      if (margin == 0.0) {
        EXPECT_EQ(out.pace, 1.0);
      }
    }
    for (const int visit : visits) EXPECT_GT(visit, 30);
    if (margin > 0.0) {
      EXPECT_LT(largest, margin);
      EXPECT_GT(largest, kGovernorKnee * margin);
    } else {
      EXPECT_GT(largest, 1.0) << "or the law would say nothing";
    }
  }
}

/// The closed loop while the gaze turns to a target that is 1 rad aside: an independent plant, theta true.
struct SlerpedTurn {
  double largest_share = 0.0;
  double slerp_time = 0.0;  ///< all slerps together [s]
  double angle = 0.0;       ///< of the gaze at the end [rad]

  explicit SlerpedTurn(const Gains& gains) {
    test::Rig rig;
    rig.gains = gains;
    const Poses poses = test::poses_at(rig.model->chain, rig.goal().q);
    const std::unique_ptr<Controller> controller = rig.controller();
    JointState state = rig.goal();
    for (int step = 0; step < 1500; ++step) {
      if (step == 400) {
        rig.p_0G = poses.p_0T + 0.5 * (Eigen::AngleAxisd(1.0, poses.R_0T.col(0)) * poses.R_0T.col(2));
      }
      const ControlOutput& out = controller->update(state, rig.scene(), step * rig.period);
      largest_share = std::max(largest_share, share(rig, out.reference));
      slerp_time += out.slerping ? rig.period : 0.0;
      test::integrate(rig.model->chain, out.torque, rig.period, 1, state);
    }
    const Poses end = test::poses_at(rig.model->chain, state.q);
    angle = gaze_angle(end.R_0T, end.p_0T, rig.p_0G);
  }
};

TEST(ControllerPace, HoldsASlerpThatIsAskedToBeTooFastBelowTheMarginAndLetsItTakeLonger) {
  for (const SlerpReference reference : {SlerpReference::kStart, SlerpReference::kCurrent}) {
    Gains gains = test::ur10_gains();
    gains.slerpDurationErrorGain = 0.1;
    gains.slerp_reference = reference;
    gains.slerp_start = reference == SlerpReference::kCurrent ? 0.2 : 0.0;  // as released
    const SlerpedTurn hurried(gains);
    EXPECT_GT(hurried.largest_share, 1.0);
    for (const double margin : {0.3, kMargin}) {
      gains.velocity_margin = margin;
      const SlerpedTurn held(gains);
      EXPECT_LT(held.largest_share, margin);
      EXPECT_GT(held.slerp_time, hurried.slerp_time);
      EXPECT_LT(held.angle, 0.01) << "it arrives";
    }
  }
}

TEST(ControllerPace, AReturnThatIsSlowedStillJoinsThePathInItsMotion) {
  test::Rig rig;
  rig.path.center += Vec3(0.1, 0.15, 0.1);
  rig.path.frequency = 0.5;
  rig.path.terms = {{1, Vec3(0.05, 0, 0), Vec3(0, 0.05, 0)}};
  rig.gains.trajectoryDurationErrorGain = 0.5;  // 0.2 m in 0.1 s
  rig.gains.velocity_margin = 0.3;
  const std::unique_ptr<Controller> controller = rig.controller();
  JointState state = rig.goal();
  MotionPoint<Vec3> last{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  double first = -1.0;
  double time = 0.0;
  double slowest = 1.0;
  double slowest_near_the_end = 1.0;
  for (int step = 0; step < 3000; ++step) {
    time = step * rig.period;
    const ControlOutput& out = controller->update(state, rig.scene(), time);
    ASSERT_LT(share(rig, out.reference), 0.3);
    if (out.state == ControlState::kFollowTrajectory) break;
    if (out.state == ControlState::kReturnToTrajectory) {
      if (first < 0.0) first = time;
      slowest = std::min(slowest, out.pace);
      slowest_near_the_end = out.pace;
      last = out.desired;
    }
    test::integrate(rig.model->chain, out.torque, rig.period, 1, state);
  }
  ASSERT_GT(first, 0.0);
  EXPECT_LT(slowest, 0.99) << "it was slowed";
  EXPECT_EQ(slowest_near_the_end, 1.0) << "and had its own pace again";
  EXPECT_GT(time - first, 0.15) << "k_t asks for 0.1 s";
  // The last reference of the return is up to a period before its end, where the quintic differs from the
  // path by the third order of that: 10 h^3 / T^3 of 0.2 m at T = 0.3 s.
  const MotionPoint<Vec3> path = rig.path.at(time - rig.period);
  EXPECT_LT((last.position - path.position).norm(), 1e-6);
  EXPECT_LT((last.velocity - path.velocity).norm(), 1e-3);
}

TEST(ControllerPace, LeaveSingularityWaitsForItsReference) {
  // 1.5 rad in 0.5 s: fifteen eighths of the average speed are twice the limit.
  for (const double margin : {0.0, kMargin}) {
    test::Rig rig;
    rig.gains.velocity_margin = margin;
    const std::unique_ptr<Controller> controller = rig.controller();
    JointState state = rig.goal();
    state.q[0] -= 1.5;
    double left = -1.0;
    double largest = 0.0;
    for (int step = 0; step < 1500 && left < 0.0; ++step) {
      const ControlOutput& out = controller->update(state, rig.scene(), step * rig.period);
      if (out.state != ControlState::kLeaveSingularity) left = step * rig.period;
      largest = std::max(largest, share(rig, out.reference));
      test::integrate(rig.model->chain, out.torque, rig.period, 1, state);
    }
    if (margin > 0.0) {
      EXPECT_LT(largest, margin);
      EXPECT_GT(left, 0.8);
      EXPECT_LT((state.q - rig.goal().q).lpNorm<Eigen::Infinity>(), 0.1);
    } else {
      EXPECT_GT(largest, 1.5);
      EXPECT_NEAR(left, 0.5, 1e-9);
    }
  }
}

}  // namespace controller_pace_test
}  // namespace armtune::internal
