#pragma once
// Declares every gain of the controllers: name, unit, valid range, search range and meaning. Gains that only
// one kind of controller has are declared with that kind, in the same form
// (core/control/laws/controller_kind.hpp).

#include <limits>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/control/gains.hpp"

namespace armtune::internal {

/// The range in which a gain is searched if the study (the file that describes a search) gives none.
enum class SearchRange {
  kNone,    ///< not tuned unless the study names it
  kFactor,  ///< lower_factor .. upper_factor times the start value, on a log scale
  /// For a stiffness: lower_factor times the start value .. a bound that the user gives, on a log scale. It
  /// is not tuned without this bound, because the suitable stiffness depends on contacts, which are not
  /// simulated.
  kBounded,
  /// For Ki: 0 .. Kp^2/4, on a linear scale, with the Kp of the same axis. With a larger Ki, the error e of
  /// e'' + Kp e' + Ki e = 0 oscillates.
  kCriticalDamping
};

/// How a gain changes when the gain of the whole control loop is multiplied by a factor. This is how the gain
/// margin is found.
enum class LoopGain : unsigned char {
  kNone,    ///< the gain is unchanged
  kFactor,  ///< the gain is multiplied by the factor
  kRoot     ///< the gain is multiplied by the factor's square root, which suits a damping ratio
};

/// The number of values of a gain that only one kind of controller has: one, six for the task (x y z rx ry
/// rz), or one per joint.
enum class GainShape { kScalar, kTask, kJoints };

/// A gain that only one kind of controller has, stored in Gains::own[place].
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
  bool required = true;            ///< must be in a gains file; if false, joint vectors may be empty
  bool strictly_positive = false;  ///< otherwise values must be >= 0 (the joint goal: any)
  SearchRange search = SearchRange::kNone;
  /// Bounds for kFactor, as factors on the start value.
  double lower_factor = 0.2;
  double upper_factor = 5.0;
  /// Values must be below this.
  double below = std::numeric_limits<double>::infinity();
  /// True if the gain belongs to a control law: only controllers that name it in ControllerKind::uses have
  /// it. Gains of states, references and limits belong to every controller.
  bool of_law = false;
  LoopGain loop = LoopGain::kNone;
  /// Default of each value, for gains that only one kind of controller has, if a gains file gives none.
  double otherwise = 0.0;

  bool is_number() const { return member.index() <= 4; }
};

/// Returns the fields of the members of Gains, in the order of gains files. For the gains of one controller
/// see fields_of (core/control/laws/controller_kind.hpp).
const std::vector<GainField>& gain_fields();

/// Returns the values of a field: 1, 6, n or, for ForceGains, n or n x n values. The result is empty for
/// switches and choices (bool, SlerpReference).
std::span<double> numbers(Gains& gains, const GainField& field);
std::span<const double> numbers(const Gains& gains, const GainField& field);

/// Returns the number of values of a field of this shape on an arm of n joints.
Eigen::Index size_of(GainShape shape, int n);

/// Returns the names of a field's values: "" for a scalar, "x".."rz" for six, joint names for joint vectors.
std::vector<std::string> component_names(const GainField& field, const std::vector<std::string>& joints);
/// Returns the names of the values that the field has in `gains`. They differ from the names above only if
/// force_control_gains has one value per force point and joint. The names are then "point/joint", where both
/// parts are joint names.
std::vector<std::string> component_names(const Gains& gains, const GainField& field,
                                         const std::vector<std::string>& joints);

}  // namespace armtune::internal
