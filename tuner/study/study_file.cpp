// Reads study files, for load_study of study.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/common/nearest.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/rollout/applies.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/map_reader.hpp"
#include "tuner/study/hold_keys.hpp"
#include "tuner/study/parameter_keys.hpp"
#include "tuner/study/search_keys.hpp"
#include "tuner/study/study.hpp"

namespace armtune::internal {
namespace {

/// Returns why the last of the scenarios cannot be in a study with the others; empty if it can.
std::string why_not_last(const std::vector<Scenario>& scenarios) {
  const Scenario& last = scenarios.back();
  if (joint_names(*last.robot) != joint_names(*scenarios.front().robot)) {
    return fmt::format("{} and {} have different joints; a study tunes one arm", scenarios.front().name,
                       last.name);
  }
  for (std::size_t i = 0; i + 1 < scenarios.size(); ++i) {
    if (scenarios[i].name == last.name) return last.name + " is listed twice";
  }
  return {};
}

std::vector<Scenario> read_scenarios(const yaml::Node& node, const std::string& folder) {
  std::vector<Scenario> scenarios;
  for (const std::string& name : node.as_strings()) {
    scenarios.push_back(load_scenario(find_data_file("scenarios", name, folder)));
    if (const std::string why = why_not_last(scenarios); !why.empty()) node.fail(why);
  }
  if (scenarios.empty()) node.fail("the list is empty; name at least one scenario");
  return scenarios;
}

/// Magnitudes that a weight, a floor or a limit may have besides zero. Then no product, quotient or sum of
/// them, over however many terms a file can hold, is zero or infinite.
constexpr double kSmallest = 1e-12;
constexpr double kLargest = 1e12;

/// Returns the number. Fails at the node if its magnitude is neither zero nor moderate.
double require_moderate(double value, const yaml::Node& node) {
  const double magnitude = std::abs(value);
  if (magnitude == 0.0 || (magnitude >= kSmallest && magnitude <= kLargest)) return value;
  node.fail(fmt::format("{} is too small or too large; give 0, or a value of magnitude {:.0e} .. {:.0e}",
                        value, kSmallest, kLargest));
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
  node.fail(fmt::format("'{}' is not a metric{}; the metrics are: {}", name, suggestion(name, names),
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
          "{} cannot be an objective, because neither larger nor smaller is better; give another metric",
          name(term.metric)));
    }
    term.weight = read_scale(map, "weight", 1.0);
    term.floor = read_scale(map, "floor", 0.0);
    term.scenarios = read_term_scenarios(item, term.metric, map.optional("scenarios"), scenarios);
    map.finish();
  }
  double weights = 0.0;
  for (const ObjectiveTerm& term : terms) weights += term.weight;
  if (!(weights > 0.0)) node.fail("no term has a weight above zero; give one");
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

/// Sets `hopeless` of all constraints to never, for a risk measure other than the worst arm. With such a
/// measure the other arms can compensate for one bad arm, so no rollout is hopeless.
void end_no_sample_early(const yaml::Node& node, std::vector<Constraint>& constraints) {
  for (std::size_t c = 0; c < constraints.size(); ++c) {
    if (constraints[c].hopeless.kind == Hopeless::Kind::kFrom) {
      node.items()[c]
          .find("hopeless")
          ->fail("is possible only with 'measure: worst' under 'robust'; leave the key out");
    }
    constraints[c].hopeless.kind = Hopeless::Kind::kNever;
  }
}

/// Returns the start gains, converted to the controller that the study's file or the caller names.
Gains controlled(const Gains& gains, const yaml::Node* node, const std::string& asked,
                 const Scenario& first) {
  if (node == nullptr && asked.empty()) return gains;
  try {
    const ControllerKind& kind = controller_kind(asked.empty() ? node->as_string() : asked);
    if (kind.name == gains.controller) return gains;
    const RobotModel& robot = *first.robot;
    return convert_gains(kind, gains, robot, in_si(robot, with_goal(gains, first).joint_space_goal));
  } catch (const InputError& e) {
    if (!asked.empty()) throw;
    node->fail(e.what());
  }
}

/// Returns the scenarios of `parts` or, if it has none, those that the file names.
std::vector<Scenario> scenarios_of(yaml::MapReader& map, const std::string& folder, const StudyParts& parts) {
  if (parts.scenarios.empty()) return read_scenarios(map.required("scenarios"), folder);
  map.optional("scenarios");
  std::vector<Scenario> scenarios;
  for (const Scenario& scenario : parts.scenarios) {
    scenarios.push_back(scenario);
    if (const std::string why = why_not_last(scenarios); !why.empty()) throw InputError("study: " + why);
  }
  return scenarios;
}

/// Returns the distribution of ROS that the key `distro` names, or nothing without this key.
std::optional<RosDistro> read_distro(yaml::MapReader& map) {
  const yaml::Node* named = map.optional("distro");
  if (named == nullptr) return std::nullopt;
  const auto distro = distro_from_name(named->as_string());
  if (!distro)
    named->fail(
        fmt::format("'{}' is not a distribution of ROS that armtune simulates; give jazzy, humble or noetic",
                    named->as_string()));
  return distro;
}

/// Returns the start gains of `parts` or, if it has none, those that the file names.
Gains gains_of(yaml::MapReader& map, const std::string& folder, const StudyParts& parts, Study& study) {
  const auto joints = joint_names(*study.scenarios.front().robot);
  study.distro = read_distro(map);
  if (parts.start) {
    const yaml::Node* named = map.optional("gains");
    study.node = map.string("node", "");
    if (named != nullptr && !study.source.empty())
      study.gains = find_data_file("gains", named->as_string(), folder);
    if (parts.joints != joints)
      throw InputError(
          "study: the start gains are for an arm with other joints; give gains for the scenarios' arm");
    return *parts.start;
  }
  study.gains = find_data_file("gains", map.required("gains").as_string(), folder);
  study.node = map.string("node", "");
  return load_gains(study.gains, joints, {}, study.node, study.distro);
}

/// Reads everything of a study except its name. source: path of the file; empty for a text.
Study read_study(const yaml::Node& root, const std::string& source, const std::string& controller,
                 const StudyParts& parts) {
  yaml::MapReader map(root);
  Study study;
  study.source = source;
  const std::string folder = folder_of(source);
  study.description = map.string("description", "");
  study.scenarios = scenarios_of(map, folder, parts);
  const auto joints = joint_names(*study.scenarios.front().robot);
  const Gains read = gains_of(map, folder, parts, study);
  const yaml::Node* named = map.optional("controller");
  const Gains start = controlled(read, named, controller, study.scenarios.front());
  // The gains in the file belong to the controller `meant`. They are ignored for another controller.
  const std::string& meant = named != nullptr ? named->as_string() : read.controller;
  const bool another = start.controller != meant;
  const yaml::Node* parameters = map.optional("parameters");
  const bool orientation = std::any_of(study.scenarios.begin(), study.scenarios.end(),
                                       [](const Scenario& s) { return tracks_orientation(s.mask); });
  const bool task = std::any_of(study.scenarios.begin(), study.scenarios.end(),
                                [](const Scenario& s) { return s.has_task(); });
  study.space = read_space(another ? nullptr : parameters, start, joints, task, orientation);
  validate(study.space, root.file());
  const std::size_t n = study.space.free.size();
  for (const auto& corner :
       {study.space.start_point(), std::vector<double>(n, 0.0), std::vector<double>(n, 1.0)}) {
    validate(study.space.gains_at(corner), joints, root.file() + ": gains within the bounds of 'parameters'");
  }
  study.space.start = study.space.gains_at(study.space.start_point());  // with links; these gains score 1
  study.own_objective = parts.objective;
  if (parts.objective) {
    map.optional("objective");
  } else {
    study.terms = read_objective(map.required("objective"), study.scenarios);
  }
  if (const yaml::Node* node = map.optional("constraints")) {
    study.constraints = read_constraints(*node, study.scenarios);
  }
  if (const yaml::Node* node = map.optional("sweep"); node != nullptr && !another) {
    study.sweep = read_sweep(*node, gain_entries(start, joints), study.space);
  }
  if (const yaml::Node* node = map.optional("robust")) study.robust = read_samples(*node, study.scenarios);
  if (study.robust && study.robust->measure != RiskMeasure::kWorst && !study.constraints.empty()) {
    end_no_sample_early(map.required("constraints"), study.constraints);
  }
  if (const yaml::Node* node = map.optional("margins")) {
    read_margins(*node, study);
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

}  // namespace

Study load_study(const std::string& name_or_path, const std::string& controller, const StudyParts& parts) {
  const std::string path = find_data_file("studies", name_or_path);
  Study study = read_study(yaml::parse_file(path), path, controller, parts);
  study.name = stem(path);
  check_file_name(study.name, path);
  return study;
}

Study parse_study(const std::string& yaml, const StudyParts& parts) {
  Study study = read_study(yaml::parse_text(yaml, "study"), "", {}, parts);
  study.name = "study";
  return study;
}

}  // namespace armtune::internal
