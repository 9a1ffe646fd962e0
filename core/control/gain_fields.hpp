#pragma once
// The one declaration of every gain: name, unit, valid range, search range, meaning.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune {

struct GainField {
  const char* name;
  const char* unit;
  const char* meaning;
  std::variant<double Gains::*, Vec6 Gains::*, JointVector Gains::*, bool Gains::*, SlerpReference Gains::*>
      member;
  bool required = true;            ///< must stand in a gains file
  bool strictly_positive = false;  ///< otherwise numbers must be >= 0 (the joint goal: any)
  /// Default search range as factors on the start's value; both zero: not tuned unless a study says so.
  double search_lower_factor = 0.0;
  double search_upper_factor = 0.0;

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
