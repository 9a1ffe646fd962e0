// Study files: reader of study.hpp's load_study.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/common/error.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "sim/rollout/applies.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/map_reader.hpp"
#include "tuner/study/parameter_keys.hpp"
#include "tuner/study/search_keys.hpp"
#include "tuner/study/study.hpp"

namespace armtune {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<Scenario> read_scenarios(const yaml::Node& node, const std::string& folder) {
  std::vector<Scenario> scenarios;
  for (const std::string& name : node.as_strings()) {
    scenarios.push_back(load_scenario(find_data_file("scenarios", name, folder)));
    const auto joints = joint_names(*scenarios.back().robot);
    if (joints != joint_names(*scenarios.front().robot)) {
      node.fail(fmt::format("{} and {} have different joints; a study tunes one arm", scenarios.front().name,
                            scenarios.back().name));
    }
    for (std::size_t i = 0; i + 1 < scenarios.size(); ++i) {
      if (scenarios[i].name == scenarios.back().name) node.fail(scenarios[i].name + " stands twice");
    }
  }
  if (scenarios.empty()) node.fail("empty; name at least one scenario");
  return scenarios;
}

Metric read_metric(const yaml::Node& node) {
  const std::string name = node.as_string();
  if (const auto metric = metric_from_name(name)) return *metric;
  std::vector<std::string> names;
  for (const MetricField& field : metric_fields()) names.emplace_back(field.name);
  node.fail(fmt::format("'{}' is no metric{}; there are: {}", name, suggestion(name, names),
                        fmt::join(names, ", ")));
}

/// Returns the indices of the named scenarios.
std::vector<std::size_t> read_subset(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<std::size_t> subset;
  for (const std::string& name : node.as_strings()) {
    const auto found = std::find_if(scenarios.begin(), scenarios.end(),
                                    [&name](const Scenario& s) { return s.name == name; });
    if (found == scenarios.end()) node.fail("'" + name + "' is not one of the study's scenarios");
    subset.push_back(static_cast<std::size_t>(found - scenarios.begin()));
  }
  if (subset.empty()) node.fail("empty; leave the key out for all scenarios");
  return subset;
}

std::vector<std::size_t> all_of(const std::vector<Scenario>& scenarios) {
  std::vector<std::size_t> all(scenarios.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Returns those of the subset that the metric applies to. Fails at the node if there are none.
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
        fmt::format("{} does not apply to {}: nothing that it measures is there; list under 'scenarios' "
                    "only those of the study that have it, or leave this entry out",
                    name(metric), fmt::join(names, ", ")));
  }
  return found;
}

/// Returns the scenarios that an objective term counts in. Without a list these are all that its metric
/// applies to. It must apply to each scenario of a list.
std::vector<std::size_t> read_term_scenarios(const yaml::Node& term, Metric metric, const yaml::Node* listed,
                                             const std::vector<Scenario>& scenarios) {
  const yaml::Node& named = *term.find("metric");
  if (listed == nullptr) return applicable(named, metric, all_of(scenarios), scenarios);
  std::vector<std::size_t> subset = read_subset(*listed, scenarios);
  for (const std::size_t s : subset) applicable(*listed, metric, {s}, scenarios);
  return subset;
}

std::vector<ObjectiveTerm> read_objective(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<ObjectiveTerm> terms;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    ObjectiveTerm& term = terms.emplace_back();
    term.metric = read_metric(map.required("metric"));
    if (field(term.metric).better == Better::kNeither) {
      map.required("metric").fail(fmt::format(
          "{} is no goal: neither more nor less of it is better; take another metric", name(term.metric)));
    }
    term.weight = map.number_in("weight", 1.0, 0.0, kInfinity);
    term.floor = map.number_in("floor", 0.0, 0.0, kInfinity);
    term.scenarios = read_term_scenarios(item, term.metric, map.optional("scenarios"), scenarios);
    map.finish();
  }
  double weights = 0.0;
  for (const ObjectiveTerm& term : terms) weights += term.weight;
  if (!(weights > 0.0)) node.fail("no term with a weight above zero");
  return terms;
}

