#pragma once
// Frequency response at the harmonics of a base period, by one-bin Fourier sums of reference and response.

#include <complex>
#include <vector>

namespace armtune::internal {

class FrequencyResponse {
 public:
  /// orders: cycles per base period, increasing. base_period [s].
  FrequencyResponse(const std::vector<int>& orders, double base_period);

  /// One sample at t [s]. Over whole base periods of evenly spaced samples no order leaks into another.
  /// Allocates nothing.
  void add(double t, double reference, double response);

  /// Response over reference at the i-th order: gain and phase.
  std::complex<double> at(std::size_t i) const { return bins_[i].response / bins_[i].reference; }
  double frequency(std::size_t i) const { return bins_[i].order / base_period_; }  ///< [Hz]

  /// Where the gain first falls 3 dB (1/sqrt(2)) below 1, the lowest frequency being first [Hz]: on the
  /// straight line in log-log between two orders. The highest order's frequency if it never falls so far,
  /// the lowest's if it starts below; NaN without samples.
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
