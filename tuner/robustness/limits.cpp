#include "tuner/robustness/limits.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/rollout/applies.hpp"

namespace armtune::internal {
namespace {

/// Key of the errors in the text of a limit, which is not in a file.
constexpr const char* kLimitKey = "limit";

}  // namespace

std::vector<MetricLimit> arm_limits() {
  std::vector<MetricLimit> limits = {{Metric::kJointVelocityMaxRatio, true, 1.0},
                                     {Metric::kJointPositionMinMargin, false, 0.0}};
  limits.push_back({Metric::kJointAccelerationMaxRatio, true, 1.0});
  for (const Metric contact : kContactMetrics) limits.push_back({contact, false, 0.0});
  return limits;
}

MetricLimit parse_limit(const std::string& text) {
  const std::size_t place = text.find_first_of("<>");
  if (place == std::string::npos || place + 1 >= text.size() || text[place + 1] != '=') {
    throw InputError(InputPlace{.key = kLimitKey},
                     fmt::format("'{}' does not have the form METRIC<=VALUE or METRIC>=VALUE, such as "
                                 "joint_velocity/max_ratio<=0.9",
                                 text))
        .with_value(text, "METRIC<=VALUE or METRIC>=VALUE");
  }
  MetricLimit limit;
  const std::string metric = text.substr(0, place);
  const auto known = metric_from_name(metric);
  if (!known) {
    std::vector<std::string> names;
    for (const MetricField& field : metric_fields()) names.emplace_back(field.name);
    throw InputError(InputPlace{.key = kLimitKey},
                     fmt::format("'{}' limits a metric that does not exist, '{}'{}", text, metric,
                                 suggestion(metric, names)))
        .with_value(metric, fmt::format("one of: {}", fmt::join(names, ", ")));
  }
  limit.metric = *known;
  limit.upper = text[place] == '<';
  const std::string number = text.substr(place + 2);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), limit.value);
  if (error != std::errc{} || end != number.data() + number.size() || !std::isfinite(limit.value)) {
    throw InputError(InputPlace{.key = kLimitKey},
                     fmt::format("'{}' in '{}' is not a finite number", number, text))
        .with_value(number, "a finite number");
  }
  return limit;
}

std::vector<MetricLimit> parse_limits(const std::vector<std::string>& texts) {
  if (texts.empty()) return arm_limits();
  std::vector<MetricLimit> limits;
  limits.reserve(texts.size());
  for (const std::string& text : texts) limits.push_back(parse_limit(text));
  return limits;
}

std::string to_string(const MetricLimit& limit) {
  return fmt::format("{} {} {}", name(limit.metric), limit.upper ? "<=" : ">=", limit.value);
}

std::string saturation_text() {
  return fmt::format("torque saturated in over {} % of the periods", 100.0 * kSaturatedShare);
}

RolloutFailure broken_limit(const RolloutResult& result, const std::vector<MetricLimit>& limits,
                            const Scenario& scenario) {
  if (result.status != RolloutStatus::kCompleted) return {name(result.status), {}};
  for (const MetricLimit& limit : limits) {
    const double value = result.metrics[limit.metric];
    const bool kept = limit.upper ? value <= limit.value : value >= limit.value;
    if (!kept && applies(limit.metric, scenario)) return {to_string(limit), limit.metric};
  }
  const double saturated = result.metrics[Metric::kJointEffortSaturatedPeriods];
  if (saturated > static_cast<double>(saturated_periods_allowed(scenario))) return {saturation_text(), {}};
  return {};
}

}  // namespace armtune::internal
