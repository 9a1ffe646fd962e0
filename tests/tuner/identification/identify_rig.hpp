#pragma once
// Logs of arms that differ from their robot file, and what identification finds in them.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/robot/slotine_li.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/support/files.hpp"
#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/identification/identify.hpp"

namespace armtune::internal::test {

inline const std::atomic<bool> kNever{false};
/// moving_target on an arm whose links and rotors differ by up to 30 % from the URDF, with friction and
/// sensor noise.
inline Scenario differing_arm(unsigned seed, double noise) {
  std::mt19937 generator(seed);
  Scenario scenario = load_scenario("moving_target");
  const auto factors = [&generator] {
    return JointVector(JointVector::Ones(6) + random_vector(generator, 6, 0.3));
  };
  PlantConditions& plant = scenario.plant;
  plant.mass_factors = factors();
  plant.inertia_factors = factors();
  plant.rotor_factors = factors();
  plant.viscous_friction.resize(6);
  plant.viscous_friction << 4, 4, 2.5, 0.75, 0.75, 0.5;
  plant.coulomb_friction = plant.viscous_friction.cwiseProduct(factors());
  plant.position_noise = noise * 1e-4;
  plant.velocity_noise = noise * 1e-2;
  scenario.seed = seed;
  return scenario;
}

inline Excitation random_series(const RobotModel& arm, std::uint64_t seed) {
  ExcitationOptions options;
  options.center.resize(6);
  options.center << 0.0, -1.5, -1.0, -1.5, 1.5, 0.0;
  options.min_height = 0.1;
  options.seed = seed;
  options.evaluations = 300;
  return design_excitation(arm, options, kNever).excitation;
}

inline ParameterVector true_theta(const Scenario& scenario) {
  return theta_of(plant_model(scenario).chain);
}

/// RMS of the difference between two thetas' torques along a trajectory, over the RMS of the second's: of all
/// joints together, and of the joint where it is largest.
struct PredictionError {
  double all = 0.0;
  double worst_joint = 0.0;
};

inline PredictionError prediction_errors(const RobotModel& arm, const Excitation& e,
                                         const ParameterVector& found, const ParameterVector& truth) {
  JointVector squares = JointVector::Zero(arm.n());
  JointVector total = JointVector::Zero(arm.n());
  SlotineLi motion;
  JointVector a, b;
  for (double t = 0.0; t < e.duration; t += 0.01) {
    const MotionPoint<JointVector> point = e.at(t);
    const Poses poses = poses_at(arm.chain, point.position);
    slotine_li_forward(arm.chain, poses, point.velocity, point.velocity, point.acceleration, motion);
    slotine_li_torque(arm.chain, poses, motion, found, a);
    slotine_li_torque(arm.chain, poses, motion, truth, b);
    squares += (a - b).cwiseAbs2();
    total += b.cwiseAbs2();
  }
  return {std::sqrt(squares.sum() / total.sum()), std::sqrt(squares.cwiseQuotient(total).maxCoeff())};
}

inline double prediction_error(const RobotModel& arm, const Excitation& e, const ParameterVector& found,
                               const ParameterVector& truth) {
  return prediction_errors(arm, e, found, truth).all;
}

class Identify : public ::testing::Test {
 protected:
  TemporaryFolder folder_;
  Scenario nominal_ = load_scenario("moving_target");
  const RobotModel& arm_ = *nominal_.robot;
  Excitation exciting_ = random_series(arm_, 1);
  Excitation unseen_ = random_series(arm_, 2);

  std::string log(const Scenario& scenario, double torque_noise, const std::string& name = "log.csv") {
    ExcitationLogOptions options;
    options.torque_noise = torque_noise;
    return folder_.write(name, log_csv(arm_, simulate_excitation(scenario, exciting_, options, kNever)));
  }
  /// A log in which only some joints move, with torques by inverse dynamics and noise of both sensors.
  ExcitationLog log_of_some_joints(const std::vector<int>& moving, const ParameterVector& truth,
                                   double position_noise) const {
    std::mt19937 generator(39);
    std::normal_distribution<double> normal;
    ExcitationLog log;
    SlotineLi motion;
    for (double t = 0.0; t < 12.0; t += 0.002) {
      const MotionPoint<JointVector> all = exciting_.at(t);
      LogSample sample;
      sample.time = t;
      sample.q = exciting_.center;
      sample.qd = JointVector::Zero(arm_.n());
      JointVector qdd = JointVector::Zero(arm_.n());
      for (const int j : moving) {
        sample.q[j] = all.position[j];
        sample.qd[j] = all.velocity[j];
        qdd[j] = all.acceleration[j];
      }
      const Poses poses = poses_at(arm_.chain, sample.q);
      slotine_li_forward(arm_.chain, poses, sample.qd, sample.qd, qdd, motion);
      slotine_li_torque(arm_.chain, poses, motion, truth, sample.torque);
      sample.torque += random_vector(generator, arm_.n(), 0.3);
      for (double& position : sample.q) position += position_noise * normal(generator);
      log.samples.push_back(sample);
    }
    return log;
  }
  Identification identified(const std::vector<std::string>& logs, const IdentifyOptions& options = {}) {
    return identify(arm_, logs, default_log_columns(arm_), options, kNever);
  }
};

}  // namespace armtune::internal::test
