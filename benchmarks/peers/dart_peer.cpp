// Measures DART's skeleton alone, without the constraint solver of DART's world.

#include <dart/config.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/utils/urdf/DartLoader.hpp>

#include <memory>
#include <stdexcept>

#include "peer.hpp"

namespace {

struct Arm {
  dart::dynamics::SkeletonPtr skeleton;
  dart::dynamics::BodyNode* tool = nullptr;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  dart::math::Jacobian J, J_dot;
  Eigen::VectorXd q = Eigen::VectorXd::Zero(peers::kJoints);
  Eigen::VectorXd qd = q, qdd = q, tau = q, result = q;
  Eigen::MatrixXd M;

  explicit Arm(const std::string& urdf) {
    dart::utils::DartLoader loader;
    // DART would give links without a mass 1 kg.
    constexpr double kNothing = 1e-15;
    loader.setOptions(dart::utils::DartLoader::Options(
        nullptr, dart::utils::DartLoader::RootJointType::FIXED,
        dart::dynamics::Inertia(kNothing, Eigen::Vector3d::Zero(), kNothing * Eigen::Matrix3d::Identity())));
    skeleton = loader.parseSkeleton(urdf);
    if (!skeleton) throw std::runtime_error("cannot read " + urdf);
    if (skeleton->getNumDofs() != peers::kJoints) throw std::runtime_error("not six joints: " + urdf);
    skeleton->setGravity(Eigen::Vector3d(0.0, 0.0, -9.81));
    tool = skeleton->getBodyNode("tool0");
    if (tool == nullptr) throw std::runtime_error("no tool0");
  }
};

void set(Eigen::VectorXd& v, const std::array<double, peers::kJoints>& from) {
  for (int i = 0; i < peers::kJoints; ++i) v[i] = from[static_cast<std::size_t>(i)];
}

template <typename Derived>
void add_rows(const Eigen::MatrixBase<Derived>& A, std::vector<double>& out) {
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) out.push_back(A(i, j));
  }
}

/// Returns J with linear rows first; in DART's Jacobians angular rows are first.
dart::math::Jacobian linear_first(const dart::math::Jacobian& J) {
  dart::math::Jacobian swapped(6, J.cols());
  swapped.topRows<3>() = J.bottomRows<3>();
  swapped.bottomRows<3>() = J.topRows<3>();
  return swapped;
}

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(urdf);
  Arm& a = *arm;
  const auto accelerate = [&a](const peers::State& s) {
    set(a.q, s.q);
    set(a.qd, s.qd);
    set(a.tau, s.tau);
    a.skeleton->setPositions(a.q);
    a.skeleton->setVelocities(a.qd);
    a.skeleton->setForces(a.tau);
    a.skeleton->computeForwardDynamics();
  };
  return {"DART",
          DART_VERSION,
          {{"forward_kinematics",
            [arm, &a](const peers::State& s) {
              set(a.q, s.q);
              a.skeleton->setPositions(a.q);
              a.pose = a.tool->getWorldTransform();
            },
            [&a](std::vector<double>& out) {
              add_rows(a.pose.translation(), out);
              add_rows(a.pose.linear(), out);
            }},
           {"jacobian",
            [&a](const peers::State& s) {
              set(a.q, s.q);
              set(a.qd, s.qd);
              a.skeleton->setPositions(a.q);
              a.skeleton->setVelocities(a.qd);
              a.J = a.tool->getWorldJacobian();
              a.J_dot = a.tool->getJacobianClassicDeriv();
            },
            [&a](std::vector<double>& out) {
              add_rows(linear_first(a.J), out);
              add_rows(linear_first(a.J_dot) * a.qd, out);
            }},
           {"inverse_dynamics",
            [&a](const peers::State& s) {
              set(a.q, s.q);
              set(a.qd, s.qd);
              set(a.qdd, s.qdd);
              a.skeleton->setPositions(a.q);
              a.skeleton->setVelocities(a.qd);
              a.skeleton->setAccelerations(a.qdd);
              a.skeleton->computeInverseDynamics();
              a.result = a.skeleton->getForces();
            },
            [&a](std::vector<double>& out) { add_rows(a.result, out); }},
           {"mass_matrix",
            [&a](const peers::State& s) {
              set(a.q, s.q);
              a.skeleton->setPositions(a.q);
              a.M = a.skeleton->getMassMatrix();
            },
            [&a](std::vector<double>& out) { add_rows(a.M, out); }},
           {"forward_dynamics",
            [&a, accelerate](const peers::State& s) {
              accelerate(s);
              a.result = a.skeleton->getAccelerations();
            },
            [&a](std::vector<double>& out) { add_rows(a.result, out); }},
           {"step",
            [&a, accelerate](const peers::State& s) {
              accelerate(s);
              a.skeleton->integrateVelocities(peers::kStep);
              a.skeleton->integratePositions(peers::kStep);
            },
            [&a](std::vector<double>& out) {
              add_rows(a.skeleton->getPositions(), out);
              add_rows(a.skeleton->getVelocities(), out);
            }}}};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
