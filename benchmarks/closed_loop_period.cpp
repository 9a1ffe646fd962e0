// Compares the time of a whole closed-loop control period with that of the two bare Simbody accelerations
// that the midpoint stepper needs. Sensors, state machine, controller with adaptation, rotor inertia,
// friction and metrics make the difference. The two are measured in turn, so that the ratio is reliable on a
// noisy machine.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/run/run_folder.hpp"

namespace {

using namespace armtune::internal;
using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double seconds_since(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// Measures bare accelerations. Without rotor inertia and friction they are Simbody's realization alone.
class BareAcceleration {
 public:
  explicit BareAcceleration(RobotModel model) : n_(model.n()) {
    model.chain.rotor_inertia.setZero();
    model.chain.viscous_friction.setZero();
    model.chain.coulomb_friction.setZero();
    plant_ = make_simbody_plant(model, Stepper::kMidpoint);
  }

  /// Returns the seconds per acceleration.
  double measure(int count) {
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    JointVector q(n_), qd(n_), torque(n_), qdd(n_);
    for (int i = 0; i < n_; ++i) {
      q[i] = uniform(generator);
      qd[i] = uniform(generator);
      torque[i] = 10.0 * uniform(generator);
    }
    const auto began = Clock::now();
    for (int k = 0; k < count; ++k) {
      q[k % n_] += 1e-4;  // a new configuration, so that no cached result is used
      plant_->accelerations(q, qd, torque, qdd);
      sink_ += qdd[0];
    }
    return seconds_since(began) / count;
  }
  double sink() const { return sink_; }

 private:
  int n_;
  std::unique_ptr<Plant> plant_;
  double sink_ = 0.0;
};

}  // namespace

int main() {
  constexpr int kBlocks = 15;
  constexpr double kSimulated = 8.0;  // [s] per block: leaveSingularity, return, following
  fmt::print("{}", measured_with());
  fmt::print("\n{:<28}{:>12}{:>14}{:>8}{:>14}\n", "scenario", "period [us]", "2 x bare [us]", "ratio",
             "x real time");
  double sink = 0.0;
  for (const char* name : {"moving_target", "realistic_moving_target", "obstacle_pass"}) {
    Scenario scenario = load_scenario(name);
    scenario.duration = kSimulated;
    const Gains gains = load_gains("published", joint_names(*scenario.robot));
    Rollout rollout(scenario, Stepper::kMidpoint);
    BareAcceleration bare(*scenario.robot);
    std::vector<double> periods, bares, ratios;
    for (int block = 0; block < kBlocks; ++block) {
      const auto began = Clock::now();
      rollout.run(gains);
      periods.push_back(seconds_since(began) / scenario.periods());
      bares.push_back(2.0 * bare.measure(scenario.periods()));
      ratios.push_back(periods.back() / bares.back());
    }
    sink += bare.sink();
    fmt::print("{:<28}{:>12.2f}{:>14.2f}{:>8.3f}{:>14.1f}\n", name, 1e6 * median(periods),
               1e6 * median(bares), median(ratios), scenario.control_period / median(periods));
  }
  fmt::print("\nMedians of {} blocks of {} s, one core, the two measured in turn.\n", kBlocks, kSimulated);
  return sink == 0.12345 ? 1 : 0;  // keeps the compiler from dropping the work
}
