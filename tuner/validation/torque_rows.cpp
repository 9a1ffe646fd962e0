#include "tuner/validation/torque_rows.hpp"

#include "core/robot/dynamics.hpp"
#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

Eigen::MatrixXd torque_columns(const RobotModel& model, const FilteredMotion& motion) {
  const Chain& chain = model.chain;
  const int n = chain.n;
  Eigen::MatrixXd columns(n, static_cast<int>(kTorqueColumns));
  Poses poses;
  forward_kinematics(chain, motion.q, poses);
  JointVector torque;
  inverse_dynamics(chain, poses, motion.qd, motion.qdd, torque);
  columns.col(kMeasuredTorque) = motion.torque;
  columns.col(kPredictedTorque) = torque;
  gravity_torque(chain, poses, torque);
  columns.col(kGravityTorque) = torque;
  columns.col(kJointVelocity) = motion.qd;
  columns.col(kJointAcceleration) = motion.qdd;
  coulomb_directions(motion.qd, torque);
  columns.col(kCoulombDirection) = torque;

  // A payload adds to the parameters of the last link, in which the torque is linear: mass and first moment.
  SlotineLi along;
  Regressor Y;
  slotine_li_forward(chain, poses, motion.qd, motion.qd, motion.qdd, along);
  slotine_li_regressor(chain, poses, along, Y);
  columns.middleCols<4>(kPayloadMass) = Y.middleCols<4>((n - 1) * kLinkParameters);

  // The torque is linear in gravity: without motion and with unit gravity it is its derivative.
  Chain unit = chain;
  for (int axis = 0; axis < 3; ++axis) {
    unit.gravity = Vec3::Unit(axis);
    gravity_torque(unit, poses, torque);
    columns.col(kGravityX + axis) = torque;
  }
  return columns;
}

TorqueRows torque_rows(const RobotModel& model, const LoggedMotion& motion) {
  const Eigen::Index n = model.n();
  const Eigen::Index size = n * (kTorqueColumns + 1);
  std::vector<Eigen::VectorXd> filtered;
  TorqueRows rows;
  for (const MotionStretch& stretch : motion.stretches) {
    ParallelFilter filter(model.n(), false, stretch.sample_period, motion.cutoff, 0.0, size);
    if (rows.period == 0.0) rows.period = filter.row_period();
    const auto count = static_cast<Eigen::Index>(stretch.instants.size());
    WideTorques wide{stretch.begin, stretch.period, {}, {}, {}, {}};
    for (Eigen::MatrixXd* x : {&wide.measured, &wide.predicted, &wide.qd, &wide.qdd}) x->resize(count, n);
    for (Eigen::Index i = 0; i < count; ++i) {
      const FilteredMotion& at = stretch.instants[static_cast<std::size_t>(i)];
      const Eigen::MatrixXd columns = torque_columns(model, at);
      wide.measured.row(i) = columns.col(kMeasuredTorque);
      wide.predicted.row(i) = columns.col(kPredictedTorque);
      wide.qd.row(i) = at.qd;
      wide.qdd.row(i) = at.qdd;
      Eigen::VectorXd all(size);
      all << columns.reshaped(), at.q;
      if (!filter.push_columns(all)) continue;
      filtered.push_back(filter.columns());
      rows.time.push_back(stretch.begin + static_cast<double>(i - filter.second_half()) * stretch.period);
    }
    rows.wide.push_back(std::move(wide));
  }
  rows.joint.assign(static_cast<std::size_t>(n),
                    Eigen::MatrixXd(rows.count(), static_cast<int>(kTorqueColumns)));
  for (Eigen::Index i = 0; i < rows.count(); ++i) {
    const Eigen::VectorXd& all = filtered[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      for (int c = 0; c < kTorqueColumns; ++c) rows.joint[static_cast<std::size_t>(j)](i, c) = all[c * n + j];
    }
    rows.q.push_back(all.tail(n));
  }
  return rows;
}

}  // namespace armtune::internal
