#pragma once
// What is traded off: the study's objective or a metric over its scenarios.

#include <optional>
#include <string>

#include "tuner/study/study.hpp"

namespace armtune::internal {

struct Criterion {
  std::optional<Metric> metric;  ///< none: the study's objective

  /// "objective" or the metric's name.
  std::string name() const;
  std::string unit() const;
  bool larger_is_better() const;
};

/// From "objective" or the name of a metric that is a goal. Throws InputError.
Criterion criterion_from_name(const std::string& name);

/// The objective, or the metric's worst value over the scenarios that it applies to (see applies()); NaN if
/// one of them did not give it, or if there are none. In the metric's unit. e: with one result per scenario.
double value(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

/// The value with the sign that makes less better.
double cost(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios);

}  // namespace armtune::internal
