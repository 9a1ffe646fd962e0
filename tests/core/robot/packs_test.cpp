// Several arms in packs are, to the bit, each of them alone: every kernel of a control period.

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "core/common/pack.hpp"
#include "core/control/adaptation.hpp"
#include "core/control/obstacle_distance.hpp"
#include "core/control/task_resolution.hpp"
#include "core/robot/chain_cast.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace packs_test {

using test::random_vector;

/// What one arm's period begins with.
struct Inputs {
  JointVector q, qd, torque, middle, pull;
  Vec6 rate, acceleration;
  Vec3 obstacle;
  ParameterVector theta;
  double threshold = 0.0, growing = 0.0, gamma = 0.0;
};

Inputs random_inputs(std::mt19937& generator, const RobotModel& arm) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Inputs in;
  in.q = test::random_configuration(generator, arm);
  in.qd = random_vector(generator, arm.n(), 1.0);
  in.torque = random_vector(generator, arm.n(), 20.0);
  in.middle = random_vector(generator, arm.n(), 1.0);
  in.pull = random_vector(generator, arm.n(), 1.0);
  in.rate = random_vector(generator, 6, 1.0);
  in.acceleration = random_vector(generator, 6, 1.0);
  in.obstacle = random_vector(generator, 3, 1.0);
  in.theta = theta_of(arm.chain) * unit(generator);
  in.threshold = 0.2 * unit(generator);  // some arms are above it, some below
  in.growing = unit(generator) < 0.5 ? 0.0 : 1.0;
  in.gamma = unit(generator);
  return in;
}

/// The period of one arm, or of one in each lane.
template <typename T>
struct Period {
  ChainT<T> chain;
  JointVectorT<T> q, qd, torque, tau, qdd, within_a_step;
  TaskReferenceT<T> task;
  ObstacleT<T> obstacle;
  InverseDampingT<T> damping;
  T gamma{0.0}, distance{0.0};
  TaskMask mask = TaskMask::kPose;
  JointCenteringT<T> centering;
  MeasuredArmT<T> arm;
  JointReferenceT<T> reference;
  SlotineLiT<T> motion;
  AdaptationT<T> adaptation;
  ForwardDynamicsT<T> work;

  void run() {
    arm.measure(chain, q, qd, damping, mask);
    arm.differentiate(chain, qd);
    distance = obstacle_distance<T>(chain, arm.poses, {&obstacle, 1});
    resolve(task, arm, centering, q, qd, reference);
    slotine_li_forward(chain, arm.poses, qd, reference.velocity, reference.acceleration, motion);
    slotine_li_torque(chain, arm.poses, motion, adaptation.theta(), tau);
    adaptation.step(motion, motion, gamma, T(0.002));
    adaptation.leak(gamma, T(0.3), T(0.002));
    forward_dynamics(chain, arm.poses, qd, torque, work, qdd);
    // From another velocity, and so long that some joints of some arms have stiff friction.
    forward_dynamics(chain, arm.poses, qd, torque, FrictionStep<T>(T(0.05), centering.middle), work,
                     within_a_step);
  }

  /// f(number) for what comes out.
  template <typename F>
  void outputs(F f) const {
    const auto each = [&f](const auto& block) {
      for (Eigen::Index i = 0; i < block.size(); ++i) f(block.data()[i]);
    };
    each(arm.poses.R_0T);
    each(arm.poses.p_0T);
    each(arm.J);
    each(arm.J_dot);
    each(arm.twist);
    f(arm.inverse.manipulability());
    f(distance);
    each(reference.velocity);
    each(reference.acceleration);
    each(tau);
    each(adaptation.theta());
    each(qdd);
    each(within_a_step);
    f(norm(tau));
  }
};

/// put(to, from) for every input.
template <typename T, typename Put>
void put_inputs(const Inputs& in, Period<T>& p, Put put) {
  const auto each = [&put](auto& to, const auto& from) {
    to.resize(from.size());
    for (Eigen::Index i = 0; i < from.size(); ++i) put(to.data()[i], from.data()[i]);
  };
  each(p.q, in.q);
  each(p.qd, in.qd);
  each(p.torque, in.torque);
  each(p.centering.middle, in.middle);
  each(p.centering.rate, in.pull);
  each(p.task.rate, in.rate);
  each(p.task.acceleration, in.acceleration);
  each(p.obstacle.center, in.obstacle);
  put(p.obstacle.radius, 0.1 * std::abs(in.obstacle.x()));
  each(p.adaptation.theta(), in.theta);
  each(p.adaptation.start(), in.theta);
  put(p.damping.threshold, in.threshold);
  put(p.damping.psi, 0.05);
  put(p.damping.growing, in.growing);
  put(p.gamma, in.gamma);
}

