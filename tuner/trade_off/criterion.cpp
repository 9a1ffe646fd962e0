#include "tuner/trade_off/criterion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/rollout/applies.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kObjective = "objective";

}  // namespace

std::string Criterion::name() const {
  return metric ? armtune::internal::name(*metric) : kObjective;
}

std::string Criterion::unit() const {
  return metric ? field(*metric).unit : "1";
}

bool Criterion::larger_is_better() const {
  return metric && armtune::internal::larger_is_better(*metric);
}

Criterion criterion_from_name(const std::string& name) {
  if (name == kObjective) return {};
  if (const auto metric = metric_from_name(name)) {
    if (field(*metric).better != Better::kNeither) return {metric};
    throw InputError(
        fmt::format(
            "{} cannot be a criterion, because neither larger nor smaller values are better; choose another "
            "metric",
            name))
        .with_value(name, "a metric that is better the smaller (or the larger) it is");
  }
  std::vector<std::string> names{kObjective};
  for (const MetricField& f : metric_fields()) names.emplace_back(f.name);
  const std::string known = fmt::format("one of: {}", fmt::join(names, ", "));
  throw InputError(fmt::format("'{}' is neither 'objective' nor a metric{}; choose {}", name,
                               suggestion(name, names), known))
      .with_value(name, known);
}

double cost(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios) {
  if (!criterion.metric) return e.objective;
  const double sign = criterion.larger_is_better() ? -1.0 : 1.0;
  double worst = NAN;
  for (std::size_t s = 0; s < scenarios.size(); ++s) {
    if (!applies(*criterion.metric, scenarios[s])) continue;
    const double cost = sign * e.results[s].metrics[*criterion.metric];
    if (std::isnan(cost)) return NAN;
    worst = std::fmax(worst, cost);
  }
  return worst;
}

double value(const Criterion& criterion, const Evaluation& e, const std::vector<Scenario>& scenarios) {
  return criterion.larger_is_better() ? -cost(criterion, e, scenarios) : cost(criterion, e, scenarios);
}

}  // namespace armtune::internal
