#pragma once
// A low-pass filter for the motion from which the adaptive law computes its regressor Y. q', qr' and qr''
// pass the first-order filter
//   x <- x + (1 - exp(-2 pi f T)) (measured - x),
// with the corner frequency f and the control period T. It is needed because noise of the measured velocities
// is in both Y and S, which makes theta drift (adaptation.hpp). If this noise is white, Y contains hardly any
// of it after the filter, while S still has all of it. The mean of their product is multiplied by
// 1 - exp(-2 pi f T), which is 0.06 at 5 Hz and 2 ms.

#include <cmath>
#include <type_traits>

#include "core/robot/slotine_li.hpp"

namespace armtune::internal {

/// Returns the share of the difference that the filter takes in each period. corner [Hz]; period [s].
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

  /// Computes the smoothed motion at the measured poses.
  void motion(const ChainT<T>& chain, const PosesT<T>& poses, SlotineLiT<T>& along) const {
    slotine_li_forward(chain, poses, qd_, qdr_, qddr_, along);
  }

  /// Resets the filter of one arm to rest. lane: the arm's place in T.
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
