// Measures Orocos KDL.

#include <kdl/config.h>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainfdsolver_recursive_newton_euler.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/chainjnttojacdotsolver.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl_parser/kdl_parser.hpp>

#include <memory>
#include <stdexcept>

#include "peer.hpp"

namespace {

constexpr auto kN = static_cast<unsigned>(peers::kJoints);

void check(int result, const char* what) {
  if (result < 0) throw std::runtime_error(std::string(what) + " failed");
}

void set(KDL::JntArray& v, const std::array<double, kN>& from) {
  for (unsigned i = 0; i < kN; ++i) v(i) = from[i];
}

void add(const KDL::JntArray& v, std::vector<double>& out) {
  for (unsigned i = 0; i < kN; ++i) out.push_back(v(i));
}

/// A chain, and KDL's solvers for it, which keep their work space.
struct Arm {
  KDL::Chain chain;
  KDL::Vector gravity{0.0, 0.0, -9.81};
  KDL::ChainFkSolverPos_recursive poses;
  KDL::ChainJntToJacSolver jacobian;
  KDL::ChainJntToJacDotSolver jacobian_derivative;
  KDL::ChainIdSolver_RNE inverse;
  KDL::ChainFdSolver_RNE forward;
  KDL::ChainDynParam parameters;
  KDL::Wrenches none;
  KDL::JntArray q{kN}, qd{kN}, qdd{kN}, tau{kN};
  KDL::JntArrayVel q_qd{kN};
  KDL::Frame tool;
  KDL::Jacobian J{kN}, J_dot{kN};
  KDL::JntSpaceInertiaMatrix M{static_cast<int>(kN)};

  explicit Arm(KDL::Chain c)
      : chain(std::move(c)),
        poses(chain),
        jacobian(chain),
        jacobian_derivative(chain),
        inverse(chain, gravity),
        forward(chain, gravity),
        parameters(chain, gravity),
        none(chain.getNrOfSegments(), KDL::Wrench::Zero()) {
    jacobian_derivative.setHybridRepresentation();
  }
};

KDL::Chain chain_of(const std::string& urdf) {
  KDL::Tree tree;
  if (!kdl_parser::treeFromFile(urdf, tree)) throw std::runtime_error("cannot read " + urdf);
  KDL::Chain chain;
  if (!tree.getChain("base_link", "tool0", chain)) throw std::runtime_error("no chain base_link .. tool0");
  return chain;
}

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(chain_of(urdf));
  Arm& a = *arm;
  const auto accelerate = [&a](const peers::State& s) {
    set(a.q, s.q);
    set(a.qd, s.qd);
    set(a.tau, s.tau);
    check(a.forward.CartToJnt(a.q, a.qd, a.tau, a.none, a.qdd), "forward dynamics");
  };
  return {"KDL",
          KDL_VERSION_STRING,
          {{"forward_kinematics",
            [arm, &a](const peers::State& s) {
              set(a.q, s.q);
              check(a.poses.JntToCart(a.q, a.tool), "forward kinematics");
            },
            [&a](std::vector<double>& out) {
              for (int i = 0; i < 3; ++i) out.push_back(a.tool.p(i));
              for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) out.push_back(a.tool.M(i, j));
              }
            }},
           {"jacobian",
            [&a](const peers::State& s) {
              set(a.q_qd.q, s.q);
              set(a.q_qd.qdot, s.qd);
              check(a.jacobian.JntToJac(a.q_qd.q, a.J), "Jacobian");
              check(a.jacobian_derivative.JntToJacDot(a.q_qd, a.J_dot), "its derivative");
            },
            [&a](std::vector<double>& out) {
              for (unsigned i = 0; i < 6; ++i) {
                for (unsigned j = 0; j < kN; ++j) out.push_back(a.J(i, j));
              }
              const Eigen::VectorXd bias = a.J_dot.data * a.q_qd.qdot.data;
              out.insert(out.end(), bias.begin(), bias.end());
            }},
           {"inverse_dynamics",
            [&a](const peers::State& s) {
              set(a.q, s.q);
              set(a.qd, s.qd);
              set(a.qdd, s.qdd);
              check(a.inverse.CartToJnt(a.q, a.qd, a.qdd, a.none, a.tau), "inverse dynamics");
            },
            [&a](std::vector<double>& out) { add(a.tau, out); }},
           {"mass_matrix",
            [&a](const peers::State& s) {
              set(a.q, s.q);
              check(a.parameters.JntToMass(a.q, a.M), "mass matrix");
            },
            [&a](std::vector<double>& out) {
              for (unsigned i = 0; i < kN; ++i) {
                for (unsigned j = 0; j < kN; ++j) out.push_back(a.M(i, j));
              }
            }},
           {"forward_dynamics", accelerate, [&a](std::vector<double>& out) { add(a.qdd, out); }},
           {"step",
            [&a, accelerate](const peers::State& s) {
              accelerate(s);
              a.qd.data += a.qdd.data * peers::kStep;
              a.q.data += a.qd.data * peers::kStep;
            },
            [&a](std::vector<double>& out) {
              add(a.q, out);
              add(a.qd, out);
            }}}};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
