// Measures armtune's own kernels, and whole control periods of closed-loop rollouts.

#include <chrono>
#include <memory>

#include "core/robot/dynamics.hpp"
#include "core/robot/forward_dynamics.hpp"
#include "core/robot/urdf_reader.hpp"
#include "peer.hpp"
#include "sim/lanes/rollout_lanes.hpp"
#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"

namespace {

using namespace armtune::internal;

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

/// Measures control periods in nanoseconds per period and arm, over 8 s of the scenario moving_target:
/// sensors, state machine, controller with adaptation, two accelerations and metrics.
class Periods {
 public:
  Periods() : prepared_(std::make_shared<const PreparedScenario>(eight_seconds())) {
    gains_ = load_gains("published", joint_names(*prepared_->scenario.robot));
  }

  double alone() const {
    return timed(1, [this] { Rollout(prepared_, Stepper::kMidpoint, Engine::kNative).run(gains_); });
  }
  double side_by_side(Processor processor) const {
    const int arms = most_lanes(processor);
    return timed(arms, [&] {
      RolloutLanes lanes(lane_kind(prepared_->scenario, Stepper::kMidpoint, 0), arms, processor);
      for (int lane = 0; lane < arms; ++lane) lanes.start(lane, {prepared_, gains_});
      while (lanes.busy() > 0) lanes.step([](int, RolloutResult&&) {});
    });
  }

 private:
  static Scenario eight_seconds() {
    Scenario scenario = load_scenario("moving_target");
    scenario.duration = 8.0;
    return scenario;
  }
  template <typename Work>
  double timed(int arms, Work&& work) const {
    const auto began = std::chrono::steady_clock::now();
    work();
    const auto taken = std::chrono::steady_clock::now() - began;
    return std::chrono::duration<double, std::nano>(taken).count() / (arms * prepared_->scenario.periods());
  }

  std::shared_ptr<const PreparedScenario> prepared_;
  Gains gains_;
};

std::vector<peers::Period> periods() {
  const auto work = std::make_shared<Periods>();
  std::vector<peers::Period> all = {{"period_alone", [work] { return work->alone(); }},
                                    {"period_any", [work] { return work->side_by_side(Processor::kAny); }}};
  if (best_processor() >= Processor::kAvx2) {
    all.push_back({"period_avx2", [work] { return work->side_by_side(Processor::kAvx2); }});
  }
  if (best_processor() >= Processor::kAvx512) {
    all.push_back({"period_avx512", [work] { return work->side_by_side(Processor::kAvx512); }});
  }
  return all;
}

peers::Peer load(const std::string& urdf) {
  const auto arm = std::make_shared<Arm>(urdf);
  Arm& a = *arm;
  const auto accelerate = [&a](const peers::State& s) {
    Arm::set(a.q, s.q);
    Arm::set(a.qd, s.qd);
    Arm::set(a.tau, s.tau);
    body_poses(a.model.chain, a.q, a.poses);
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
            }}},
          periods()};
}

}  // namespace

int main(int argc, char** argv) {
  return peers::peer_main(argc, argv, load);
}
