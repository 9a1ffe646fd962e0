// Measures how the time of armtune's own simulation grows with joints, with the length of a scenario, with
// arms side by side and with threads. Prints a line "curve,x,value" per point, for scripts/plot-speed.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/control/laws/controller.hpp"
#include "core/robot/dynamics.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/theta.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/workers/candidate_runner.hpp"

namespace {

using namespace armtune::internal;
using Clock = std::chrono::steady_clock;

/// Returns the shortest time of several runs [s], which is the least disturbed one.
double least_seconds(int runs, const std::function<void()>& work) {
  double least = 1e300;
  for (int i = 0; i < runs; ++i) {
    const auto began = Clock::now();
    work();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - began).count());
  }
  return least;
}

/// Returns a UR10 with n joints: cut off after n joints, or continued by its own joints from the base on.
RobotModel with_joints(const RobotModel& ur10, int n) {
  RobotModel model = ur10;
  model.chain.n = n;
  model.joints.clear();
  for (JointVector Chain::*numbers :
       {&Chain::rotor_inertia, &Chain::viscous_friction, &Chain::coulomb_friction}) {
    (model.chain.*numbers).resize(n);
  }
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const std::size_t from = k % static_cast<std::size_t>(ur10.n());
    model.chain.motion[k] = ur10.chain.motion[from];
    model.chain.R_PB0[k] = ur10.chain.R_PB0[from];
    model.chain.p_PB0[k] = ur10.chain.p_PB0[from];
    model.chain.link[k] = ur10.chain.link[from];
    for (JointVector Chain::*numbers :
         {&Chain::rotor_inertia, &Chain::viscous_friction, &Chain::coulomb_friction}) {
      (model.chain.*numbers)[i] = (ur10.chain.*numbers)[static_cast<Eigen::Index>(from)];
    }
    model.joints.push_back(ur10.joints[from]);
  }
  return model;
}

JointVector repeated(const JointVector& values, int n) {
  JointVector more(n);
  for (int i = 0; i < n; ++i) more[i] = values[i % values.size()];
  return more;
}

/// Measures controller and two accelerations at changing states, without sensors, delay and metrics [us].
void measure_joints(const Scenario& scenario, const Gains& six) {
  constexpr int kStates = 2000;
  for (int n = 3; n <= kMaxJoints; ++n) {
    const auto model = std::make_shared<const RobotModel>(with_joints(*scenario.robot, n));
    Gains gains = six;
    for (JointVector Gains::*values : {&Gains::joint_space_gains_p, &Gains::joint_space_gains_d,
                                       &Gains::task_space_gains_d, &Gains::joint_space_goal}) {
      gains.*values = repeated(six.*values, n);
    }
    gains.force_control_gains = repeated(six.force_control_gains, n);
    gains.joint_trajectory_duration = 0.1;  // afterwards the task's law acts
    std::mt19937 generator(1);              // NOLINT: the same states every time are wanted
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<JointState> states(kStates);
    for (JointState& state : states) {
      state.q.resize(n);
      state.qd.resize(n);
      for (int i = 0; i < n; ++i) {
        state.q[i] = 2.0 * uniform(generator);
        state.qd[i] = 0.1 * uniform(generator);
      }
    }
    Poses poses;
    ForwardDynamics work;
    JointVector qdd;
    const JointVector torque = JointVector::Zero(n);
    const double accelerations = least_seconds(15, [&] {
      for (const JointState& state : states) {
        body_poses(model->chain, state.q, poses);
        forward_dynamics(model->chain, poses, state.qd, torque, work, qdd);
      }
    });
    const double control = least_seconds(15, [&] {
      Controller controller(model, gains, theta_of(model->chain), scenario.control_period);
      Scene scene{&scenario.path, scenario.targets[0].path.at(0.0), {}};
      double time = 0.0;
      for (const JointState& state : states) {
        controller.update(state, scene, time);
        time += scenario.control_period;
      }
    });
    fmt::print("acceleration by joints [us],{},{:.4f}\n", n, 1e6 * accelerations / kStates);
    fmt::print("controller and two accelerations by joints [us],{},{:.4f}\n", n,
               1e6 * (control + 2.0 * accelerations) / kStates);
  }
}

void measure_length(Scenario scenario, const Gains& gains) {
  for (const double duration : {2.0, 4.0, 8.0, 16.0, 32.0, 64.0}) {
    scenario.duration = duration;
    Rollout rollout(scenario, Stepper::kMidpoint, Engine::kNative);
    const double seconds = least_seconds(9, [&] { rollout.run(gains); });
    fmt::print("rollout by its length [ms],{},{:.4f}\n", duration, 1e3 * seconds);
  }
}

void measure_lanes(const std::shared_ptr<const PreparedScenario>& prepared, const Gains& gains) {
  const Scenario& scenario = prepared->scenario;
  const double alone =
      least_seconds(9, [&] { Rollout(prepared, Stepper::kMidpoint, Engine::kNative).run(gains); });
  fmt::print("times real time by arms side by side,1,{:.1f}\n", scenario.duration / alone);
  for (int arms = 2; arms <= most_lanes(best_processor()); ++arms) {
    const double seconds = least_seconds(9, [&] {
      RolloutLanes lanes(lane_kind(scenario, Stepper::kMidpoint, scenario.obstacles.size()), arms);
      for (int lane = 0; lane < arms; ++lane) lanes.start(lane, {prepared, gains});
      while (lanes.busy() > 0) lanes.step([](int, RolloutResult&&) {});
    });
    fmt::print("times real time by arms side by side,{},{:.1f}\n", arms, arms * scenario.duration / seconds);
  }
}

void measure_threads(const Scenario& scenario, const Gains& gains) {
  const std::vector<Gains> candidates(64, gains);
  const std::atomic<bool> never{false};
  for (const int threads : {1, 2}) {
    CandidateRunner workers({scenario}, Stepper::kMidpoint, threads);
    const Conditions native{.engine = Engine::kNative};
    const double seconds = least_seconds(5, [&] { workers.run(candidates, never, {}, native); });
    fmt::print("times real time by threads,{},{:.1f}\n", threads,
               static_cast<double>(candidates.size()) * scenario.duration / seconds);
  }
}

}  // namespace

int main() {
  const auto prepared = std::make_shared<const PreparedScenario>(load_scenario("moving_target"));
  const Scenario& scenario = prepared->scenario;
  const Gains gains = load_gains("published", joint_names(*scenario.robot));
  std::istringstream versions(measured_with());
  for (std::string line; std::getline(versions, line);) fmt::print("# {}\n", line);
  fmt::print("# UR10, moving_target, native, kernels for {}\n", name(best_processor()));
  fmt::print("curve,x,value\n");
  measure_joints(scenario, gains);
  measure_length(scenario, gains);
  measure_lanes(prepared, gains);
  measure_threads(scenario, gains);
  return 0;
}
