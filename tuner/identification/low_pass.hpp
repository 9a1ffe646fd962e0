#pragma once
// Zero-phase low-pass filter with derivatives: a symmetric FIR kernel, a sinc under a Blackman-Harris window,
// and the kernel's own analytic derivatives. Being of finite length it gives the same numbers block by block
// as on the whole. Harris, On the use of windows for harmonic analysis with the discrete Fourier transform,
// 1978.

#include <Eigen/Core>

namespace armtune::internal {

/// Weights of the samples -half .. half around an instant.
struct LowPass {
  int half = 0;
  Eigen::VectorXd value;   ///< sums to 1
  Eigen::VectorXd first;   ///< first derivative [1/s]: exact on quadratic signals
  Eigen::VectorXd second;  ///< second derivative [1/s^2]: exact on cubic ones

  int length() const { return 2 * half + 1; }
};

/// Half of the amplitude at `cutoff` [Hz], flat within 1e-4 up to half of it, below 1e-4 from one and a half
/// of it. period [s] between samples; cutoff <= 0.3 / period. delay [s]: the filtered signal is that of so
/// much earlier, at most a tenth of the kernel's half length.
LowPass low_pass(double cutoff, double period, double delay = 0.0);

/// Half length of the kernel [s].
double low_pass_half_length(double cutoff);

}  // namespace armtune::internal
