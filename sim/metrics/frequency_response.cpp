#include "sim/metrics/frequency_response.hpp"

#include <cmath>

namespace armtune::internal {

FrequencyResponse::FrequencyResponse(const std::vector<int>& orders, double base_period)
    : base_period_(base_period) {
  bins_.reserve(orders.size());
  for (const int order : orders) bins_.push_back({order, {}, {}});
}

void FrequencyResponse::add(double t, double reference, double response) {
  const double base = -2.0 * M_PI * t / base_period_;
  for (Bin& bin : bins_) {
    const std::complex<double> wave = std::polar(1.0, bin.order * base);
    bin.reference += reference * wave;
    bin.response += response * wave;
  }
}

double FrequencyResponse::bandwidth() const {
  const double half_power = std::log(std::sqrt(0.5));
  double last = 0.0;
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const double gain = std::log(std::abs(at(i)));
    if (std::isnan(gain)) return NAN;
    if (gain < half_power) {
      if (i == 0) return frequency(0);
      const double share = (half_power - last) / (gain - last);
      return frequency(i - 1) * std::pow(frequency(i) / frequency(i - 1), share);
    }
    last = gain;
  }
  return bins_.empty() ? NAN : frequency(bins_.size() - 1);
}

}  // namespace armtune::internal
