// armtune's own kernels.

#include <memory>

#include "core/robot/dynamics.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/urdf_reader.hpp"
#include "peer.hpp"

namespace {

using namespace armtune;

struct Arm {
  RobotModel model;
  Poses poses;
  Jacobian J, J_dot;
  JointMatrix M;
  ForwardDynamics work;
  JointVector q, qd, qdd, tau, bias;

  explicit Arm(const std::string& urdf) : model(read_urdf(urdf)) {
    for (JointVector* v : {&q, &qd, &qdd, &tau}) v->setZero(peers::kJoints);
  }

  static void set(JointVector& v, const std::array<double, peers::kJoints>& from) {
    for (int i = 0; i < peers::kJoints; ++i) v[i] = from[static_cast<std::size_t>(i)];
  }
  template <typename Derived>
  static void add_rows(const Eigen::MatrixBase<Derived>& A, std::vector<double>& out) {
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
      for (Eigen::Index j = 0; j < A.cols(); ++j) out.push_back(A(i, j));
    }
  }
};

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(urdf);
  Arm& a = *arm;
  const auto accelerate = [&a](const peers::State& s) {
    Arm::set(a.q, s.q);
    Arm::set(a.qd, s.qd);
    Arm::set(a.tau, s.tau);
    relative_poses(a.model.chain, a.q, a.poses);
    forward_dynamics(a.model.chain, a.poses, a.qd, a.tau, a.work, a.qdd);
  };
  return {"armtune",
          ARMTUNE_VERSION,
          {{"forward_kinematics",
            [arm, &a](const peers::State& s) {
              Arm::set(a.q, s.q);
              forward_kinematics(a.model.chain, a.q, a.poses);
            },
            [&a](std::vector<double>& out) {
              Arm::add_rows(a.poses.p_0T, out);
              Arm::add_rows(a.poses.R_0T, out);
            }},
           {"jacobian",
            [&a](const peers::State& s) {
              Arm::set(a.q, s.q);
              Arm::set(a.qd, s.qd);
              forward_kinematics(a.model.chain, a.q, a.poses);
              tool_jacobian(a.model.chain, a.poses, a.J);
              tool_jacobian_derivative(a.model.chain, a.poses, a.J, a.qd, a.J_dot);
            },
            [&a](std::vector<double>& out) {
              Arm::add_rows(a.J, out);
              Arm::add_rows(a.J_dot * a.qd, out);
            }},
           {"inverse_dynamics",
            [&a](const peers::State& s) {
              Arm::set(a.q, s.q);
              Arm::set(a.qd, s.qd);
              Arm::set(a.qdd, s.qdd);
              relative_poses(a.model.chain, a.q, a.poses);
              inverse_dynamics(a.model.chain, a.poses, a.qd, a.qdd, a.tau);
            },
            [&a](std::vector<double>& out) { Arm::add_rows(a.tau, out); }},
           {"mass_matrix",
            [&a](const peers::State& s) {
              Arm::set(a.q, s.q);
              relative_poses(a.model.chain, a.q, a.poses);
              mass_matrix(a.model.chain, a.poses, a.M);
            },
            [&a](std::vector<double>& out) { Arm::add_rows(a.M, out); }},
           {"forward_dynamics", accelerate, [&a](std::vector<double>& out) { Arm::add_rows(a.qdd, out); }},
           {"step",
            [&a, accelerate](const peers::State& s) {
              accelerate(s);
              a.qd += a.qdd * peers::kStep;
              a.q += a.qd * peers::kStep;
            },
            [&a](std::vector<double>& out) {
              Arm::add_rows(a.q, out);
              Arm::add_rows(a.qd, out);
            }}}};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
