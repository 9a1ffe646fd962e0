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
  std::size_t count = 0;  ///< number of components of the field
  std::string name;       ///< such as "task_space_gains_p/rx" or "slerpDurationErrorGain"
};

/// Returns an entry for every number in a gain set, in the order of its controller's fields. joints: the
/// joints of the arm. The fields must outlive the entries.
std::vector<GainEntry> gain_entries(const Gains& gains, const std::vector<std::string>& joints);

/// True if the name denotes the entry. This is the entry's own name, or the name of a group that contains the
/// entry. A group is a gain ("task_space_gains_p") or a force point ("force_control_gains/elbow_joint").
bool is_named(const GainEntry& entry, const std::string& name);

/// True if a gain set has the number of the entry. The number may be missing, because a file can leave some
/// fields out, and because the gains of forces have two forms (core/control/force_gains.hpp).
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

/// True if a value lies on one of the parameter's bounds, within rounding.
bool on_bound(const Parameter& parameter, double value);

/// A gain that is not tuned itself. Its value is `factor` times the value of a tuned parameter.
struct Link {
  GainEntry entry;
  std::size_t parameter = 0;  ///< index into ParameterSpace::free
  double factor = 1.0;
};

struct ParameterSpace {
  Gains start;                  ///< start gains, with the fixed values
  std::vector<Parameter> free;  ///< tuned parameters
  std::vector<Link> links;

  /// Returns the search coordinates of the start gains. There is one coordinate per tuned parameter. It is 0
  /// at the lower bound and 1 at the upper bound of the parameter, and linear in between on the parameter's
  /// scale.
  std::vector<double> start_point() const;
  /// Returns the gains at search coordinates. Coordinates outside [0, 1] are clamped to this range.
  Gains gains_at(const std::vector<double>& x) const;
  /// Returns the search coordinates of gains. Values outside the bounds are clamped to them.
  std::vector<double> point_of(const Gains& gains) const;
};

/// Throws InputError, with `where` in front, if there is no tuned parameter, or if a tuned parameter is not
/// valid. Its lower bound must be below its upper bound, and not negative. Its start value must lie between
/// the bounds. On a log scale, the lower bound must be above zero, and the ratio of the bounds at most 1e30.
void validate(const ParameterSpace& space, const std::string& where);

}  // namespace armtune::internal
