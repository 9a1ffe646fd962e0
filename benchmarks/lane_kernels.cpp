// Measures the kernels of core with packs in place of scalars, as sim/lanes/avx2_lanes.cpp uses them. A pack
// is an AVX2 register with four numbers, one for each of four UR10s in different states. items_per_second
// counts arms.

#include <benchmark/benchmark.h>

#include <cstdio>
#include <random>

#include "core/common/pack.hpp"
#include "core/robot/chain_cast.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/slotine_li.hpp"
#include "sim/scenario/scenario.hpp"

namespace {

using namespace armtune::internal;
constexpr int kLanes = 4;
using T = Pack<kLanes>;

struct Fixture {
  ChainT<T> chain = chain_cast<T>(load_scenario("obstacle_pass").robot->chain);
  JointVectorT<T> q{chain.n}, qd{chain.n}, qdr{chain.n}, qddr{chain.n};
  ParameterVectorT<T> theta;
  PosesT<T> poses;
  JacobianT<T> J;
  SlotineLiT<T> motion;

  Fixture() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (JointVectorT<T>* v : {&q, &qd, &qdr, &qddr}) {
      for (T& x : *v) {
        for (int lane = 0; lane < kLanes; ++lane) x.set(lane, uniform(generator));
      }
    }
    theta = theta_of(load_scenario("obstacle_pass").robot->chain).cast<T>();
    armtune::internal::forward_kinematics(chain, q, poses);
    tool_jacobian(chain, poses, J);
  }
};

void count_arms(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * kLanes);
}

void forward_kinematics(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    f.q[0] += T(1e-6);
    armtune::internal::forward_kinematics(f.chain, f.q, f.poses);
    benchmark::DoNotOptimize(f.poses);
  }
  count_arms(state);
}
BENCHMARK(forward_kinematics);

void jacobian_and_derivative(benchmark::State& state) {
  Fixture f;
  JacobianT<T> J_dot;
  for (auto _ : state) {
    tool_jacobian(f.chain, f.poses, f.J);
    tool_jacobian_derivative(f.chain, f.poses, f.J, f.qd, J_dot);
    benchmark::DoNotOptimize(J_dot);
  }
  count_arms(state);
}
BENCHMARK(jacobian_and_derivative);

void forward_dynamics(benchmark::State& state) {
  Fixture f;
  ForwardDynamicsT<T> work;
  JointVectorT<T> qdd;
  for (auto _ : state) {
    f.q[0] += T(1e-6);
    body_poses(f.chain, f.q, f.poses);
    armtune::internal::forward_dynamics(f.chain, f.poses, f.qd, f.qddr, work, qdd);
    benchmark::DoNotOptimize(qdd);
  }
  count_arms(state);
}
BENCHMARK(forward_dynamics);

void slotine_li_torque_and_gradient(benchmark::State& state) {
  Fixture f;
  JointVectorT<T> tau;
  ParameterVectorT<T> gradient;
  for (auto _ : state) {
    slotine_li_forward(f.chain, f.poses, f.qd, f.qdr, f.qddr, f.motion);
    slotine_li_torque(f.chain, f.poses, f.motion, f.theta, tau);
    slotine_li_gradient(f.motion, gradient);
    benchmark::DoNotOptimize(tau);
    benchmark::DoNotOptimize(gradient);
  }
  count_arms(state);
}
BENCHMARK(slotine_li_torque_and_gradient);

}  // namespace

int main(int argc, char** argv) {
  if (!__builtin_cpu_supports("avx2")) {
    std::puts("this processor has no AVX2");
    return 1;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
