#include "tuner/derivatives/perturbed_copies.hpp"

#include <cmath>

namespace armtune::internal {

std::vector<PerturbedCopy> perturbed_copies(const ParameterSpace& space, const std::vector<double>& x,
                                            const DerivativeOptions& options) {
  std::vector<PerturbedCopy> copies;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (const bool second : {false, true}) {
      if (second && !options.two_steps) continue;
      const double h = second ? 2.0 * options.step : options.step;
      const bool up = x[i] + 2.0 * options.step <= 1.0;  // the same direction for both steps
      std::vector<double> there = x;
      there[i] += up ? h : -h;
      // The difference of the rounded coordinates is the exact step.
      copies.push_back({static_cast<int>(i), second, there[i] - x[i], space.gains_at(there)});
    }
  }
  return copies;
}

Eigen::VectorXd coordinates_per_gain(const ParameterSpace& space, const std::vector<double>& x) {
  Eigen::VectorXd per_gain(static_cast<Eigen::Index>(x.size()));
  const Gains gains = space.gains_at(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Parameter& p = space.free[i];
    per_gain[static_cast<Eigen::Index>(i)] = p.scale == Scale::kLog
                                                 ? 1.0 / (value(gains, p.entry) * std::log(p.upper / p.lower))
                                                 : 1.0 / (p.upper - p.lower);
  }
  return per_gain;
}

}  // namespace armtune::internal
