#pragma once
// Says where the rotor inertia in a robot file comes from. A robot YAML marks it as
// `rotor_inertia: {assumed: NUMBERS}`.

namespace armtune::internal {

/// The origins of rotor inertia that is not marked as an estimate (estimated_rotors of RobotModel).
/// kGiven: the file does not say; kAssumed: taken from somebody's model of the arm, and measured by nobody.
enum class RotorSource { kGiven, kMeasured, kPublished, kAssumed };

/// Returns "given", "measured", "published" or "assumed". All but the first are marks in robot files.
constexpr const char* name(RotorSource source) {
  switch (source) {
    case RotorSource::kGiven:
      return "given";
    case RotorSource::kMeasured:
      return "measured";
    case RotorSource::kPublished:
      return "published";
    case RotorSource::kAssumed:
      return "assumed";
  }
  return "";
}

}  // namespace armtune::internal
