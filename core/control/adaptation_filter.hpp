#pragma once
// A low-pass filter for the motion from which the adaptive law computes its regressor Y. q', qr' and qr''
// pass the first-order filter
//   x <- x + (1 - exp(-2 pi f T)) (measured - x),
// with the corner frequency f and the control period T. The filter is needed because noise of the measured
// velocities is in both Y and S = q' - qr', which makes the parameters theta drift (adaptation.hpp). If this
// noise is white, the filter removes nearly all of it from Y, while S keeps all of it. The mean product of
// the noise in Y and the noise in S is thereby multiplied by 1 - exp(-2 pi f T). With f = 5 Hz and T = 2 ms,
// this factor is 0.06.

#include <cmath>
#include <type_traits>

#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// Returns the factor 1 - exp(-2 pi f T) of the filter. corner: f [Hz]. period: T [s].
inline double filter_share(double corner, double period) {
  return 1.0 - std::exp(-2.0 * M_PI * corner * period);
}

template <typename T>
class AdaptationFilterT {
 public:
  /// Starts at rest (n joints).
  void start(Eigen::Index n) {
    for (JointVectorT<T>* x : {&qd_, &qdr_, &qddr_}) x->setZero(n);
  }

  /// Filters the measured q' and the references qr', qr'' (n each) of one period.
  void take(const T& share, const JointVectorT<T>& qd, const JointVectorT<T>& qdr,
            const JointVectorT<T>& qddr) {
    for (Eigen::Index i = 0; i < qd_.size(); ++i) {
      qd_[i] += share * (qd[i] - qd_[i]);
      qdr_[i] += share * (qdr[i] - qdr_[i]);
      qddr_[i] += share * (qddr[i] - qddr_[i]);
    }
  }

  /// Computes `along`, the motion of the bodies, from the filtered q', qr' and qr'' at the measured poses.
  void motion(const ChainT<T>& chain, const PosesT<T>& poses, SlotineLiT<T>& along) const {
    slotine_li_forward(chain, poses, qd_, qdr_, qddr_, along);
  }

  /// Resets the filter of one arm to rest. If T is a SIMD type for several arms, lane is the index of the arm
  /// in it; otherwise lane is not used.
  void rest([[maybe_unused]] int lane) {
    for (JointVectorT<T>* x : {&qd_, &qdr_, &qddr_}) {
      for (Eigen::Index i = 0; i < x->size(); ++i) {
        if constexpr (std::is_same_v<T, double>) {
          (*x)[i] = 0.0;
        } else {
          (*x)[i].set(lane, 0.0);
        }
      }
    }
  }

 private:
  JointVectorT<T> qd_, qdr_, qddr_;
};
using AdaptationFilter = AdaptationFilterT<double>;

}  // namespace armtune::internal