std::vector<std::uint64_t> alone(const Chain& chain, TaskMask mask, const Inputs& in) {
  Period<double> p;
  p.mask = mask;
  p.chain = chain;
  put_inputs(in, p, [](double& to, double from) { to = from; });
  p.run();
  std::vector<std::uint64_t> bits;
  p.outputs([&bits](double x) { bits.push_back(std::bit_cast<std::uint64_t>(x)); });
  return bits;
}

constexpr std::array kMasks{TaskMask::kPose, TaskMask::kPositionAndAxis, TaskMask::kPosition};

template <int W>
void expect_lanes_equal_arms_alone(int seed) {
  using T = Pack<W>;
  std::mt19937 generator(static_cast<unsigned>(seed));
  int damped = 0;
  int undamped = 0;
  for (const RobotModel& arm : test::all_arms()) {
    for (int sample = 0; sample < 15; ++sample) {
      std::vector<Inputs> in;
      Period<T> p;
      Chain chain = arm.chain;
      if (sample % 2 == 1) chain.link_radius = random_vector(generator, arm.n(), 0.1).cwiseAbs();
      p.chain = chain_cast<T>(chain);
      p.mask = kMasks[static_cast<std::size_t>(sample) % kMasks.size()];
      for (int lane = 0; lane < W; ++lane) {
        in.push_back(random_inputs(generator, arm));
        put_inputs(in.back(), p, [lane](T& to, double from) { to.set(lane, from); });
      }
      p.run();
      for (int lane = 0; lane < W; ++lane) {
        std::vector<std::uint64_t> bits;
        p.outputs([&](const T& x) { bits.push_back(std::bit_cast<std::uint64_t>(x[lane])); });
        EXPECT_EQ(bits, alone(chain, p.mask, in[static_cast<std::size_t>(lane)]))
            << arm.name << ", " << name(p.mask) << ", lane " << lane;
        ++(p.arm.inverse.damped()[lane] != 0 ? damped : undamped);
      }
    }
  }
  EXPECT_GT(damped, 0);
  EXPECT_GT(undamped, 0);
}

TEST(Packs, OfTwoAreEachArmAlone) {
  expect_lanes_equal_arms_alone<2>(81);
}
TEST(Packs, OfFourAreEachArmAlone) {
  expect_lanes_equal_arms_alone<4>(82);
}
TEST(Packs, OfEightAreEachArmAlone) {
  expect_lanes_equal_arms_alone<8>(83);
}

TEST(Packs, TakeTheSlowWayWithAnArmFarOutAlone) {
  using T = Pack<4>;
  JointVectorT<T> x(2), sines, cosines;
  const double angles[2][4] = {{0.3, 2e5, -1.0, NAN}, {1.0, 0.5, NAN, 0.2}};
  for (int i = 0; i < 2; ++i) {
    for (int lane = 0; lane < 4; ++lane) x[i].set(lane, angles[i][lane]);
  }
  sines_and_cosines(x, sines, cosines);
  for (int lane = 0; lane < 4; ++lane) {
    const JointVector own = Eigen::Vector2d(angles[0][lane], angles[1][lane]);
    JointVector s, c;
    sines_and_cosines(own, s, c);
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(sines[i][lane]), std::bit_cast<std::uint64_t>(s[i])) << lane;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(cosines[i][lane]), std::bit_cast<std::uint64_t>(c[i])) << lane;
    }
  }
}

TEST(Packs, MasksHoldSomewhereEverywhereOrNowhere) {
  Pack<4> x(1.0);
  EXPECT_TRUE(all(x > Pack<4>(0.0)));
  x.set(2, -1.0);
  EXPECT_FALSE(all(x > Pack<4>(0.0)));
  EXPECT_TRUE(any(x > Pack<4>(0.0)));
  EXPECT_FALSE(any(x > Pack<4>(2.0)));
  EXPECT_EQ(select(x > Pack<4>(0.0), Pack<4>(5.0), Pack<4>(7.0))[2], 7.0);
  EXPECT_TRUE(std::signbit(Pack<4>(-0.0)[1]));
  EXPECT_FALSE(std::signbit(abs(Pack<4>(-0.0))[1]));
  EXPECT_EQ(abs(x)[2], 1.0);
}

}  // namespace packs_test
}  // namespace armtune::internal
