#pragma once
// Says where the rotor inertia and the friction in a robot file come from. A robot YAML states this by a
// mark, for example `rotor_inertia: {assumed: NUMBERS}`.

#include <array>

namespace armtune::internal {

/// The origins of values. kGiven: the file does not say where the value comes from; kAssumed: taken from
/// somebody's model of the arm, and measured by nobody; kEstimated: a guess.
enum class ValueSource { kGiven, kMeasured, kPublished, kAssumed, kEstimated };

/// The origins that robot files can state by a mark.
inline constexpr std::array kMarkedSources{ValueSource::kMeasured, ValueSource::kPublished,
                                           ValueSource::kAssumed, ValueSource::kEstimated};

/// Returns "given" or the mark.
constexpr const char* name(ValueSource source) {
  switch (source) {
    case ValueSource::kGiven:
      return "given";
    case ValueSource::kMeasured:
      return "measured";
    case ValueSource::kPublished:
      return "published";
    case ValueSource::kAssumed:
      return "assumed";
    case ValueSource::kEstimated:
      return "estimated";
  }
  return "";
}

}  // namespace armtune::internal
