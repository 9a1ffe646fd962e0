#pragma once
// Declares the stability margins. Each margin changes one quantity of the control loop: additional torque
// delay, a factor on the gains, the control rate, or the velocity noise. The declaration gives the nominal
// value of the quantity, the direction in which it is changed, and the last value that is tried.

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
  /// Returns the nominal value of the quantity, which leaves the scenario as it is.
  double (*nominal)(const Scenario& scenario);
  /// Changes the scenario or the gains so that the quantity has this value. Nothing changes for the nominal
  /// value. Call it only once for a scenario.
  void (*apply)(double value, Scenario& scenario, Gains& gains);
  EdgeSearch search;  ///< its member `nominal` is set for each scenario
};

/// Returns the margins in the order of the enumeration. This is also their order in margins.csv.
const std::array<MarginField, kMarginCount>& margin_fields();
inline const MarginField& field(MarginKind kind) {
  return margin_fields()[static_cast<std::size_t>(kind)];
}
inline const char* name(MarginKind kind) {
  return field(kind).name;
}

}  // namespace armtune::internal