std::vector<Constraint> read_constraints(const yaml::Node& node, const std::vector<Scenario>& scenarios) {
  std::vector<Constraint> constraints;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    Constraint& constraint = constraints.emplace_back();
    constraint.metric = read_metric(map.required("metric"));
    constraint.upper = map.has("at_most");
    if (constraint.upper == map.has("at_least")) item.fail("give one of: at_most, at_least");
    const yaml::Node& limit = map.required(constraint.upper ? "at_most" : "at_least");
    if (!limit.is_word("start")) constraint.limit = limit.as_number();
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

/// One arm past a value decides where the worst arm counts; under every other measure the rest may make up
/// for it, so that nothing is hopeless.
void end_no_sample_early(const yaml::Node& node, std::vector<Constraint>& constraints) {
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (constraints[c].hopeless.kind == Hopeless::Kind::kFrom) {
      node.items()[c]
          .find("hopeless")
          ->fail("one arm beyond it decides only with 'measure: worst' under 'robust'; leave the key out");
    }
    constraints[c].hopeless.kind = Hopeless::Kind::kNever;
  }
}

SampleSet read_samples(const yaml::Node& node) {
  yaml::MapReader map(node);
  SampleSet set;
  constexpr long kMostSamples = 1000;
  const long samples = map.integer("samples", static_cast<long>(set.samples));
  if (samples < 1 || samples > kMostSamples)
    map.required("samples").fail(fmt::format("{}: must lie between 1 and {}", samples, kMostSamples));
  set.samples = static_cast<std::size_t>(samples);
  const long seed = map.integer("seed", static_cast<long>(set.seed));
  if (seed < 0) map.required("seed").fail("must not be negative");
  set.seed = static_cast<std::uint64_t>(seed);
  const auto names = risk_measure_names();
  const std::string measure = map.string("measure", names[static_cast<std::size_t>(set.measure)]);
  const auto found = std::find(names.begin(), names.end(), measure);
  if (found == names.end()) {
    map.required("measure").fail(fmt::format("'{}' is not one of: {}", measure, fmt::join(names, ", ")));
  }
  set.measure = static_cast<RiskMeasure>(found - names.begin());
  set.level = map.number_in("level", set.level, 0.0, 1.0);
  if (set.level <= 0.0 || set.level >= 1.0)
    map.required("level").fail("must lie between 0 and 1, ends excluded");
  if (const yaml::Node* widths = map.optional("uncertainty")) {
    yaml::MapReader uncertainty(*widths);
    for (const PerturbationField& f : perturbation_fields()) {
      set.perturbation.*f.width = uncertainty.number(f.name, set.perturbation.*f.width);
    }
    set.perturbation.phases = uncertainty.boolean("phases", set.perturbation.phases);
    uncertainty.finish();
    try {
      validate(set.perturbation, "uncertainty");
    } catch (const InputError& e) {
      widths->fail(e.what());
    }
  }
  map.finish();
  return set;
}

/// Returns the threshold that the field's key gives, or `fallback` without it.
double read_threshold(yaml::MapReader& map, const ThresholdField& field, double fallback) {
  const double value = map.number_in(field.name, fallback, field.least, field.most);
  if (field.whole && value != std::floor(value))
    map.required(field.name).fail(fmt::format("{} {}: give a whole number", value, field.unit));
  return value;
}

/// The keys of `margins`, each one optional: what corner rollouts demand.
std::vector<MarginDemand> read_margins(const yaml::Node& node) {
  yaml::MapReader map(node);
  std::vector<MarginDemand> demands;
  for (const MarginThreshold& margin : margin_thresholds()) {
    const auto field =
        std::find_if(threshold_fields().begin(), threshold_fields().end(),
                     [&margin](const ThresholdField& f) { return std::string(f.name) == margin.key; });
    if (!map.has(margin.key)) continue;
    demands.push_back({margin.kind, read_threshold(map, *field, 0.0)});
  }
  map.finish();
  if (demands.empty())
    node.fail("no margin is demanded; leave the key out, or give one of: delay_periods, gain, rate, noise");
  return demands;
}

/// One constraint for each margin, over its corners, which stand behind the study's scenarios.
void add_margin_constraints(Study& study) {
  std::size_t corner = study.scenarios.size();
  for (const MarginDemand& demand : study.margins) {
    Constraint& constraint = study.constraints.emplace_back();
    constraint.margin = demand;
    for (std::size_t s = 0; s < study.scenarios.size(); ++s) constraint.scenarios.push_back(corner++);
  }
}

