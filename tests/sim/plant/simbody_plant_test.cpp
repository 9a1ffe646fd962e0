#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <exception>
#include <limits>
#include <random>
#include <thread>

#include "core/robot/dynamics.hpp"
#include "sim/plant/plant.hpp"
#include "sim/scenario/scenario.hpp"
#include "tests/core/support/arms.hpp"

namespace armtune::internal {
namespace simbody_plant_test {

class RandomStates {
 public:
  RandomStates(int n, unsigned seed) : n_(n), generator_(seed) {}

  JointVector vector(double bound) {
    std::uniform_real_distribution<double> uniform(-bound, bound);
    JointVector v(n_);
    for (double& x : v) x = uniform(generator_);
    return v;
  }

 private:
  int n_;
  std::mt19937 generator_;
};

/// (M + D)^-1 (tau - h - friction) of core's dynamics.
JointVector expected_accelerations(const Chain& chain, const JointVector& q, const JointVector& qd,
                                   const JointVector& torque) {
  Poses poses;
  forward_kinematics(chain, q, poses);
  JointVector bias;
  inverse_dynamics(chain, poses, qd, JointVector(JointVector::Zero(chain.n)), bias);
  JointMatrix M;
  mass_matrix(chain, poses, M);
  M.diagonal() += chain.rotor_inertia;
  return M.llt().solve(torque - bias);
}

double energy(const Chain& chain, const Plant& plant) {
  Poses poses;
  forward_kinematics(chain, plant.q(), poses);
  JointMatrix M;
  mass_matrix(chain, poses, M);
  M.diagonal() += chain.rotor_inertia;
  double total = 0.5 * plant.qd().dot(M * plant.qd());
  for (int i = 0; i < chain.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    total -=
        chain.gravity.dot(chain.link[k].mass * poses.p_0B[k] + poses.R_0B[k] * chain.link[k].first_moment);
  }
  return total;
}

RobotModel without_friction(RobotModel model) {
  model.chain.viscous_friction.setZero();
  model.chain.coulomb_friction.setZero();
  return model;
}

/// Largest change of the energy of an unpowered, frictionless fall from a moving start [J].
double energy_drift(const RobotModel& arm, Stepper stepper, double h, double duration) {
  const RobotModel model = without_friction(arm);
  const auto plant = make_simbody_plant(model, stepper);
  RandomStates random(model.n(), 5);
  const JointVector q = random.vector(1.0);
  plant->set_state(q, random.vector(0.5));
  const double start = energy(model.chain, *plant);
  const JointVector zero = JointVector::Zero(model.n());
  double drift = 0.0;
  for (int k = 0; k < static_cast<int>(std::lround(duration / h)); ++k) {
    plant->step(zero, h);
    drift = std::max(drift, std::abs(energy(model.chain, *plant) - start));
  }
  return drift;
}

/// Largest relative difference between the plant's accelerations and core's, on random states.
double worst_difference(const RobotModel& model, Plant& plant, unsigned seed) {
  RandomStates random(model.n(), seed);
  double worst = 0.0;
  for (int i = 0; i < 100; ++i) {
    const JointVector q = random.vector(3.0);
    const JointVector qd = random.vector(2.0);
    const JointVector torque = random.vector(100.0);
    JointVector qdd;
    plant.accelerations(q, qd, torque, qdd);
    const JointVector expected = expected_accelerations(model.chain, q, qd, torque);
    worst = std::max(worst, (qdd - expected).norm() / expected.norm());
  }
  return worst;
}

TEST(SimbodyPlant, AcceleratesAsCoresDynamicsSay) {
  unsigned seed = 20;
  for (const RobotModel& model : test::all_arms()) {
    const auto plant = make_simbody_plant(model, Stepper::kMidpoint);
    EXPECT_LT(worst_difference(model, *plant, ++seed), 1e-9) << model.name;
  }
}

// Rotor inertia is added with core's mass matrix; without it Simbody speaks alone.
TEST(SimbodyPlant, AcceleratesAsCoresDynamicsSayWithoutRotorInertia) {
  unsigned seed = 40;
  for (RobotModel model : test::all_arms()) {
    model.chain.rotor_inertia.setZero();
    const auto plant = make_simbody_plant(model, Stepper::kMidpoint);
    EXPECT_LT(worst_difference(model, *plant, ++seed), 1e-9) << model.name;
  }
}

TEST(SimbodyPlant, TheReferenceAcceleratesLikeTheOthers) {
  const RobotModel model = test::seven_joint_arm();
  const auto plant = make_simbody_plant(model, Stepper::kReference);
  EXPECT_LT(worst_difference(model, *plant, 60), 1e-9);
}

TEST(SimbodyPlant, KeepsTheEnergyOfAnUndampedFallWithTheReferenceStepper) {
  for (const RobotModel& model : test::all_arms()) {
    // Some 10 to 100 J are exchanged in this time; accuracy is 1e-10 per step.
    EXPECT_LT(energy_drift(model, Stepper::kReference, 0.01, 0.4), 1e-6) << model.name;
  }
}

TEST(SimbodyPlant, KeepsTheEnergyOfAnUndampedFallWithRungeKutta) {
  for (const RobotModel& model : test::all_arms()) {
    const double coarse = energy_drift(model, Stepper::kRungeKutta4, 4e-3, 0.4);
    const double fine = energy_drift(model, Stepper::kRungeKutta4, 2e-3, 0.4);
    EXPECT_LT(fine, 1e-4) << model.name;
    // What is left is the rule's own error: it falls with h^4 or faster.
    EXPECT_GT(coarse / fine, 10.0) << model.name;
  }
}

TEST(SimbodyPlant, FrictionOnlyRemovesEnergy) {
  for (const RobotModel& model : test::all_arms()) {
    if (model.chain.viscous_friction.isZero(0.0)) continue;
    const auto plant = make_simbody_plant(model, Stepper::kRungeKutta4);
    RandomStates random(model.n(), 6);
    const JointVector q = random.vector(1.0);
    plant->set_state(q, random.vector(1.0));
    const JointVector zero = JointVector::Zero(model.n());
    double before = energy(model.chain, *plant);
    const double start = before;
    for (int k = 0; k < 1000; ++k) {
      plant->step(zero, 1e-3);
      const double after = energy(model.chain, *plant);
      ASSERT_LE(after, before + 1e-9) << model.name << " at " << k;
      before = after;
    }
    EXPECT_LT(before, start - 0.1) << model.name;
  }
}

TEST(SimbodyPlant, APayloadAddsAPointMassAtTheTool) {
  Scenario scenario;
  const Payload payload{1.5, Vec3(0.02, -0.03, 0.05)};
  scenario.plant.payload = payload;
  for (const RobotModel& model : test::all_arms()) {
    scenario.robot = std::make_shared<RobotModel>(model);
    const auto plant = make_simbody_plant(plant_model(scenario), Stepper::kMidpoint);
    Chain chain = model.chain;  // its tool where the mass is, so that its Jacobian is the mass's
    chain.p_BT += chain.R_BT * payload.center;
    RandomStates random(model.n(), 7);
    for (int i = 0; i < 20; ++i) {
      const JointVector q = random.vector(3.0);
      const JointVector qd = random.vector(2.0);
      const JointVector torque = random.vector(100.0);
      Poses poses;
      forward_kinematics(chain, q, poses);
      Jacobian J, J_dot;
      tool_jacobian(chain, poses, J);
      tool_jacobian_derivative(chain, poses, J, qd, J_dot);
      JointVector bias;
      inverse_dynamics(chain, poses, qd, JointVector(JointVector::Zero(chain.n)), bias);
      const Vec3 a = J_dot.topRows<3>() * qd - chain.gravity;
      bias += payload.mass * J.topRows<3>().transpose() * a;
      JointMatrix M;
      mass_matrix(chain, poses, M);
      M.diagonal() += chain.rotor_inertia;
      M += payload.mass * J.topRows<3>().transpose() * J.topRows<3>();
      const JointVector expected = M.llt().solve(torque - bias);
      JointVector qdd;
      plant->accelerations(q, qd, torque, qdd);
      EXPECT_LT((qdd - expected).norm(), 1e-9 * expected.norm()) << model.name;
    }
  }
}

TEST(SimbodyPlant, ATorqueThatIsNotFiniteShowsInTheState) {
  const RobotModel model = test::ur10();
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity(), -1e308}) {
    const auto plant = make_simbody_plant(model, Stepper::kMidpoint);
    JointVector torque = JointVector::Zero(model.n());
    torque[2] = value;
    if (!std::isfinite(value)) {
      JointVector qdd;
      plant->accelerations(plant->q(), plant->qd(), torque, qdd);
      EXPECT_FALSE(qdd.allFinite()) << value;
    }
    plant->step(torque, 2e-3);
    EXPECT_FALSE(plant->q().allFinite() && plant->qd().allFinite()) << value;
  }
}

