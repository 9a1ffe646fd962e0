#pragma once
// The value of its metric from which a constraint is broken too far to recover, so that a rollout may be
// abandoned.

#include <optional>
#include <string>

#include "sim/metrics/metric.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {

struct Hopeless {
  enum class Kind {
    kAuto,   ///< by the metric: see default_hopeless
    kNever,  ///< rollouts run whole
    kFrom    ///< from `value` on
  };
  Kind kind = Kind::kAuto;
  double value = 0.0;  ///< of kFrom, in the metric's unit
};

/// Returns true if a broken bound can be too far to recover: an upper one of a metric that only grows, a
/// lower one of a metric that only shrinks.
bool can_be_hopeless(Metric metric, bool upper);

/// What kAuto stands for under a limit: joint_velocity/max_ratio from twice the limit on,
/// joint_position/min_margin from 0.1 rad (m) beyond it on; none for other metrics and for the other bound.
std::optional<double> default_hopeless(Metric metric, bool upper, double limit);

/// Value of a constraint's key `hopeless`: auto (also if null), never or a number beyond the limit. limit:
/// none if it is the start gains' own value. Fails at the node for anything else, and for a number where the
/// metric can recover.
Hopeless read_hopeless(const yaml::Node* node, Metric metric, bool upper, std::optional<double> limit);

/// As read_hopeless reads it.
std::string hopeless_text(const Hopeless& hopeless);

}  // namespace armtune::internal
