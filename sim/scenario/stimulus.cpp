#include "sim/scenario/stimulus.hpp"

#include <cmath>

namespace armtune::internal {
namespace {

double value_at(const Step& step, double t) {
  return reached(t, step.at) ? step.size : 0.0;
}

double value_at(const Multisine& sines, double t) {
  if (!reached(t, sines.from)) return 0.0;
  const double base = 2.0 * M_PI * (t - sines.from) / sines.base_period;
  double sum = 0.0;
  for (std::size_t i = 0; i < sines.orders.size(); ++i)
    sum += std::sin(sines.orders[i] * base + sines.phases[i]);
  return sines.amplitude * sum;
}

}  // namespace

double Stimulus::start() const {
  if (const Step* step = std::get_if<Step>(&shape)) return step->at;
  return std::get<Multisine>(shape).from;
}

double Stimulus::value(double t) const {
  return std::visit([t](const auto& s) { return value_at(s, t); }, shape);
}

std::vector<double> schroeder_phases(const std::vector<int>& orders) {
  // From sine n - 1 to sine n the phase falls by 2 pi (k_n - k_n-1) (n - 1) / N: the gap between their orders
  // times the share of the power in the lower sines. With gaps of one, this is Schroeder's formula.
  std::vector<double> phases(orders.size(), 0.0);
  const auto count = static_cast<double>(orders.size());
  for (std::size_t n = 1; n < orders.size(); ++n) {
    const int gap = orders[n] - orders[n - 1];
    phases[n] = std::remainder(phases[n - 1] - 2.0 * M_PI * gap * static_cast<double>(n) / count, 2.0 * M_PI);
  }
  return phases;
}

}  // namespace armtune::internal
