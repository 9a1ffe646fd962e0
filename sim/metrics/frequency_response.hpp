#pragma once
// The frequency response of a loop at the harmonics of a base period. Each harmonic has its own Fourier sums
// of reference and response.

#include <complex>
#include <vector>

namespace armtune::internal {

class FrequencyResponse {
 public:
  /// orders: cycles per base period, increasing. base_period [s].
  FrequencyResponse(const std::vector<int>& orders, double base_period);

  /// Adds one sample at t [s]. Over whole base periods of evenly spaced samples no order leaks into another.
  /// Allocates nothing.
  void add(double t, double reference, double response);

  /// Returns response over reference at the i-th order, as gain and phase.
  std::complex<double> at(std::size_t i) const { return bins_[i].response / bins_[i].reference; }
  double frequency(std::size_t i) const { return bins_[i].order / base_period_; }  ///< [Hz]

  /// Returns the lowest frequency at which the gain falls 3 dB (1/sqrt(2)) below 1 [Hz], on the straight line
  /// in log-log between two orders. Returns the highest order's frequency if the gain never falls so far, the
  /// lowest order's if it starts below, and NaN without samples.
  double bandwidth() const;

 private:
  struct Bin {
    int order = 0;
    std::complex<double> reference;
    std::complex<double> response;
  };

  double base_period_;
  std::vector<Bin> bins_;
};

}  // namespace armtune::internal
