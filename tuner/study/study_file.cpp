// Reads study files, for load_study of study.hpp.

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/gains_file.hpp"
#include "sim/yaml/map_reader.hpp"
#include "tuner/study/hold_keys.hpp"
#include "tuner/study/objective_keys.hpp"
#include "tuner/study/parameter_keys.hpp"
#include "tuner/study/search_keys.hpp"
#include "tuner/study/shared_gains.hpp"
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

/// Returns the path of a file that the node names. Fails at the node if there is no such file.
std::string find_file_at(const yaml::Node& node, const std::string& kind, const std::string& name,
                         const std::string& folder) {
  try {
    return find_data_file(kind, name, folder);
  } catch (const InputError& e) {
    node.fail(e.what(), e.limit());
  }
}

std::vector<Scenario> read_scenarios(const yaml::Node& node, const std::string& folder) {
  std::vector<Scenario> scenarios;
  for (const std::string& name : node.as_strings()) {
    const yaml::Node& item = node.items()[scenarios.size()];
    scenarios.push_back(load_scenario(find_file_at(item, "scenarios", name, folder)));
    if (const std::string why = why_not_last(scenarios); !why.empty()) item.fail(why);
  }
  if (scenarios.empty()) node.fail("the list is empty; name at least one scenario");
  return scenarios;
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
    node->fail(e.what(), e.limit());
  }
}

/// Returns the scenarios of `parts` or, if it has none, those that the file names.
std::vector<Scenario> scenarios_of(yaml::MapReader& map, const std::string& folder, const StudyParts& parts) {
  if (parts.scenarios.empty()) return read_scenarios(map.required("scenarios"), folder);
  map.optional("scenarios");
  std::vector<Scenario> scenarios;
  for (const Scenario& scenario : parts.scenarios) {
    scenarios.push_back(scenario);
    if (const std::string why = why_not_last(scenarios); !why.empty())
      throw InputError(InputPlace{.key = "scenarios"}, InputFault{.problem = why, .value = scenario.name});
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
                    named->as_string()),
        "jazzy, humble or noetic");
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
      study.gains = find_file_at(*named, "gains", named->as_string(), folder);
    if (parts.joints != joints)
      throw InputError(InputPlace{.key = "gains"},
                       "the start gains are for an arm with other joints; give gains for the scenarios' arm");
    return *parts.start;
  }
  const yaml::Node& named = map.required("gains");
  study.gains = find_file_at(named, "gains", named.as_string(), folder);
  study.node = map.string("node", "");
  return load_gains(study.gains, joints, {}, study.node, study.distro);
}

/// Throws InputError if the controller does not accept the gains at the start or at the ends of the bounds.
void validate_bounds(const ParameterSpace& space, const std::vector<std::string>& joints,
                     const std::string& file) {
  const std::size_t n = space.free.size();
  for (const auto& corner : {space.start_point(), std::vector<double>(n, 0.0), std::vector<double>(n, 1.0)}) {
    try {
      validate(space.gains_at(corner), joints, file);
    } catch (const InputError& e) {
      throw e.with(". The bounds under 'parameters' allow this value; change them");
    }
  }
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
  validate_bounds(study.space, joints, root.file());
  study.space.start = study.space.gains_at(study.space.start_point());  // with links; these gains score 1
  if (!parts.start) refuse_split_numbers(study);
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
