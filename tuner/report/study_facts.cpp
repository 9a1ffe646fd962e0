#include "tuner/report/study_facts.hpp"

#include <fmt/format.h>

#include "sim/yaml/document.hpp"

namespace armtune::internal::report {
namespace {

const yaml::Node& needed(const yaml::Node& map, const char* key) {
  const yaml::Node* node = map.find(key);
  if (node == nullptr)
    map.fail(std::string("key '") + key + "' is missing; put back the study.yaml that armtune wrote here");
  return *node;
}

/// Returns nothing for a metric that only another version of armtune has.
std::optional<Metric> metric_of(const yaml::Node& item) {
  return metric_from_name(needed(item, "metric").as_string());
}

}  // namespace

std::vector<Metric> metrics_of(const StudyFacts& study) {
  std::vector<Metric> metrics;
  metrics.reserve(study.terms.size() + study.limits.size());
  for (const StudyTerm& term : study.terms) metrics.push_back(term.metric);
  for (const StudyLimit& limit : study.limits) metrics.push_back(limit.metric);
  return metrics;
}

StudyFacts read_study_facts(const std::string& path) {
  const yaml::Node root = yaml::parse_file(path);
  StudyFacts facts;
  if (const yaml::Node* description = root.find("description")) facts.description = description->as_string();
  for (const yaml::Node& item : needed(root, "parameters").items()) {
    const yaml::Node* lower = item.find("lower");
    const yaml::Node* upper = item.find("upper");
    const yaml::Node* start = item.find("start");
    if (lower == nullptr || upper == nullptr || start == nullptr) continue;  // a fixed or linked one
    facts.gains.push_back({needed(item, "name").as_string(), start->as_number(), lower->as_number(),
                           upper->as_number(), needed(item, "scale").as_string()});
  }
  for (const yaml::Node& item : needed(root, "objective").items()) {
    if (const auto metric = metric_of(item))
      facts.terms.push_back({*metric, needed(item, "scenarios").as_strings()});
  }
  if (const yaml::Node* constraints = root.find("constraints")) {
    for (const yaml::Node& item : constraints->items()) {
      const auto metric = metric_of(item);
      if (!metric) continue;
      const yaml::Node* at_most = item.find("at_most");
      const yaml::Node& limit = at_most != nullptr ? *at_most : needed(item, "at_least");
      facts.limits.push_back({*metric, at_most != nullptr,
                              limit.is_word("start") ? std::nullopt : std::optional(limit.as_number()),
                              needed(item, "scenarios").as_strings()});
    }
  }
  if (const yaml::Node* robust = root.find("robust")) {
    constexpr long kMost = 1'000'000'000;
    const yaml::Node& node = needed(*robust, "samples");
    const long samples = node.as_integer();
    if (samples < 0 || samples > kMost) node.fail("expected a number of arms, from 0 to 1000000000");
    // The scenario's own arm counts too.
    facts.measure =
        fmt::format("{} of {} arms in each scenario", needed(*robust, "measure").as_string(), samples + 1);
  }
  return facts;
}

}  // namespace armtune::internal::report
