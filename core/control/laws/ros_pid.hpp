#pragma once
// The PID of one joint as in ROS's control_toolbox: branch `humble` (3.7) and branch `jazzy` (4.11, of 6 May
// 2026), with all kinds of anti-windup that a controller's parameter file can choose, and limits of the
// output.

#include <cmath>
#include <limits>

#include "core/control/laws/lane_access.hpp"

namespace armtune::internal {

enum class AntiWindup {
  /// The integral grows without bound; its contribution is clamped. This is what humble and ROS 1 do with
  /// `antiwindup: false`, their default.
  kOfContribution,
  /// The integral is clamped before it is used. This is what humble and ROS 1 do with `antiwindup: true`, and
  /// Jazzy with `legacy`.
  kOfIntegral,
  /// Jazzy's `none`: the integral is used unchanged, then it grows, then it is clamped.
  kNone,
  /// Jazzy's `conditional_integration`: as kNone, but the integral stops while the output is saturated and
  /// the error has the sign of the output.
  kConditional,
  /// Jazzy's `back_calculation`: as kNone, but the part that saturation cuts off is subtracted from the
  /// integral at the rate 1/tracking_time.
  kBackCalculation
};

struct RosPidGains {
  double p = 0.0;                                           ///< [output / error]
  double i = 0.0;                                           ///< [output / (error s)]
  double d = 0.0;                                           ///< [output s / error]
  double i_max = std::numeric_limits<double>::infinity();   ///< upper bound of the integral's contribution
  double i_min = -std::numeric_limits<double>::infinity();  ///< lower bound of the contribution, below i_max
  double u_max = std::numeric_limits<double>::infinity();   ///< upper bound of the output; Jazzy only
  double u_min = -std::numeric_limits<double>::infinity();
  AntiWindup anti_windup = AntiWindup::kOfIntegral;
  double tracking_time = 0.0;  ///< for kBackCalculation [s]; 0: sqrt(d / i), or p / i if d is 0
  double deadband = 0.0;       ///< errors up to this leave the integral unchanged
};

/// The PID of one joint, as a template for one arm or several at once (arm_law.hpp). Each arm has gains of
/// its own.
template <typename T>
class RosPidT : LaneAccessT<T> {
 public:
  /// Sets the gains of an arm, and its integral to 0.
  void start(int lane, const RosPidGains& gains) {
    this->put(lane, 0.0, integral_);
    this->put(lane, gains.p, p_);
    this->put(lane, gains.i, i_);
    this->put(lane, gains.d, d_);
    this->put(lane, gains.i_max, i_max_);
    this->put(lane, gains.i_min, i_min_);
    this->put(lane, gains.u_max, u_max_);
    this->put(lane, gains.u_min, u_min_);
    this->put(lane, gains.deadband, deadband_);
    const bool of_integral = gains.anti_windup == AntiWindup::kOfIntegral;
    const bool returns = gains.anti_windup == AntiWindup::kBackCalculation && gains.i != 0.0;
    this->mark(lane, of_integral, of_integral_);
    this->mark(lane, of_integral || gains.anti_windup == AntiWindup::kOfContribution, before_use_);
    this->mark(lane, gains.anti_windup == AntiWindup::kConditional, conditional_);
    this->mark(lane, returns, returns_);
    this->put(lane, returns ? tracking_time(gains) : 1.0, tracking_time_);
  }

  /// Computes the output for an error (desired - measured) and its rate. dt: time since the last call, > 0
  /// [s]. error, error_rate and dt must be finite.
  T output(const T& error, const T& error_rate, const T& dt) {
    using std::abs;
    const MaskT<T> integrates = abs(error) > deadband_;
    const T grown = integral_ + i_ * dt * error;
    const T stopped = select(of_integral_, this->clamped(grown, i_min_, i_max_), grown);
    const T before = select(integrates, stopped, integral_);
    const T used = select(before_use_, this->clamped(before, i_min_, i_max_), integral_);

    const T wanted = p_ * error + used + d_ * error_rate;
    const T given = this->clamped(wanted, u_min_, u_max_);
    if (all(before_use_)) {
      integral_ = before;
      return given;
    }

    const MaskT<T> saturated = abs(wanted - given) > T(kNothing);
    const MaskT<T> same_sign = error * wanted > T(0.0);
    const MaskT<T> rests = this->both(conditional_, this->both(saturated, same_sign));
    const T returned = select(returns_, grown + dt / tracking_time_ * (given - wanted), grown);
    const T after = select(this->both(integrates, this->no(rests)), returned, integral_);
    integral_ = select(before_use_, before, this->clamped(after, i_min_, i_max_));
    return given;
  }

  /// Returns the integral's contribution, before kOfContribution clamps it.
  const T& integral() const { return integral_; }

 private:
  static constexpr double kNothing = std::numeric_limits<double>::epsilon();

  static double tracking_time(const RosPidGains& gains) {
    if (gains.tracking_time > kNothing) return gains.tracking_time;
    return gains.d > kNothing ? std::sqrt(gains.d / gains.i) : gains.p / gains.i;
  }

  T p_{0.0}, i_{0.0}, d_{0.0};
  T i_max_{0.0}, i_min_{0.0}, u_max_{0.0}, u_min_{0.0};
  T deadband_{0.0};
  T tracking_time_{1.0};
  MaskT<T> of_integral_{};  ///< kOfIntegral
  MaskT<T> before_use_{};   ///< the integral grows before it is used: kOfIntegral, kOfContribution
  MaskT<T> conditional_{};  ///< kConditional
  MaskT<T> returns_{};      ///< kBackCalculation of a PID that integrates
  T integral_{0.0};
};
using RosPid = RosPidT<double>;

}  // namespace armtune::internal
