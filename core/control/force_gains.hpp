#pragma once
// The gains k_f with which obstacles repel the arm (equation 9 in NOTATION.md). The repulsion acts on n force
// points, one per joint: the joint's origin or, with links, the point of its link that is nearest to the
// obstacle. The force on point i acts on joint j with the gain k_f,i,j. A gains file has either one number
// per force point, which is used for every joint (k_f,i,j = k_f,i), or a list of n numbers per force point,
// one for each joint.

#include "core/common/types.hpp"

namespace armtune::internal {

/// The values k_f: either n values, one per force point, or n * n values. In the second case, the n values of
/// force point i start at the index i * n.
using ForceGains = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxJoints * kMaxJoints, 1>;

/// True if every force point has a separate gain for each of the n joints.
inline bool is_per_joint(const ForceGains& gains, int n) {
  return n > 1 && gains.size() == Eigen::Index{n} * n;
}

/// Returns k_f,i,j [N] of force point `point` on joint `joint`.
inline double force_gain(const ForceGains& gains, int n, int point, int joint) {
  return gains[is_per_joint(gains, n) ? point * n + joint : point];
}

}  // namespace armtune::internal
