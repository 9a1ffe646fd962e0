#pragma once
// Computes sine and cosine of all joint angles of an arm. For doubles, two angles are computed at a time
// (vector_math.hpp).

#include <cmath>

#include "core/common/types.hpp"
#include "core/common/vector_math.hpp"

namespace armtune::internal {

/// Computes sin and cos of every entry of x (n), one by one.
template <typename T>
void each_sine_and_cosine(const JointVectorT<T>& x, JointVectorT<T>& sines, JointVectorT<T>& cosines) {
  using std::cos;
  using std::sin;
  sines.resize(x.size());
  cosines.resize(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    sines[i] = sin(x[i]);
    cosines[i] = cos(x[i]);
  }
}

/// Computes sin and cos of every entry of x (n). The version for doubles computes two entries at a time. If
/// an entry is beyond kLargestAngle, it computes all entries one by one.
template <typename T>
void sines_and_cosines(const JointVectorT<T>& x, JointVectorT<T>& sines, JointVectorT<T>& cosines) {
  each_sine_and_cosine(x, sines, cosines);
}
inline void sines_and_cosines(const JointVector& x, JointVector& sines, JointVector& cosines) {
  const Eigen::Index n = x.size();
  if (!(x.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= vector_math::kLargestAngle))
    return each_sine_and_cosine(x, sines, cosines);
  sines.resize(n);
  cosines.resize(n);
  for (Eigen::Index i = 0; i < n; i += 2) {
    const bool two = i + 1 < n;
    vector_math::Double2 s;
    vector_math::Double2 c;
    vector_math::sine_cosine(vector_math::Double2{x[i], two ? x[i + 1] : 0.0}, s, c);
    sines[i] = s[0];
    cosines[i] = c[0];
    if (!two) break;
    sines[i + 1] = s[1];
    cosines[i + 1] = c[1];
  }
}

/// Computes sin and cos of one angle.
inline void sine_and_cosine(double x, double& sine, double& cosine) {
  if (!(std::abs(x) <= vector_math::kLargestAngle)) {
    sine = std::sin(x);
    cosine = std::cos(x);
    return;
  }
  vector_math::Double2 s;
  vector_math::Double2 c;
  vector_math::sine_cosine(vector_math::Double2{x, x}, s, c);
  sine = s[0];
  cosine = c[0];
}

}  // namespace armtune::internal
