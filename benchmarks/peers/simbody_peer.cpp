// Measures Simbody, on the same tree of bodies as armtune's Simbody plant makes. Compiled as C++17 without
// NDEBUG, like that plant.

#include <functional>  // Simbody's headers use it without including it

#include <Simbody.h>

#include <memory>

#include "core/robot/urdf_reader.hpp"
#include "peer.hpp"

namespace {

using SimTK::Stage;

constexpr int kN = peers::kJoints;

SimTK::Vec3 to_simbody(const armtune::internal::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

SimTK::Rotation to_simbody(const armtune::internal::Mat3& R) {
  return SimTK::Rotation(
      SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)), true);
}

struct Arm {
  armtune::internal::RobotModel model;
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  SimTK::Force::Gravity gravity;
  SimTK::Force::DiscreteForces torque;
  SimTK::MobilizedBody last;
  SimTK::Transform X_BT;
  SimTK::State state;
  SimTK::Vector known{kN, 0.0}, residual{kN, 0.0}, none{kN, 0.0};
  SimTK::Matrix J, M;
  SimTK::SpatialVec bias;
  SimTK::Transform tool;

  explicit Arm(const std::string& urdf)
      : model(armtune::internal::read_urdf(urdf)),
        gravity(forces, matter, to_simbody(model.chain.gravity)),
        torque(forces, matter),
        X_BT(to_simbody(model.chain.R_BT), to_simbody(model.chain.p_BT)) {
    last = matter.Ground();
    for (std::size_t k = 0; k < kN; ++k) {
      const armtune::internal::LinkInertia& link = model.chain.link[k];
      const armtune::internal::Mat3& I = link.inertia;
      const SimTK::Body::Rigid body(
          SimTK::MassProperties(link.mass, to_simbody(armtune::internal::Vec3(link.first_moment / link.mass)),
                                SimTK::Inertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2))));
      const SimTK::Transform X_PB0(to_simbody(model.chain.R_PB0[k]), to_simbody(model.chain.p_PB0[k]));
      last = SimTK::MobilizedBody::Pin(last, X_PB0, body, SimTK::Transform());
    }
    state = system.realizeTopology();
    system.realizeModel(state);
  }

  void set(const std::array<double, kN>& q) {
    SimTK::Vector& to = state.updQ();
    for (int i = 0; i < kN; ++i) to[i] = q[static_cast<std::size_t>(i)];
  }
  void set(const std::array<double, kN>& q, const std::array<double, kN>& qd) {
    set(q);
    SimTK::Vector& to = state.updU();
    for (int i = 0; i < kN; ++i) to[i] = qd[static_cast<std::size_t>(i)];
  }
  void accelerate(const peers::State& s) {
    set(s.q, s.qd);
    for (int i = 0; i < kN; ++i) known[i] = s.tau[static_cast<std::size_t>(i)];
    torque.setAllMobilityForces(state, known);
    system.realize(state, Stage::Acceleration);
  }
};

void add(const SimTK::Vector& v, std::vector<double>& out) {
  for (int i = 0; i < kN; ++i) out.push_back(v[i]);
}

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(urdf);
  Arm& a = *arm;
  int major = 0;
  int minor = 0;
  int build = 0;
  SimTK_version_simbody(&major, &minor, &build);
  const std::string version =
      std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
  return {"Simbody",
          version,
          {{"forward_kinematics",
            [arm, &a](const peers::State& s) {
              a.set(s.q);
              a.system.realize(a.state, Stage::Position);
              a.tool = a.last.getBodyTransform(a.state) * a.X_BT;
            },
            [&a](std::vector<double>& out) {
              for (int i = 0; i < 3; ++i) out.push_back(a.tool.p()[i]);
              for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) out.push_back(a.tool.R()[i][j]);
              }
            }},
           {"jacobian",
            [&a](const peers::State& s) {
              a.set(s.q, s.qd);
              a.system.realize(a.state, Stage::Velocity);
              a.matter.calcFrameJacobian(a.state, a.last.getMobilizedBodyIndex(), a.X_BT.p(), a.J);
              a.bias = a.matter.calcBiasForFrameJacobian(a.state, a.last.getMobilizedBodyIndex(), a.X_BT.p());
            },
            [&a](std::vector<double>& out) {
              for (const int row : {3, 4, 5, 0, 1, 2}) {
                for (int j = 0; j < kN; ++j) out.push_back(a.J(row, j));
              }
              for (const int part : {1, 0}) {
                for (int i = 0; i < 3; ++i) out.push_back(a.bias[part][i]);
              }
            }},
           {"inverse_dynamics",
            [&a](const peers::State& s) {
              a.set(s.q, s.qd);
              a.system.realize(a.state, Stage::Velocity);
              for (int i = 0; i < kN; ++i) a.known[i] = s.qdd[static_cast<std::size_t>(i)];
              a.matter.calcResidualForceIgnoringConstraints(a.state, a.none, a.gravity.getBodyForces(a.state),
                                                            a.known, a.residual);
            },
            [&a](std::vector<double>& out) { add(a.residual, out); }},
           {"mass_matrix",
            [&a](const peers::State& s) {
              a.set(s.q);
              a.system.realize(a.state, Stage::Position);
              a.matter.calcM(a.state, a.M);
            },
            [&a](std::vector<double>& out) {
              for (int i = 0; i < kN; ++i) {
                for (int j = 0; j < kN; ++j) out.push_back(a.M(i, j));
              }
            }},
           {"forward_dynamics", [&a](const peers::State& s) { a.accelerate(s); },
            [&a](std::vector<double>& out) { add(a.state.getUDot(), out); }},
           {"step",
            [&a](const peers::State& s) {
              a.accelerate(s);
              a.known = a.state.getUDot();
              a.state.updU() += peers::kStep * a.known;
              a.state.updQ() += peers::kStep * a.state.getU();
            },
            [&a](std::vector<double>& out) {
              add(a.state.getQ(), out);
              add(a.state.getU(), out);
            }}}};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
