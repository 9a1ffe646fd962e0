#pragma once
// Decides when a rollout counts as hopeless, because it breaks a constraint by far. A search then abandons
// the rollout to save time. This is only possible for a metric that cannot become better later in the
// rollout.

#include <optional>
#include <string>

#include "sim/metrics/metric.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

struct Hopeless {
  enum class Kind {
    kAuto,   ///< a rollout is abandoned at the value of default_hopeless(), if there is one
    kNever,  ///< no rollout is abandoned
    kFrom    ///< a rollout is abandoned as soon as the metric reaches `value`
  };
  Kind kind = Kind::kAuto;
  double value = 0.0;  ///< for kFrom, in the metric's unit
};

/// True if a constraint on the metric, once broken, stays broken until the end of the rollout. This is the
/// case for an upper limit of a metric that only grows, and for a lower limit of a metric that only shrinks.
/// upper: true for an upper limit.
bool can_be_hopeless(Metric metric, bool upper);

/// Returns the value at which kAuto abandons a rollout. For an upper limit of joint_velocity/max_ratio this
/// is twice the limit. For a lower limit of joint_position/min_margin it is the limit minus 0.1 rad or m.
/// Returns nothing for other metrics and limits; then no rollout is abandoned.
std::optional<double> default_hopeless(Metric metric, bool upper, double limit);

/// Reads a constraint's key `hopeless`, which is auto, never, or a number beyond the limit. node: null if the
/// key is missing, which means auto; limit: none if it is the metric's value with the start gains. Throws
/// InputError at the node for anything else, and for a number if can_be_hopeless() is false.
Hopeless read_hopeless(const yaml::Node* node, Metric metric, bool upper, std::optional<double> limit);

/// Returns the value as text for a study file, which read_hopeless can read.
std::string hopeless_text(const Hopeless& hopeless);

}  // namespace armtune::internal
