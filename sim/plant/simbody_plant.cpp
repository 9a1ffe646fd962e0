// Simulates the arm by Simbody. No other file of the libraries includes Simbody. This file is compiled as
// C++17, with NDEBUG only if Simbody was (cmake/Simbody.cmake says why).

#include <functional>  // Simbody's headers use it without including it

#include <Simbody.h>

#include <Eigen/Cholesky>

#include <stdexcept>

#include "armtune/error.hpp"
#include "core/robot/dynamics.hpp"
#include "sim/plant/stepped_plant.hpp"

namespace armtune::internal {
namespace {

SimTK::Vec3 to_simbody(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

SimTK::Rotation to_simbody(const Mat3& R) {
  return SimTK::Rotation(
      SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)), true);
}

SimTK::MassProperties to_simbody(const LinkInertia& link) {
  const Mat3& I = link.inertia;
  return {link.mass, to_simbody(Vec3(link.first_moment / link.mass)),
          SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))};
}

/// Computes the torque minus friction, for every evaluation of the accelerations. With Coulomb friction that
/// stays constant over a period, the simulation would diverge.
void net_torque(const Chain& chain, const JointVector& qd, const JointVector& torque, JointVector& net) {
  net.resize(chain.n);
  for (int i = 0; i < chain.n; ++i) {
    net[i] =
        torque[i] - chain.viscous_friction[i] * qd[i] - chain.coulomb_friction[i] * coulomb_direction(qd[i]);
  }
}

/// The links as a Simbody tree. Simbody has no rotor inertia, so the users of the tree add it.
class Tree {
 public:
  explicit Tree(const Chain& chain)
      : matter_(system_), forces_(system_), gravity_(forces_, matter_, to_simbody(chain.gravity)) {
    SimTK::MobilizedBody parent = matter_.Ground();
    for (int i = 0; i < chain.n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const SimTK::Body::Rigid body(to_simbody(chain.link[k]));
      const SimTK::Transform X_PB0(to_simbody(chain.R_PB0[k]), to_simbody(chain.p_PB0[k]));
      if (chain.motion[k] == JointMotion::kRevolute) {
        parent = SimTK::MobilizedBody::Pin(parent, X_PB0, body, SimTK::Transform());
      } else {
        // Simbody's slider moves along x, armtune's prismatic joint along z: a turn by -pi/2 about y. The
        // constructor from angle and axis is not used. It writes through a view of a row (Row<3, double, 3>)
        // that extends beyond the matrix, and g++ with sanitizers reports this as an access out of bounds.
        const SimTK::Mat33 R(0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 0.0);
        const SimTK::Transform x_to_z(SimTK::Rotation(R, true));
        parent = SimTK::MobilizedBody::Slider(parent, X_PB0 * x_to_z, body, x_to_z);
      }
    }
  }

  SimTK::MultibodySystem& system() { return system_; }
  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }
  SimTK::GeneralForceSubsystem& forces() { return forces_; }

 private:
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::Force::Gravity gravity_;
};

/// Adds rotor inertia D and friction over a step, which Simbody lacks. Simbody gives q0'' = M^-1 (tau - h).
/// The result is q'' = (M + D + A)^-1 (M q0'' + a), with the inertia A and the force a that friction adds.
class JointInertia {
 public:
  explicit JointInertia(const Chain& chain)
      : chain_(chain),
        rotors_(!chain.rotor_inertia.isZero(0.0)),
        friction_(!chain.viscous_friction.isZero(0.0) || !chain.coulomb_friction.isZero(0.0)) {}

  /// friction: null for the acceleration at an instant, without a step.
  void correct(const JointVector& q, const JointVector& qd, const FrictionStep<double>* friction,
               JointVector& qdd) {
    const bool over_a_step = friction != nullptr && friction_;
    if (!rotors_ && !over_a_step) return;
    forward_kinematics(chain_, q, poses_);
    mass_matrix(chain_, poses_, M_);
    rhs_.noalias() = M_ * qdd;
    M_.diagonal() += chain_.rotor_inertia;
    if (over_a_step) add(*friction, qd);
    qdd = rhs_;
    llt_.compute(M_);
    llt_.solveInPlace(qdd);
  }