TEST(SimbodyPlant, TheReferenceGivesUpAtATorqueThatIsNotFinite) {
  const RobotModel model = test::ur10();
  const auto plant = make_simbody_plant(model, Stepper::kReference);
  const auto fresh = make_simbody_plant(model, Stepper::kReference);
  const JointVector zero = JointVector::Zero(model.n());
  const JointVector start = JointVector::LinSpaced(model.n(), -1.0, 1.0);
  for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    SCOPED_TRACE(value);
    plant->set_state(start, zero);
    JointVector torque = zero;
    torque[2] = value;
    EXPECT_THROW(plant->step(torque, 2e-3), std::exception);
    EXPECT_EQ(plant->q(), start) << "no numbers of a step that was not made";
    EXPECT_EQ(plant->qd(), zero);
    // It is of use for what comes next: to the reference's accuracy, 1e-10.
    plant->set_state(start, zero);
    fresh->set_state(start, zero);
    for (Plant* each : {plant.get(), fresh.get()}) {
      for (int k = 0; k < 5; ++k) each->step(zero, 2e-3);
    }
    EXPECT_LT((plant->q() - fresh->q()).norm(), 1e-8);
    EXPECT_LT((plant->qd() - fresh->qd()).norm(), 1e-8);
    EXPECT_GT(fresh->qd().norm(), 1e-3) << "it fell";
  }
}

