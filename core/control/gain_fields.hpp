#pragma once
// The one declaration of every gain: name, unit, valid range, search range, meaning. Those of a controller's
// own are declared with it, in the same words (core/control/laws/controller_kind.hpp).

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

/// The range a gain is searched in when a study names none.
enum class SearchRange {
  kNone,    ///< not tuned unless a study says so
  kFactor,  ///< lower_factor .. upper_factor times the start, on a log scale
  /// Ki: 0 .. Kp^2/4 of the same axis, on a linear scale. Beyond it e'' + Kp e' + Ki e = 0 would oscillate.
  kCriticalDamping
};

/// How many numbers a controller's own gain has: one, six of the task (x y z rx ry rz), or one per joint.
enum class GainShape { kScalar, kTask, kJoints };

/// A controller's own gain: Gains::own[place].
struct OwnGain {
  GainShape shape = GainShape::kScalar;
  std::size_t place = 0;
};

struct GainField {
  const char* name;
  const char* unit;
  const char* meaning;
  std::variant<double Gains::*, Vec6 Gains::*, JointVector Gains::*, ForceGains Gains::*, OwnGain,
               bool Gains::*, SlerpReference Gains::*>
      member;
  bool required = true;            ///< must stand in a gains file; joint vectors that need not may be empty
  bool strictly_positive = false;  ///< otherwise numbers must be >= 0 (the joint goal: any)
  SearchRange search = SearchRange::kNone;
  /// Of kFactor: bounds as factors on the start's value.
  double lower_factor = 0.2;
  double upper_factor = 5.0;
  /// Numbers must be below this.
  double below = std::numeric_limits<double>::infinity();
  /// Not of states, references and limits, which every controller has: only controllers that name it have it.
  bool of_law = false;
  /// A factor on it is one on the loop's gain.
  bool in_loop = false;
  /// Of an own gain: each of its numbers where a gains file has none.
  double otherwise = 0.0;

  bool is_number() const { return member.index() <= 4; }
};

/// The members of Gains, in the order files are written. What one controller has: fields_of
/// (core/control/laws/controller_kind.hpp).
const std::vector<GainField>& gain_fields();

/// The numbers of a field: 1, 6, n or n x n (ForceGains) of them; empty for switches.
std::span<double> numbers(Gains& gains, const GainField& field);
std::span<const double> numbers(const Gains& gains, const GainField& field);

/// How many numbers a field of this shape has on an arm of n joints.
Eigen::Index size_of(GainShape shape, int n);

/// Names of a field's numbers: "" for a scalar, "x".."rz" for six, the joints' names for joint vectors.
std::vector<std::string> component_names(const GainField& field, const std::vector<std::string>& joints);
/// The same of the numbers that `gains` have: where a force point has a gain for each joint, these are called
/// "point/joint", by the names of both joints.
std::vector<std::string> component_names(const Gains& gains, const GainField& field,
                                         const std::vector<std::string>& joints);

}  // namespace armtune::internal
