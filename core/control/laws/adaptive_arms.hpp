#pragma once
// The arithmetic of the adaptive law (equations 5 and 6), for one arm or for several side by side:
//   tau = Y theta - Kd S,   theta <- theta - gamma Y^T S dt,   S = q' - qr'.
// Source of the options: core/control/adaptation.hpp and adaptation_filter.hpp.

#include <type_traits>

#include "core/control/adaptation.hpp"
#include "core/control/adaptation_filter.hpp"
#include "core/control/gains.hpp"
#include "core/control/joint_space_law.hpp"

namespace armtune::internal {

template <typename T>
struct AdaptiveRatesT {
  T gamma{0.0};            ///< adaptation_gain
  T leakage{0.0};          ///< [1/s]
  T inertia_leakage{0.0};  ///< the same in addition, of inertias [1/s]
  T filter_share{0.0};     ///< of the adaptation's filter (see filter_share); 0: none
};

template <typename T>
class AdaptiveArmsT {
 public:
  using Joints = JointVectorT<T>;

  /// Arms of n joints; theta (13 n).
  AdaptiveArmsT(Eigen::Index n, const ParameterVectorT<T>& theta) : adaptation_(theta) { filter_.start(n); }

  const AdaptiveRatesT<T>& rates() const { return rates_; }
  void set_rates(const AdaptiveRatesT<T>& rates) {
    rates_ = rates;
    filters_ = rates_.filter_share > T(0.0);
    leaks_ = any(rates_.leakage + rates_.inertia_leakage > T(0.0));
  }
  AdaptationT<T>& adaptation() { return adaptation_; }
  const AdaptationT<T>& adaptation() const { return adaptation_; }
  AdaptationFilterT<T>& filter() { return filter_; }
  /// Y of the last period's q', qr', qr''.
  const SlotineLiT<T>& motion() const { return motion_; }

  /// Sets tau (n) from the measured poses and q', the references and Kd (n each).
  void torque(const ChainT<T>& chain, const PosesT<T>& poses, const Joints& qd,
              const JointReferenceT<T>& reference, const Joints& Kd, Joints& tau) {
    slotine_li_forward(chain, poses, qd, reference.velocity, reference.acceleration, motion_);
    slotine_li_torque(chain, poses, motion_, adaptation_.theta(), tau);
    for (Eigen::Index i = 0; i < tau.size(); ++i) tau[i] -= Kd[i] * (qd[i] - reference.velocity[i]);
    if (any(filters_)) filter_.take(rates_.filter_share, qd, reference.velocity, reference.acceleration);
  }

  /// theta learns from the period of the last torque(), dt [s], in the arms `where`.
  void adapt(const ChainT<T>& chain, const PosesT<T>& poses, const T& dt, const MaskT<T>& where) {
    if (!any(where)) return;
    const MaskT<T> filtered = both(where, filters_);
    if (any(filtered)) {
      filter_.motion(chain, poses, smoothed_);
      adaptation_.step(smoothed_, motion_, rates_.gamma, dt, filtered);
    }
    const MaskT<T> unfiltered = but_not(where, filters_);
    if (any(unfiltered)) adaptation_.step(motion_, motion_, rates_.gamma, dt, unfiltered);
    if (leaks_) adaptation_.leak(rates_.leakage, rates_.inertia_leakage, dt, where);
  }

 private:
  static MaskT<T> both(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a && b;
    } else {
      return a & b;
    }
  }
  static MaskT<T> but_not(const MaskT<T>& a, const MaskT<T>& b) {
    if constexpr (std::is_same_v<MaskT<T>, bool>) {
      return a && !b;
    } else {
      return a & ~b;
    }
  }

  AdaptiveRatesT<T> rates_;
  MaskT<T> filters_{};
  bool leaks_ = false;
  AdaptationT<T> adaptation_;
  AdaptationFilterT<T> filter_;
  SlotineLiT<T> motion_, smoothed_;
};
using AdaptiveRates = AdaptiveRatesT<double>;
using AdaptiveArm = AdaptiveArmsT<double>;

/// The rates that gains ask for, with control periods of `period` [s].
inline AdaptiveRates adaptive_rates(const Gains& gains, double period) {
  return {gains.adaptation_gain, gains.adaptation_leakage, gains.adaptation_inertia_leakage,
          gains.adaptation_filter > 0.0 ? filter_share(gains.adaptation_filter, period) : 0.0};
}

}  // namespace armtune::internal
