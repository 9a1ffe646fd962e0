#pragma once
// The value of a constraint's metric from which the constraint is broken too far to recover, so that a
// rollout may be abandoned.

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

/// Returns true if a broken bound can be too far to recover: an upper one of a metric that only grows, a
/// lower one of a metric that only shrinks.
bool can_be_hopeless(Metric metric, bool upper);

/// Returns the value that kAuto stands for under a limit: joint_velocity/max_ratio from twice the limit on,
/// joint_position/min_margin from 0.1 rad (m) beyond it on; none for other metrics and for the other bound.
std::optional<double> default_hopeless(Metric metric, bool upper, double limit);

/// Reads a constraint's key `hopeless`: auto (also if null), never or a number beyond the limit. limit: none
/// if it is the start gains' own value. Throws InputError at the node for anything else, and for a number if
/// the metric can recover.
Hopeless read_hopeless(const yaml::Node* node, Metric metric, bool upper, std::optional<double> limit);

/// Returns the text that read_hopeless reads.
std::string hopeless_text(const Hopeless& hopeless);

}  // namespace armtune::internal
