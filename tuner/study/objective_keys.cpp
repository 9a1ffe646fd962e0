#include "tuner/study/objective_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/rollout/applies.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Magnitudes that a weight, a floor or a limit may have besides zero. Then no product, quotient or sum of
/// them, over however many terms a file can hold, is zero or infinite.
constexpr double kSmallest = 1e-12;
constexpr double kLargest = 1e12;

/// Returns the number. Fails at the node if its magnitude is neither zero nor moderate.
double require_moderate(double value, const yaml::Node& node) {
  const double magnitude = std::abs(value);
  if (magnitude == 0.0 || (magnitude >= kSmallest && magnitude <= kLargest)) return value;
  const std::string limit = fmt::format("0, or a value of magnitude {:.0e} .. {:.0e}", kSmallest, kLargest);
  node.fail(fmt::format("{} is too small or too large; give {}", value, limit), limit);
}

/// Reads a number that is not negative, and fails as require_moderate does.
double read_scale(yaml::MapReader& map, std::string_view key, double otherwise) {
  const double value = map.number_in(key, otherwise, 0.0, kLargest);
  return map.has(key) ? require_moderate(value, map.required(key)) : value;
}

Metric read_metric(const yaml::Node& node) {
  const std::string name = node.as_string();
  if (const auto metric = metric_from_name(name)) return *metric;
  std::vector<std::string> names;
  for (const MetricField& field : metric_fields()) names.emplace_back(field.name);
  const std::string known = fmt::format("{}", fmt::join(names, ", "));
  node.fail(fmt::format("'{}' is not a metric{}; the metrics are: {}", name, suggestion(name, names), known),
            "one of: " + known);
}

/// Returns the indices of the named scenarios.
std::vector<std::size_t> read_subset(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<std::size_t> subset;
  for (const std::string& name : node.as_strings()) {
    const auto found = std::find_if(scenarios.begin(), scenarios.end(),
                                    [&name](const Scenario& s) { return s.name == name; });
    if (found == scenarios.end()) {
      std::vector<std::string> names;
      names.reserve(scenarios.size());
      for (const Scenario& scenario : scenarios) names.push_back(scenario.name);
      node.items()[subset.size()].fail("'" + name + "' is not one of the study's scenarios",
                                       fmt::format("one of: {}", fmt::join(names, ", ")));
    }
    subset.push_back(static_cast<std::size_t>(found - scenarios.begin()));
  }
  if (subset.empty()) node.fail("the list is empty; leave the key out to use all scenarios");
  return subset;
}

std::vector<std::size_t> all_of(const std::vector<Scenario>& scenarios) {
  std::vector<std::size_t> all(scenarios.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Returns the scenarios of the subset to which the metric applies. Fails at the node if there are none.
std::vector<std::size_t> applicable(const yaml::Node& node, Metric metric,
                                    const std::vector<std::size_t>& subset,
                                    const std::vector<Scenario>& scenarios) {
  std::vector<std::size_t> found;
  std::vector<std::string> names;
  for (const std::size_t s : subset) {
    if (applies(metric, scenarios[s])) found.push_back(s);
    names.push_back(scenarios[s].name);
  }
  if (found.empty()) {
    node.fail(
        fmt::format("{} does not apply to {}; under 'scenarios', list only scenarios in which it can be "
                    "measured, or remove this entry",
                    name(metric), fmt::join(names, ", ")));
  }
  return found;
}

/// Returns the scenarios in which an objective term counts. Without a list, these are all scenarios to which
/// its metric applies. With a list, the metric must apply to each scenario of the list.
std::vector<std::size_t> read_term_scenarios(const yaml::Node& term, Metric metric, const yaml::Node* listed,
                                             const std::vector<Scenario>& scenarios) {
  const yaml::Node& named = *term.find("metric");
  if (listed == nullptr) return applicable(named, metric, all_of(scenarios), scenarios);
  std::vector<std::size_t> subset = read_subset(*listed, scenarios);
  for (std::size_t i = 0; i < subset.size(); ++i)
    applicable(listed->items()[i], metric, {subset[i]}, scenarios);
  return subset;
}

}  // namespace

std::vector<ObjectiveTerm> read_objective(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<ObjectiveTerm> terms;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    ObjectiveTerm& term = terms.emplace_back();
    term.metric = read_metric(map.required("metric"));
    if (field(term.metric).better == Better::kNeither) {
      map.required("metric").fail(fmt::format(
          "{} cannot be an objective, because neither larger nor smaller values are better; give another "
          "metric",
          name(term.metric)));
    }
    term.weight = read_scale(map, "weight", 1.0);
    term.floor = read_scale(map, "floor", 0.0);
    term.scenarios = read_term_scenarios(item, term.metric, map.optional("scenarios"), scenarios);
    map.finish();
  }
  double weights = 0.0;
  for (const ObjectiveTerm& term : terms) weights += term.weight;
  if (!(weights > 0.0)) node.fail("no term has a weight above zero; give one", "a weight above zero");
  return terms;
}

std::vector<Constraint> read_constraints(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<Constraint> constraints;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    Constraint& constraint = constraints.emplace_back();
    constraint.metric = read_metric(map.required("metric"));
    constraint.upper = map.has("at_most");
    if (constraint.upper == map.has("at_least"))
      item.fail("give one of: at_most, at_least", "one of the keys: at_most, at_least");
    const yaml::Node& limit = map.required(constraint.upper ? "at_most" : "at_least");
    if (!limit.is_word("start")) constraint.limit = require_moderate(limit.as_number(), limit);
    const yaml::Node* listed = map.optional("scenarios");
    constraint.scenarios = listed != nullptr ? read_subset(*listed, scenarios) : all_of(scenarios);
    applicable(listed != nullptr ? *listed : map.required("metric"), constraint.metric, constraint.scenarios,
               scenarios);
    constraint.hopeless =
        read_hopeless(map.optional("hopeless"), constraint.metric, constraint.upper, constraint.limit);
    map.finish();
  }
  return constraints;
}

void end_no_sample_early(const yaml::Node& node, std::vector<Constraint>& constraints) {
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (constraints[c].hopeless.kind == Hopeless::Kind::kFrom) {
      node.items()[c]
          .find("hopeless")
          ->fail("may have a value only with 'measure: worst' under 'robust'; leave the key out",
                 "never or auto");
    }
    constraints[c].hopeless.kind = Hopeless::Kind::kNever;
  }
}

}  // namespace armtune::internal