 private:
  /// Adds the terms of friction to M_ and rhs_. They depend on the inertia that each joint moves while the
  /// joints after it are free. Elimination from the last joint to the first gives this inertia.
  void add(const FrictionStep<double>& friction, const JointVector& qd) {
    rest_ = M_;
    for (Eigen::Index k = chain_.n - 1; k >= 0; --k) {
      const AddedByFriction<double> added = friction.added(chain_, k, qd[k], rest_(k, k));
      M_(k, k) += added.inertia;
      rhs_[k] += added.force;
      const double pivot = rest_(k, k) + added.inertia;
      for (Eigen::Index i = 0; i < k; ++i) {
        const double share = rest_(i, k) / pivot;
        for (Eigen::Index j = 0; j <= i; ++j) rest_(j, i) -= share * rest_(j, k);
      }
    }
  }

  const Chain& chain_;
  bool rotors_, friction_;
  Poses poses_;
  JointMatrix M_, rest_;
  JointVector rhs_;
  Eigen::LLT<JointMatrix> llt_;
};

/// Simulates the arm with accelerations from Simbody and armtune's own steppers. This is the fastest correct
/// way to use Simbody.
class SimbodyPlant final : public SteppedPlant {
 public:
  SimbodyPlant(const RobotModel& model, Stepper stepper)
      : SteppedPlant(model.n(), stepper),
        chain_(model.chain),
        tree_(chain_),
        joint_torque_(tree_.forces(), tree_.matter()),
        inertia_(chain_),
        torque_vector_(chain_.n, 0.0) {
    state_ = tree_.system().realizeTopology();
    tree_.system().realizeModel(state_);
  }

  void accelerations(const JointVector& q, const JointVector& qd, const JointVector& torque,
                     JointVector& qdd) override {
    accelerate(q, qd, torque, nullptr, qdd);
  }

 protected:
  void evaluate(const Poses* /*poses*/, const JointVector& q, const JointVector& qd,
                const JointVector& torque, const FrictionStep<double>& friction, JointVector& qdd) override {
    accelerate(q, qd, torque, &friction, qdd);
  }

 private:
  void accelerate(const JointVector& q, const JointVector& qd, const JointVector& torque,
                  const FrictionStep<double>* friction, JointVector& qdd) {
    net_torque(chain_, qd, torque, net_);
    SimTK::Vector& state_q = state_.updQ();
    SimTK::Vector& state_u = state_.updU();
    for (int i = 0; i < chain_.n; ++i) {
      state_q[i] = q[i];
      state_u[i] = qd[i];
      torque_vector_[i] = net_[i];
    }
    joint_torque_.setAllMobilityForces(state_, torque_vector_);
    tree_.system().realize(state_, SimTK::Stage::Acceleration);
    const SimTK::Vector& udot = state_.getUDot();
    qdd.resize(chain_.n);
    for (int i = 0; i < chain_.n; ++i) qdd[i] = udot[i];
    inertia_.correct(q, qd, friction, qdd);
  }

  Chain chain_;
  Tree tree_;
  SimTK::Force::DiscreteForces joint_torque_;
  JointInertia inertia_;
  SimTK::State state_;
  SimTK::Vector torque_vector_;
  JointVector net_;
};

