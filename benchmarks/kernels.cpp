// Measures every kernel that runs in a control period, and whole periods, on the bundled UR10.

#include <benchmark/benchmark.h>

#include <random>

#include "core/control/laws/controller.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/slotine_li.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/scenario/scenario.hpp"

namespace {

using namespace armtune::internal;

/// A random state of the UR10, and the quantities that the kernels need.
struct Fixture {
  Scenario scenario = load_scenario("obstacle_pass");
  const Chain& chain = scenario.robot->chain;
  JointVector q{chain.n}, qd{chain.n}, qdr{chain.n}, qddr{chain.n};
  ParameterVector theta = theta_of(chain);
  Poses poses;
  Jacobian J;
  SlotineLi motion;

  Fixture() {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (JointVector* v : {&q, &qd, &qdr, &qddr}) {
      for (double& x : *v) x = uniform(generator);
    }
    forward_kinematics(chain, q, poses);
    tool_jacobian(chain, poses, J);
    slotine_li_forward(chain, poses, qd, qdr, qddr, motion);
  }
};

void forward_kinematics(benchmark::State& state) {
  Fixture f;
  for (auto _ : state) {
    f.q[0] += 1e-6;
    armtune::internal::forward_kinematics(f.chain, f.q, f.poses);
    benchmark::DoNotOptimize(f.poses);
  }
}
BENCHMARK(forward_kinematics);

void jacobian_and_derivative(benchmark::State& state) {
  Fixture f;
  Jacobian J_dot;
  for (auto _ : state) {
    tool_jacobian(f.chain, f.poses, f.J);
    tool_jacobian_derivative(f.chain, f.poses, f.J, f.qd, J_dot);
    benchmark::DoNotOptimize(J_dot);
  }
}
BENCHMARK(jacobian_and_derivative);

void inverse_dynamics(benchmark::State& state) {
  Fixture f;
  JointVector tau;
  for (auto _ : state) {
    armtune::internal::inverse_dynamics(f.chain, f.poses, f.qd, f.qddr, tau);
    benchmark::DoNotOptimize(tau);
  }
}
BENCHMARK(inverse_dynamics);

void forward_dynamics(benchmark::State& state) {
  Fixture f;
  ForwardDynamics work;
  JointVector qdd;
  for (auto _ : state) {
    f.q[0] += 1e-6;
    armtune::internal::body_poses(f.chain, f.q, f.poses);
    armtune::internal::forward_dynamics(f.chain, f.poses, f.qd, f.qddr, work, qdd);
    benchmark::DoNotOptimize(qdd);
  }
}
BENCHMARK(forward_dynamics);

void mass_matrix(benchmark::State& state) {
  Fixture f;
  JointMatrix M;
  for (auto _ : state) {
    armtune::internal::mass_matrix(f.chain, f.poses, M);
    benchmark::DoNotOptimize(M);
  }
}
BENCHMARK(mass_matrix);

void slotine_li_torque_and_gradient(benchmark::State& state) {
  Fixture f;
  JointVector tau;
  ParameterVector gradient;
  for (auto _ : state) {
    slotine_li_forward(f.chain, f.poses, f.qd, f.qdr, f.qddr, f.motion);
    slotine_li_torque(f.chain, f.poses, f.motion, f.theta, tau);
    slotine_li_gradient(f.motion, gradient);
    benchmark::DoNotOptimize(tau);
    benchmark::DoNotOptimize(gradient);
  }
}
BENCHMARK(slotine_li_torque_and_gradient);

void slotine_li_regressor(benchmark::State& state) {
  Fixture f;
  Regressor Y;
  for (auto _ : state) {
    slotine_li_forward(f.chain, f.poses, f.qd, f.qdr, f.qddr, f.motion);
    armtune::internal::slotine_li_regressor(f.chain, f.poses, f.motion, Y);
    benchmark::DoNotOptimize(Y);
  }
}
BENCHMARK(slotine_li_regressor);

void controller_update(benchmark::State& state) {
  Fixture f;
  const Gains gains = load_gains("published", joint_names(*f.scenario.robot));
  Controller controller(f.scenario.robot, gains, f.theta, f.scenario.control_period);
  const JointState measured{gains.joint_space_goal * (M_PI / 180.0), JointVector::Zero(f.chain.n)};
  const Scene scene{&f.scenario.path, f.scenario.targets[0].path.at(0.0), {}};
  double time = 0.0;
  for (auto _ : state) {
    time += f.scenario.control_period;
    benchmark::DoNotOptimize(controller.update(measured, scene, time));
  }
}
BENCHMARK(controller_update);

/// Measures sensors, controller, two accelerations and metrics of rollouts side by side. Items are arms.
void native_period(benchmark::State& state) {
  Scenario scenario = load_scenario("moving_target");
  scenario.duration = 1e6;
  const Gains gains = load_gains("published", joint_names(*scenario.robot));
  const auto prepared = std::make_shared<const PreparedScenario>(scenario);
  RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, 0), static_cast<int>(state.range(0)));
  while (lanes.free_lane() >= 0) lanes.start(lanes.free_lane(), {prepared, gains});
  for (auto _ : state) lanes.step([](int, RolloutResult&&) {});
  state.SetItemsProcessed(state.iterations() * lanes.lanes());
}
BENCHMARK(native_period)->Arg(2)->Arg(4)->Arg(8);

}  // namespace