/// The keys of `verdict`: thresholds of the simulation checks.
VerdictThresholds read_thresholds(const yaml::Node& node) {
  yaml::MapReader map(node);
  VerdictThresholds thresholds;
  for (const ThresholdField& field : threshold_fields()) {
    thresholds.*field.value = read_threshold(map, field, thresholds.*field.value);
  }
  map.finish();
  return thresholds;
}

/// The start gains, of the controller that the study's file or the caller names.
Gains controlled(const Gains& gains, const yaml::Node* node, const std::string& asked,
                 const Scenario& first) {
  if (node == nullptr && asked.empty()) return gains;
  try {
    const ControllerKind& kind = controller_kind(asked.empty() ? node->as_string() : asked);
    if (kind.name == gains.controller) return gains;
    const RobotModel& robot = *first.robot;
    return controlled_by(kind, gains, robot, in_si(robot, with_goal(gains, first).joint_space_goal));
  } catch (const InputError& e) {
    if (!asked.empty()) throw;
    node->fail(e.what());
  }
}

}  // namespace

std::vector<Scenario> simulated_scenarios(const Study& study) {
  std::vector<Scenario> all = study.scenarios;
  for (const MarginDemand& demand : study.margins) {
    for (const Scenario& scenario : study.scenarios) all.push_back(corner_of(scenario, demand));
  }
  return all;
}

std::size_t rollouts_per_evaluation(const Study& study) {
  const std::size_t arms = study.robust ? study.robust->samples : 1;
  return study.scenarios.size() * (arms + study.margins.size());
}

Study load_study(const std::string& name_or_path, const std::string& controller) {
  const std::string path = find_data_file("studies", name_or_path);
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  Study study;
  study.name = stem(path);
  study.source = path;
  study.description = map.string("description", "");
  study.scenarios = read_scenarios(map.required("scenarios"), folder_of(path));
  const auto joints = joint_names(*study.scenarios.front().robot);
  study.gains = find_data_file("gains", map.required("gains").as_string(), folder_of(path));
  const Gains read = load_gains(study.gains, joints);
  const yaml::Node* named = map.optional("controller");
  const Gains start = controlled(read, named, controller, study.scenarios.front());
  // What the file says of gains is about those of another controller.
  const std::string& meant = named != nullptr ? named->as_string() : read.controller;
  const bool another = start.controller != meant;
  const yaml::Node* parameters = map.optional("parameters");
  const bool orientation = std::any_of(study.scenarios.begin(), study.scenarios.end(),
                                       [](const Scenario& s) { return tracks_orientation(s.mask); });
  study.space = read_space(another ? nullptr : parameters, start, joints, orientation);
  validate(study.space, path);
  const std::size_t n = study.space.free.size();
  for (const auto& corner :
       {study.space.start_point(), std::vector<double>(n, 0.0), std::vector<double>(n, 1.0)}) {
    validate(study.space.gains_at(corner), joints, path + ": gains within the bounds of 'parameters'");
  }
  study.space.start = study.space.gains_at(study.space.start_point());  // links included: it is what scores 1
  study.terms = read_objective(map.required("objective"), study.scenarios);
  if (const yaml::Node* node = map.optional("constraints")) {
    study.constraints = read_constraints(*node, study.scenarios);
  }
  if (const yaml::Node* node = map.optional("sweep"); node != nullptr && !another) {
    study.sweep = read_sweep(*node, gain_entries(fields_of(start), joints), study.space);
  }
  if (const yaml::Node* node = map.optional("robust")) study.robust = read_samples(*node);
  if (study.robust && study.robust->measure != RiskMeasure::kWorst && !study.constraints.empty()) {
    end_no_sample_early(map.required("constraints"), study.constraints);
  }
  if (const yaml::Node* node = map.optional("margins")) {
    study.margins = read_margins(*node);
    add_margin_constraints(study);
  }
  if (const yaml::Node* node = map.optional("verdict")) study.thresholds = read_thresholds(*node);
  if (const yaml::Node* node = map.optional("search")) {
    read_search(*node, study);
  } else {
    default_search(study);
  }
  if (const yaml::Node* node = map.optional("warm_start")) read_warm_start(*node, study);
  map.finish();
  return study;
}

}  // namespace armtune
