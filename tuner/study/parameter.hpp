#pragma once
// The search space of a study: which gains are tuned, between which bounds and on which scale.

#include <string>
#include <vector>

#include "core/control/gain_fields.hpp"

namespace armtune::internal {

enum class Scale { kLog, kLinear };

/// One number of one gain field.
struct GainEntry {
  const GainField* field = nullptr;
  std::size_t component = 0;
  std::size_t count = 0;  ///< number of numbers that the field has
  std::string name;       ///< "task_space_gains_p/rx", "slerpDurationErrorGain"
};

/// Returns all numbers that a gain set of an arm with these joints has, in the order of its controller's
/// fields. The fields must outlive the entries.
std::vector<GainEntry> gain_entries(const Gains& gains, const std::vector<std::string>& joints);

/// True if a name stands for the entry: the entry's own, or that of a gain or of a force point that the entry
/// is a part of ("task_space_gains_p", "force_control_gains/elbow_joint").
bool is_named(const GainEntry& entry, const std::string& name);

/// True if a gain set has that number. Fields that a file may leave out can be empty, and those of forces
/// have two forms (core/control/force_gains.hpp).
bool has(const Gains& gains, const GainEntry& entry);
double& value(Gains& gains, const GainEntry& entry);
double value(const Gains& gains, const GainEntry& entry);

struct Parameter {
  GainEntry entry;
  double start = 0.0;
  double lower = 0.0;
  double upper = 0.0;
  Scale scale = Scale::kLog;
};

/// True if a value lies on one of the parameter's bounds, but for rounding.
bool on_bound(const Parameter& parameter, double value);

/// A gain that follows a tuned parameter: its value is factor * the parameter's value.
struct Link {
  GainEntry entry;
  std::size_t parameter = 0;  ///< index into ParameterSpace::free
  double factor = 1.0;
};

struct ParameterSpace {
  Gains start;  ///< with fixed values already in place
  std::vector<Parameter> free;
  std::vector<Link> links;

  /// Returns the search coordinates of the start: one per free parameter, 0 at its lower and 1 at its upper
  /// bound.
  std::vector<double> start_point() const;
  /// Returns the gains at search coordinates, which are clamped to [0, 1].
  Gains gains_at(const std::vector<double>& x) const;
  /// Returns the search coordinates of gains, clamped to the bounds.
  std::vector<double> point_of(const Gains& gains) const;
};

/// Throws InputError, with `where` in front, if there is no parameter, or for the first parameter whose
/// bounds do not make a range, whose start lies outside them, or whose scale does not fit.
void validate(const ParameterSpace& space, const std::string& where);

}  // namespace armtune::internal
