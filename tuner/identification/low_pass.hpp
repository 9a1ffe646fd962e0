#pragma once
// A zero-phase low-pass filter with derivatives: a symmetric FIR kernel, which is a sinc under a
// Blackman-Harris window, and the kernel's own analytic derivatives. Since the kernel is of finite length, a
// signal that is filtered block by block gives the same numbers as a signal that is filtered as a whole.
// Harris, On the use of windows for harmonic analysis with the discrete Fourier transform, 1978.

#include <Eigen/Core>

namespace armtune::internal {

/// The weights of the samples -half .. half around an instant.
struct LowPass {
  int half = 0;
  Eigen::VectorXd value;   ///< sums to 1
  Eigen::VectorXd first;   ///< first derivative [1/s]: exact on quadratic signals
  Eigen::VectorXd second;  ///< second derivative [1/s^2]: exact on cubic signals

  int length() const { return 2 * half + 1; }
};

/// Returns a filter that passes half of the amplitude at `cutoff` [Hz]. Up to half of the cutoff its gain is
/// 1 within 1e-4, and from 1.5 times the cutoff on it is below 1e-4. cutoff: at most 0.3 / period. period:
/// time between samples [s]. delay [s]: the result at time t is the filtered signal at t - delay; |delay| is
/// at most a tenth of the kernel's half length.
LowPass low_pass(double cutoff, double period, double delay = 0.0);

/// Returns the half length of the kernel [s].
double low_pass_half_length(double cutoff);

}  // namespace armtune::internal
