#pragma once
// Computes the frequency response of a control loop at the harmonics of a base frequency. The order of a
// harmonic is its number of cycles in one base period. Each harmonic has its own Fourier sums of reference
// and response.

#include <complex>
#include <vector>

namespace armtune::internal {

class FrequencyResponse {
 public:
  /// orders: the orders of the harmonics, increasing. base_period [s].
  FrequencyResponse(const std::vector<int>& orders, double base_period);

  /// Adds one sample at t [s]. If the samples are evenly spaced in time and cover whole base periods, the
  /// harmonics do not influence each other's sums. Allocates nothing.
  void add(double t, double reference, double response);

  /// Returns the response divided by the reference at the i-th order. Its absolute value is the gain, its
  /// argument the phase.
  std::complex<double> at(std::size_t i) const { return bins_[i].response / bins_[i].reference; }
  double frequency(std::size_t i) const { return bins_[i].order / base_period_; }  ///< [Hz]

  /// Returns the lowest frequency [Hz] at which the gain falls to 1/sqrt(2), that is, by 3 dB. Between two
  /// orders the gain is interpolated by a straight line in logarithmic scales. If the gain never falls to
  /// this value, returns the frequency of the highest order. If the gain is already lower at the lowest
  /// order, returns the frequency of that order. Returns NaN without samples.
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
