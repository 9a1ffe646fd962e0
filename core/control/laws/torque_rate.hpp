#pragma once
// Limits how fast commanded torques change, as the example controllers for Franka's arms do. The code is a
// template for one arm or several at once (arm_law.hpp).

#include "core/common/types.hpp"
#include "core/control/laws/lane_access.hpp"

namespace armtune::internal {

template <typename T>
class TorqueRateT : LaneAccessT<T> {
 public:
  /// n: number of joints.
  explicit TorqueRateT(int n) : last_(JointVectorT<T>::Zero(n)) {}

  /// rate: largest change per second [N m/s, N/s]; 0: no limit. The first command is limited as if the one
  /// before had been 0.
  void start(int lane, double rate) {
    this->put(lane, rate, rate_);
    for (Eigen::Index i = 0; i < last_.size(); ++i) this->put(lane, 0.0, last_[i]);
  }

  /// Changes the command (n) so that no entry differs from that of the last command by more than rate times
  /// the control period dt [s]. exempt: true for arms whose command is not limited in this period.
  void limit(const T& dt, JointVectorT<T>& command, const MaskT<T>& exempt = MaskT<T>{}) {
    const MaskT<T> limits = this->both(rate_ > T(0.0), this->no(exempt));
    const T most = rate_ * dt;
    for (Eigen::Index i = 0; i < command.size(); ++i) {
      const T change = command[i] - last_[i];
      command[i] = select(limits, last_[i] + this->clamped(change, -most, most), command[i]);
      last_[i] = command[i];
    }
  }

 private:
  T rate_{0.0};
  JointVectorT<T> last_;
};

}  // namespace armtune::internal