/// A force element with joint torque, friction and the rotors' inertial torque -D q''. With it, Simbody's own
/// integrators simulate the whole arm. q'' comes from core's dynamics.
class DriveForce final : public SimTK::Force::Custom::Implementation {
 public:
  explicit DriveForce(const Chain& chain) : chain_(chain), torque(JointVector::Zero(chain.n)) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>&, SimTK::Vector_<SimTK::Vec3>&,
                 SimTK::Vector& mobility_forces) const override {
    const int n = chain_.n;
    JointVector q(n), qd(n), net, bias, qdd;
    for (int i = 0; i < n; ++i) {
      q[i] = state.getQ()[i];
      qd[i] = state.getU()[i];
    }
    net_torque(chain_, qd, torque, net);
    Chain links = chain_;  // without friction, which `net` contains
    links.viscous_friction.setZero();
    links.coulomb_friction.setZero();
    Poses poses;
    JointMatrix M;
    forward_kinematics(links, q, poses);
    inverse_dynamics(links, poses, qd, JointVector(JointVector::Zero(n)), bias);
    mass_matrix(links, poses, M);
    M.diagonal() += chain_.rotor_inertia;
    qdd = M.llt().solve(net - bias);
    for (int i = 0; i < n; ++i) mobility_forces[i] += net[i] - chain_.rotor_inertia[i] * qdd[i];
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0.0; }

 private:
  Chain chain_;

 public:
  JointVector torque;
};

/// Limit for one control period. With a motion that chatters, the error control would otherwise never end.
constexpr int kMostReferenceSteps = 20000;

/// The reference plant. It uses Simbody's error-controlled Runge-Kutta-Merson integrator, restarted in every
/// control period because the torque jumps there.
class SimbodyReferencePlant final : public Plant {
 public:
  explicit SimbodyReferencePlant(const RobotModel& model)
      : instant_(model, Stepper::kMidpoint),
        tree_(model.chain),
        drive_(new DriveForce(model.chain)),
        force_(tree_.forces(), drive_),
        integrator_(tree_.system()) {  // force_ owns drive_
    state_ = tree_.system().realizeTopology();
    tree_.system().realizeModel(state_);
    integrator_.setAccuracy(1e-10);
    integrator_.setAllowInterpolation(false);
    integrator_.setReturnEveryInternalStep(true);  // so that the steps can be counted
    set_state(JointVector::Zero(model.n()), JointVector::Zero(model.n()));
  }

  void set_state(const JointVector& q, const JointVector& qd) override {
    q_ = q;
    qd_ = qd;
  }
  const JointVector& q() const override { return q_; }
  const JointVector& qd() const override { return qd_; }

  void accelerations(const JointVector& q, const JointVector& qd, const JointVector& torque,
                     JointVector& qdd) override {
    instant_.accelerations(q, qd, torque, qdd);
  }

 private:
  void advance(const JointVector& torque, double dt, const Poses* /*poses*/) override {
    drive_->torque = torque;
    state_.setTime(0.0);
    for (int i = 0; i < q_.size(); ++i) {
      state_.updQ()[i] = q_[i];
      state_.updU()[i] = qd_[i];
    }
    integrator_.setFinalTime(dt);
    integrator_.initialize(state_);
    // The first stepTo after initialize() returns without having moved.
    for (int steps = 0; integrator_.getTime() < dt; ++steps) {
      if (steps > kMostReferenceSteps) throw FailedError("the reference integrator needed too many steps");
      integrator_.stepTo(dt);
    }
    const SimTK::State& end = integrator_.getState();
    for (int i = 0; i < q_.size(); ++i) {
      q_[i] = end.getQ()[i];
      qd_[i] = end.getU()[i];
    }
  }

  SimbodyPlant instant_;
  Tree tree_;
  DriveForce* drive_;
  SimTK::Force::Custom force_;
  SimTK::RungeKuttaMersonIntegrator integrator_;
  SimTK::State state_;
  JointVector q_, qd_;
};

}  // namespace

std::unique_ptr<Plant> make_simbody_plant(const RobotModel& model, Stepper stepper) {
  try {
    if (stepper == Stepper::kReference) return std::make_unique<SimbodyReferencePlant>(model);
    return std::make_unique<SimbodyPlant>(model, stepper);
  } catch (const std::exception& e) {
    throw InputError(InputPlace{model.source}, std::string("Simbody cannot simulate this arm: ") + e.what());
  }
}

}  // namespace armtune::internal
