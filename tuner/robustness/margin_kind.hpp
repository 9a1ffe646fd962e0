#pragma once
// Declares the stability margins: which quantity of the control loop is changed, from which value, in which
// direction and how far. The quantities are torque delay, gains, control rate and velocity noise.

#include <array>
#include <cstddef>

#include "core/control/gains.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/robustness/edge_search.hpp"

namespace armtune::internal {

enum class MarginKind : std::size_t { kTorqueDelay, kGainFactor, kControlRate, kVelocityNoise, kCount };

inline constexpr std::size_t kMarginCount = static_cast<std::size_t>(MarginKind::kCount);

struct MarginField {
  const char* name;
  const char* unit;
  const char* meaning;
  /// Returns the scenario's own value of the quantity.
  double (*nominal)(const Scenario& scenario);
  /// Gives scenario and gains another value. The nominal value leaves them unchanged.
  void (*apply)(double value, Scenario& scenario, Gains& gains);
  EdgeSearch search;  ///< nominal is set for each scenario
};

/// Returns the margins in the order of the enumeration, which is also that of margins.csv.
const std::array<MarginField, kMarginCount>& margin_fields();
inline const MarginField& field(MarginKind kind) {
  return margin_fields()[static_cast<std::size_t>(kind)];
}
inline const char* name(MarginKind kind) {
  return field(kind).name;
}

}  // namespace armtune::internal
