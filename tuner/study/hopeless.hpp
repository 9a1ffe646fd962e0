#pragma once
// Decides when a constraint is broken so far that the rollout counts as hopeless. A search then abandons the
// rollout to save time. This needs a metric that can only get worse during a rollout.

#include <optional>
#include <string>

#include "sim/metrics/metric.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

struct Hopeless {
  enum class Kind {
    kAuto,   ///< depends on the metric: see default_hopeless
    kNever,  ///< rollouts run to their end
    kFrom    ///< from `value` on
  };
  Kind kind = Kind::kAuto;
  double value = 0.0;  ///< for kFrom: value in the metric's unit
};

/// True if a bound, once broken, stays broken until the end of the rollout. This holds for an upper bound on
/// a metric that only grows, and for a lower bound on a metric that only shrinks.
bool can_be_hopeless(Metric metric, bool upper);

/// Returns the value at which kAuto abandons a rollout: twice the limit for joint_velocity/max_ratio, and
/// 0.1 rad (m) beyond the limit for joint_position/min_margin. No value for other metrics and other bounds.
std::optional<double> default_hopeless(Metric metric, bool upper, double limit);

/// Reads a constraint's key `hopeless`: auto (also if null), never or a number beyond the limit. limit: none
/// if it is the start gains' own value. Throws InputError at the node for anything else, and for a number if
/// the metric can recover.
Hopeless read_hopeless(const yaml::Node* node, Metric metric, bool upper, std::optional<double> limit);

/// Returns the text that read_hopeless reads.
std::string hopeless_text(const Hopeless& hopeless);

}  // namespace armtune::internal
