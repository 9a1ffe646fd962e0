#pragma once
// The one declaration of every gain: name, unit, valid range, search range, meaning.

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune {

/// The range a gain is searched in when a study names none.
enum class SearchRange {
  kNone,    ///< not tuned unless a study says so
  kFactor,  ///< lower_factor .. upper_factor times the start, on a log scale
  /// Ki: 0 .. Kp^2/4 of the same axis, on a linear scale. Beyond it e'' + Kp e' + Ki e = 0 would oscillate.
  kCriticalDamping
};

struct GainField {
  const char* name;
  const char* unit;
  const char* meaning;
  std::variant<double Gains::*, Vec6 Gains::*, JointVector Gains::*, bool Gains::*, SlerpReference Gains::*>
      member;
  bool required = true;            ///< must stand in a gains file; joint vectors that need not may be empty
  bool strictly_positive = false;  ///< otherwise numbers must be >= 0 (the joint goal: any)
  SearchRange search = SearchRange::kNone;
  /// Of kFactor: bounds as factors on the start's value.
  double lower_factor = 0.2;
  double upper_factor = 5.0;
  /// Numbers must be below this.
  double below = std::numeric_limits<double>::infinity();

  bool is_number() const { return member.index() <= 2; }
};

/// All fields, in the order files are written.
const std::vector<GainField>& gain_fields();

/// The numbers of a field: 1, 6 or n of them; empty for switches.
std::span<double> numbers(Gains& gains, const GainField& field);
std::span<const double> numbers(const Gains& gains, const GainField& field);

/// Names of a field's numbers: "" for a scalar, "x".."rz" for six, the joints' names for joint vectors.
std::vector<std::string> component_names(const GainField& field, const std::vector<std::string>& joints);

/// Throws InputError naming the gain, its value and the limit; `source` stands in front of the message.
void validate(const Gains& gains, const std::vector<std::string>& joints, const std::string& source);

}  // namespace armtune
