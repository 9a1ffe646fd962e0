#pragma once
// The PID of one joint as in ROS's control_toolbox: branch `humble` (3.7) and branch `jazzy` (4.11, of 6 May
// 2026), with all kinds of anti-windup that a controller's parameter file can choose, and limits of the
// output.

#include <algorithm>
#include <cmath>
#include <limits>

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

class RosPid {
 public:
  /// Computes the output for an error (desired - measured) and its rate. dt: time since the last call, > 0
  /// [s]. error, error_rate and dt must be finite.
  double output(const RosPidGains& gains, double error, double error_rate, double dt) {
    const bool integrates = std::abs(error) > gains.deadband;
    const double grown = integral_ + gains.i * dt * error;
    double used = integral_;
    if (integrates && gains.anti_windup == AntiWindup::kOfContribution) integral_ = grown;
    if (integrates && gains.anti_windup == AntiWindup::kOfIntegral)
      integral_ = std::clamp(grown, gains.i_min, gains.i_max);
    if (before_use(gains.anti_windup)) used = std::clamp(integral_, gains.i_min, gains.i_max);

    const double wanted = gains.p * error + used + gains.d * error_rate;
    const double given = std::clamp(wanted, gains.u_min, gains.u_max);
    if (before_use(gains.anti_windup)) return given;

    const bool saturated = std::abs(wanted - given) > kNothing;
    const bool rests = gains.anti_windup == AntiWindup::kConditional && saturated && error * wanted > 0.0;
    if (integrates && !rests) {
      integral_ = grown;
      if (gains.anti_windup == AntiWindup::kBackCalculation && gains.i != 0.0)
        integral_ += dt / tracking_time(gains) * (given - wanted);
    }
    integral_ = std::clamp(integral_, gains.i_min, gains.i_max);
    return given;
  }

  /// Returns the integral's contribution, before kOfContribution clamps it.
  double integral() const { return integral_; }

 private:
  static constexpr double kNothing = std::numeric_limits<double>::epsilon();

  static bool before_use(AntiWindup kind) {
    return kind == AntiWindup::kOfContribution || kind == AntiWindup::kOfIntegral;
  }
  static double tracking_time(const RosPidGains& gains) {
    if (gains.tracking_time > kNothing) return gains.tracking_time;
    return gains.d > kNothing ? std::sqrt(gains.d / gains.i) : gains.p / gains.i;
  }

  double integral_ = 0.0;
};

}  // namespace armtune::internal
