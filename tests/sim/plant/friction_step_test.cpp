// Steps under friction that an explicit rule does not bear, and under friction that it does.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "sim/plant/plant.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"

namespace armtune::internal {
namespace friction_step_test {

constexpr std::array kStiffSteppers = {Stepper::kMidpoint, Stepper::kSemiImplicitEuler,
                                       Stepper::kRungeKutta4};
constexpr std::array kBothEngines = {Engine::kNative, Engine::kSimbody};

/// The first joints of the seven-joint arm.
RobotModel first_joints(int n) {
  RobotModel model = test::seven_joint_arm();
  model.joints.resize(static_cast<std::size_t>(n));
  model.chain.n = n;
  for (JointVector* v :
       {&model.chain.rotor_inertia, &model.chain.viscous_friction, &model.chain.coulomb_friction}) {
    v->setZero(n);
  }
  return model;
}

/// One joint that turns the inertia I about a vertical axis through the link's centre of mass.
RobotModel flywheel(double I, double viscous, double coulomb) {
  RobotModel model = first_joints(1);
  model.chain.link[0] = {1.0, Vec3::Zero(), I * Mat3::Identity()};
  model.chain.viscous_friction[0] = viscous;
  model.chain.coulomb_friction[0] = coulomb;
  return model;
}

/// Three joints, the last of which turns a light link without rotor inertia about its own axis, under
/// friction that is stiff: h slope / inertia = 0.002 (1 + 20) / 3e-4 = 140.
RobotModel light_wrist() {
  RobotModel model = first_joints(3);
  Chain& chain = model.chain;
  chain.rotor_inertia << 0.1, 0.1, 0.0;
  chain.viscous_friction << 0.5, 0.5, 1.0;
  chain.coulomb_friction << 0.4, 0.4, 1.0;
  const Vec3 center(0.0, 0.0, 0.02);
  LinkInertia light;
  light.mass = 0.3;
  light.inertia = 2e-4 * Mat3::Identity();
  chain.link[2] = in_frame(light, Mat3::Identity(), center);
  return model;
}

struct Friction {
  const char* name;
  double viscous, coulomb;  ///< shares of the slope at rest
};
constexpr std::array kFrictions = {Friction{"viscous", 1.0, 0.0}, Friction{"Coulomb", 0.0, 1.0},
                                   Friction{"both", 0.5, 0.5}};

TEST(FrictionStepped, OneJointComesToRestAndNeverGainsEnergyHoweverStiffItsFrictionIs) {
  constexpr double h = 0.002;
  constexpr double I = 0.01;
  constexpr double kStart = 1.0;
  const JointVector none = JointVector::Zero(1);
  for (const Friction& friction : kFrictions) {
    for (const double z : {0.1, 0.5, 0.9, 1.0, 1.5, 2.0, 3.0, 10.0, 100.0, 1000.0}) {  // h slope / I
      const double slope = z * I / h;
      const RobotModel model =
          flywheel(I, friction.viscous * slope, friction.coulomb * slope * kCoulombVelocity);
      for (const Engine engine : kBothEngines) {
        for (const Stepper stepper : kStiffSteppers) {
          const std::string where =
              fmt::format("{} friction, z = {}, {}, {}", friction.name, z, name(engine), name(stepper));
          const auto plant = make_plant(model, stepper, engine);
          plant->set_state(none, JointVector::Constant(1, kStart));
          double before = kStart;
          // Coulomb friction alone takes 20 / z steps of 0.05 rad/s each, then the velocity falls by 1 / (1 +
          // z).
          for (int k = 0; k < 600; ++k) {
            plant->step(none, h);
            const double v = plant->qd()[0];
            // Down to the rounding of tanh, 1e-16.
            ASSERT_LE(std::abs(v), before + 1e-15) << where << ", step " << k;
            ASSERT_GE(v, -1e-15) << where << ": friction alone turns no motion round, step " << k;
            before = std::abs(v);
          }
          EXPECT_LT(before, 1e-8) << where;
        }
      }
    }
  }
}

TEST(FrictionStepped, OneStiffJointSlidesAsFastAsTheTorqueBeyondCoulombFrictionPermits) {
  constexpr double h = 0.002;
  // Fv q' + Fc tanh(q'/0.05) = torque; once with the joint held by Coulomb friction, once sliding.
  const RobotModel model = flywheel(1e-4, 0.5, 1.0);
  for (const double speed : {0.01, 0.04, 0.3, 2.0, -0.04, -2.0}) {
    const JointVector torque = JointVector::Constant(1, 0.5 * speed + std::tanh(speed / kCoulombVelocity));
    for (const Engine engine : kBothEngines) {
      for (const Stepper stepper : kStiffSteppers) {
        const auto plant = make_plant(model, stepper, engine);
        plant->set_state(JointVector::Zero(1), JointVector::Zero(1));
        for (int k = 0; k < 300; ++k) plant->step(torque, h);
        EXPECT_NEAR(plant->qd()[0], speed, 1e-6 * std::abs(speed))
            << name(engine) << ", " << name(stepper) << ", " << speed;
      }
    }
  }
}

/// Where an arm is at t = 0.2 s under constant torque, from a moving start: q, q'.
JointVector end_state(const RobotModel& model, Stepper stepper, Engine engine, int steps) {
  std::mt19937 generator(77);
  const auto plant = make_plant(model, stepper, engine);
  plant->set_state(test::random_vector(generator, model.n(), 0.5),
                   test::random_vector(generator, model.n(), 0.5) + JointVector::Constant(model.n(), 0.6));
  const JointVector torque = test::random_vector(generator, model.n(), 3.0);
  for (int k = 0; k < steps; ++k) plant->step(torque, 0.2 / steps);
  JointVector state(2 * model.n());
  state << plant->q(), plant->qd();
  return state;
}

/// log2 of how much the error falls with half the step.
double order(const RobotModel& model, Stepper stepper, Engine engine, int steps) {
  const JointVector exact = end_state(model, Stepper::kRungeKutta4, engine, 16 * 1024);
  const double coarse = (end_state(model, stepper, engine, steps) - exact).norm();
  const double fine = (end_state(model, stepper, engine, 2 * steps) - exact).norm();
  return std::log2(coarse / fine);
}

TEST(FrictionStepped, KeepsTheOrderOfEachRuleUnderFriction) {
  RobotModel model = first_joints(3);
  model.chain.rotor_inertia.setConstant(0.1);
  model.chain.viscous_friction.setConstant(0.5);
  model.chain.coulomb_friction.setConstant(0.4);
  for (const Engine engine : kBothEngines) {
    EXPECT_NEAR(order(model, Stepper::kSemiImplicitEuler, engine, 512), 1.0, 0.1) << name(engine);
    EXPECT_NEAR(order(model, Stepper::kMidpoint, engine, 256), 2.0, 0.1) << name(engine);
    EXPECT_NEAR(order(model, Stepper::kRungeKutta4, engine, 64), 4.0, 0.2) << name(engine);
  }
}

// h slope / inertia is from 1/8 to 2: friction is integrated implicitly, and the motion is resolved.
TEST(FrictionStepped, IsOfSecondOrderWhereItIsImplicit) {
  const RobotModel viscous = flywheel(0.1, 2.0, 0.0);
  const RobotModel both = flywheel(0.1, 2.0, 0.2);
  for (const Engine engine : kBothEngines) {
    EXPECT_NEAR(order(viscous, Stepper::kMidpoint, engine, 8), 2.0, 0.1) << name(engine);
    EXPECT_NEAR(order(viscous, Stepper::kRungeKutta4, engine, 8), 2.0, 0.1) << name(engine);
    EXPECT_NEAR(order(both, Stepper::kMidpoint, engine, 8), 2.0, 0.3) << name(engine);
    EXPECT_GT(order(both, Stepper::kRungeKutta4, engine, 8), 1.7) << name(engine);
    EXPECT_GT(order(both, Stepper::kSemiImplicitEuler, engine, 8), 0.9) << name(engine);
  }
}

TEST(FrictionStepped, IsTheSameToRoundingInBothEngines) {
  std::mt19937 generator(903);
  for (RobotModel model : {light_wrist(), test::seven_joint_arm(), test::random_arm(6, 7, true)}) {
    if (model.n() > 3) {
      model.chain.rotor_inertia.setConstant(1e-3);
      model.chain.viscous_friction *= 10.0;
      model.chain.coulomb_friction *= 10.0;
    }
    const JointVector q = test::random_configuration(generator, model);
    const JointVector qd = test::random_vector(generator, model.n(), 1.0);
    const JointVector torque = test::random_vector(generator, model.n(), 5.0);
    for (const Stepper stepper : kStiffSteppers) {
      const auto simbody = make_plant(model, stepper, Engine::kSimbody);
      const auto native = make_plant(model, stepper, Engine::kNative);
      for (Plant* plant : {simbody.get(), native.get()}) {
        plant->set_state(q, qd);
        for (int k = 0; k < 100; ++k) plant->step(torque, 0.002);
      }
      // As NativePlant.StepsAsSimbodyDoesWithEveryStepper.
      EXPECT_LT((native->q() - simbody->q()).norm(), 1e-11) << model.name << ", " << name(stepper);
      EXPECT_LT((native->qd() - simbody->qd()).norm(), 1e-9) << model.name << ", " << name(stepper);
      EXPECT_GT((native->q() - q).norm(), 1e-4) << "it moved";
    }
  }
}

/// q of the light wrist's last joint every 2 ms under slow torques that turn round, so that every joint comes
/// to rest and breaks loose again and again. A torque is held for 2 ms and takes `steps` steps.
std::vector<double> wrist_path(Stepper stepper, Engine engine, int steps) {
  const auto plant = make_plant(light_wrist(), stepper, engine);
  JointVector q(3);
  q << 0.3, 0.4, -0.2;
  plant->set_state(q, JointVector::Zero(3));
  std::vector<double> path;
  for (int k = 0; k < 500; ++k) {
    const double s = std::sin(2.0 * M_PI * 0.002 * k);
    JointVector torque(3);
    torque << 2.0 * s, 1.0 * s, 1.5 * s;
    for (int i = 0; i < steps; ++i) plant->step(torque, 0.002 / steps);
    path.push_back(plant->q()[2]);
  }
  return path;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

TEST(FrictionStepped, ALightWristMovesAsUnderTheReferenceStepper) {
  const std::vector<double> exact = wrist_path(Stepper::kReference, Engine::kSimbody, 1);
  const auto [lowest, highest] = std::minmax_element(exact.begin(), exact.end());
  const double moved = *highest - *lowest;
  EXPECT_GT(moved, 0.05);
  for (const Engine engine : kBothEngines) {
    for (const Stepper stepper : kStiffSteppers) {
      const std::string where = fmt::format("{} {}", name(engine), name(stepper));
      const double coarse = largest_difference(wrist_path(stepper, engine, 1), exact);
      const double fine = largest_difference(wrist_path(stepper, engine, 8), exact);
      RecordProperty(where, fmt::format("{:.2g} rad, {:.2g} rad with an eighth of the step", coarse, fine));
      // Where the joint breaks loose it is late by a few steps, each of them 140 times its time constant.
      EXPECT_LT(coarse, 0.05 * moved) << where;
      EXPECT_LT(fine, 0.25 * coarse) << where;
    }
  }
}

/// A step of a rule without any care for friction, from the plant's own accelerations.
JointVector explicit_end(const RobotModel& model, Engine engine, Stepper stepper, JointVector q,
                         JointVector qd, const JointVector& torque) {
  const auto instant = make_plant(model, stepper, engine);
  StepWorkspace work;
  for (int k = 0; k < 50; ++k) {
    integrate(
        stepper, 0.002,
        [&](const JointVector& x, const JointVector& v, JointVector& a) {
          instant->accelerations(x, v, torque, a);
        },
        q, qd, work);
  }
  return q;
}

TEST(FrictionStepped, IsTheExplicitRuleToTheBitWhereFrictionIsNotStiff) {
  std::mt19937 generator(904);
  for (RobotModel model : test::all_arms()) {
    for (const double factor : {0.0, 1e-3}) {
      model.chain.viscous_friction.setConstant(factor);
      model.chain.coulomb_friction.setConstant(factor);
      const JointVector q = test::random_configuration(generator, model);
      const JointVector qd = test::random_vector(generator, model.n(), 1.0);
      const JointVector torque = test::random_vector(generator, model.n(), 5.0);
      for (const Engine engine : kBothEngines) {
        for (const Stepper stepper : kStiffSteppers) {
          const auto plant = make_plant(model, stepper, engine);
          plant->set_state(q, qd);
          for (int k = 0; k < 50; ++k) plant->step(torque, 0.002);
          EXPECT_EQ(plant->q(), explicit_end(model, engine, stepper, q, qd, torque))
              << model.name << ", " << name(engine) << ", " << name(stepper);
        }
      }
    }
  }
}

}  // namespace friction_step_test
}  // namespace armtune::internal