/// 500 periods of a swing from a start that depends on `i`.
JointVector swing(Plant& plant, int i) {
  const int n = static_cast<int>(plant.q().size());
  RandomStates random(n, static_cast<unsigned>(i));
  const JointVector q = random.vector(1.0);
  plant.set_state(q, random.vector(1.0));
  const JointVector torque = random.vector(10.0);
  for (int k = 0; k < 500; ++k) plant.step(torque, 2e-3);
  return plant.q();
}

TEST(SimbodyPlant, OnePlantPerThreadGivesTheBitsOfASerialRun) {
  const RobotModel model = test::ur10();
  constexpr int kRuns = 8;
  std::vector<JointVector> serial(kRuns), threaded(kRuns);
  const auto one = make_simbody_plant(model, Stepper::kMidpoint);
  for (int i = 0; i < kRuns; ++i) serial[static_cast<std::size_t>(i)] = swing(*one, i);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        const auto own = make_simbody_plant(model, Stepper::kMidpoint);
        for (int i = t; i < kRuns; i += 4) threaded[static_cast<std::size_t>(i)] = swing(*own, i);
      });
    }
  }
  for (std::size_t i = 0; i < kRuns; ++i) EXPECT_EQ(threaded[i], serial[i]) << "run " << i;
}

TEST(SimbodyPlant, StartsAnewFromAnyState) {
  const RobotModel model = test::seven_joint_arm();
  for (const Stepper stepper : {Stepper::kMidpoint, Stepper::kSemiImplicitEuler, Stepper::kRungeKutta4}) {
    const auto used = make_simbody_plant(model, stepper);
    swing(*used, 1);
    const auto fresh = make_simbody_plant(model, stepper);
    EXPECT_EQ(swing(*used, 2), swing(*fresh, 2)) << name(stepper);
  }
}

}  // namespace simbody_plant_test
}  // namespace armtune::internal
