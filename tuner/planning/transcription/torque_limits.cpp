#include <memory>

#include "core/robot/dynamics.hpp"
#include "core/robot/inverse_dynamics_derivatives.hpp"
#include "tuner/planning/transcription/term_parts.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {

KnotTerm torque_limits(const RobotModel& robot, KnotRange knots, double margin) {
  KnotTerm term = over(knots, kept_words::kTorque, joint_names(robot));
  term.kind = LimitKind::kTorque;
  term.on_velocity = term.on_acceleration = true;
  term.lower = -1.0;
  term.upper = 1.0;
  struct Work {
    Chain chain;
    JointVector per;
    JointVector tau;
    InverseDynamicsDerivatives derivatives;
  };
  auto work =
      std::make_shared<Work>(Work{robot.chain, (margin * robot.effort_limits()).cwiseInverse(), {}, {}});
  term.units = units_by_motion(robot, "N m", "N");
  term.natural = [limits = Eigen::VectorXd(margin * robot.effort_limits())](std::size_t row, double value) {
    return limits[static_cast<Eigen::Index>(row)] * value;
  };
  term.evaluate = [work](const Knot& knot, const KnotRows& out) {
    const int n = work->chain.n;
    Eigen::Map<Eigen::VectorXd> value(out.value, n);
    if (out.by_q == nullptr) {
      inverse_dynamics(work->chain, knot.poses, knot.qd, knot.qdd, work->tau);
      value = work->per.cwiseProduct(work->tau);
      return;
    }
    const InverseDynamicsDerivatives& torque = work->derivatives;
    inverse_dynamics_derivatives(work->chain, knot.poses, knot.qd, knot.qdd, work->derivatives);
    value = work->per.cwiseProduct(torque.tau);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        out.by_q[i * out.columns + j] = work->per[i] * torque.by_q(i, j);
        out.by_qd[i * out.columns + j] = work->per[i] * torque.by_qd(i, j);
        out.by_qdd[i * out.columns + j] = work->per[i] * torque.by_qdd(i, j);
      }
    }
  };
  return term;
}

}  // namespace armtune::internal
