#pragma once
// The planned joint motion of a control period, in the form in which laws that are templates for one arm or
// several at once receive it (arm_law.hpp).

#include "core/common/select.hpp"
#include "core/common/types.hpp"

namespace armtune::internal {

template <typename T>
struct PlannedJointsT {
  /// n: number of joints.
  explicit PlannedJointsT(int n)
      : position(JointVectorT<T>::Zero(n)),
        velocity(JointVectorT<T>::Zero(n)),
        fed_velocity(JointVectorT<T>::Zero(n)) {}

  MaskT<T> active{};         ///< true in the state followPlan; only then the other members are of this period
  JointVectorT<T> position;  ///< qd (n) [rad, m]
  JointVectorT<T> velocity;  ///< qd' (n)
  JointVectorT<T> fed_velocity;  ///< the velocity (n) for a feed-forward
};
using PlannedJoints = PlannedJointsT<double>;

}  // namespace armtune::internal
