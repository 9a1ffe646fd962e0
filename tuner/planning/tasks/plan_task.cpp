#include "tuner/planning/tasks/plan_task.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "sim/csv/cell.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"
#include "sim/yaml/quoted.hpp"
#include "tuner/planning/tasks/plan_task_checks.hpp"

namespace armtune::internal {
namespace {

constexpr double kDefaultClearance = 0.02;  // m, default clearance if there is a cell
constexpr double kNoUpperLimit = std::numeric_limits<double>::infinity();
constexpr long kFewestKnots =
    12;  // start and end give six conditions per joint; each interval has one degree of freedom
constexpr long kMostKnots = 100'000;

JointVector positive_values(yaml::MapReader& map, const char* key, const std::vector<std::string>& joints) {
  const yaml::Node* node = map.optional(key);
  if (node == nullptr) return {};
  JointVector values = yaml::joint_values(*node, joints);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0.0))
      node_of_joint(*node, i, joints)
          .fail(fmt::format("a limit is {}; every limit must be > 0", values[i]), "above 0");
  }
  return values;
}

PlanLimits read_limits(const yaml::Node& node, const RobotModel& robot) {
  const std::vector<std::string> joints = joint_names(robot);
  yaml::MapReader map(node);
  PlanLimits limits;
  limits.velocity = map.number_in("velocity", limits.velocity, 0.01, 1.0);
  limits.effort = map.number_in("effort", limits.effort, 0.01, 1.0);
  limits.acceleration = positive_values(map, "acceleration", joints);
  const JointVector of_robot = robot.acceleration_limits();
  for (Eigen::Index i = 0; i < limits.acceleration.size(); ++i) {
    if (!(limits.acceleration[i] <= of_robot[i]))
      node_of_joint(map.required("acceleration"), i, joints)
          .fail(fmt::format(
                    "the limit of {} is {}, above the robot's limit {}; give at most the robot's limit",
                    joints[static_cast<std::size_t>(i)], cell(limits.acceleration[i]), cell(of_robot[i])),
                "at most " + cell(of_robot[i]));
  }
  limits.jerk = positive_values(map, "jerk", joints);
  map.finish();
  return limits;
}

PlanStart read_start(const yaml::Node& node, const std::vector<std::string>& joints) {
  yaml::MapReader map(node);
  PlanStart start;
  if (const yaml::Node* rollout = map.optional("rollout")) {
    start.rollout = rollout->as_string();
    if (!start.rollout.starts_with('/')) start.rollout = folder_of(node.file()) + "/" + start.rollout;
    if (map.has("position") || map.has("velocity"))
      rollout->fail("cannot be combined with 'position' or 'velocity'; give either 'rollout' or these keys",
                    "either 'rollout' or 'position' and 'velocity'");
    map.finish();
    return start;
  }
  start.position = yaml::joint_values(map.required("position"), joints);
  if (const yaml::Node* velocity = map.optional("velocity"))
    start.velocity = yaml::joint_values(*velocity, joints);
  if (const yaml::Node* acceleration = map.optional("acceleration"))
    start.acceleration = yaml::joint_values(*acceleration, joints);
  map.finish();
  return start;
}

PlanKind read_kind(const yaml::Node& node) {
  std::vector<std::string> words;
  for (const auto& [kind, word] : plan_kinds()) {
    if (node.is_word(word)) return kind;
    words.push_back(word);
  }
  node.fail_choice(words);
}

std::string list(const JointVector& values) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < values.size(); ++i) text += (i == 0 ? "" : ", ") + cell(values[i]);
  return text + "]";
}

/// Returns the distance to keep from the scenario's obstacles and cell. If there is a cell, it must be
/// above 0, because the arm must not touch the cell.
double read_clearance(yaml::MapReader& map, const Scenario& scenario) {
  const bool has_cell = scenario.clearance && !scenario.clearance->pairs().empty();
  const double clearance = map.number_in("clearance", has_cell ? kDefaultClearance : 0.0, 0.0, kNoUpperLimit);
  if (has_cell && clearance == 0.0)
    map.required("clearance")
        .fail(
            scenario.name +
                " has a cell that the arm must not touch; give a clearance above 0, or a scenario without a "
                "cell",
            "above 0");
  if (clearance > 0.0 && scenario.obstacles.empty() && !has_cell)
    map.required("clearance")
        .fail(scenario.name + " has neither obstacles nor a cell; leave this key out", "0");
  return clearance;
}

}  // namespace

const std::vector<std::pair<PlanKind, std::string>>& plan_kinds() {
  static const std::vector<std::pair<PlanKind, std::string>> kinds = {{PlanKind::kMove, "move"},
                                                                      {PlanKind::kTrack, "track"},
                                                                      {PlanKind::kSwitch, "switch"},
                                                                      {PlanKind::kReturn, "return"},
                                                                      {PlanKind::kFastest, "fastest"}};
  return kinds;
}

std::string name(PlanKind kind) {
  for (const auto& [k, word] : plan_kinds()) {
    if (k == kind) return word;
  }
  return {};
}

PlanTask load_plan_task(const std::string& name_or_path) {
  const std::string path = find_data_file("tasks", name_or_path);
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  PlanTask task;
  task.name = stem(path);
  // The scenario that follows the plan is called planned_<name>. This name must not be too long either.
  check_result_name(task.name, path, kLongestName - std::string_view("planned_").size());
  task.source = path;
  task.description = map.string("description", "");
  const yaml::Node& kind = map.required("task");
  task.kind = read_kind(kind);
  const yaml::Node& scenario = map.required("scenario");
  task.scenario = load_scenario(find_data_file("scenarios", scenario.as_string(), folder_of(path)));
  check_task_scenario(scenario, task);
  const auto joints = joint_names(*task.scenario.robot);
  task.at = map.number_in("at", 0.0, 0.0, 1e6);
  if (const yaml::Node* start = map.optional("start")) task.start = read_start(*start, joints);
  if (const yaml::Node* goal = map.optional("goal")) task.goal = yaml::joint_values(*goal, joints);
  if (map.has("duration")) task.duration = map.number_in("duration", 1.0, 1e-3, 1e4);
  task.hold = map.number_in("hold", task.hold, 1e-2, 1e3);
  task.least_error = map.boolean("least_error", task.least_error);
  task.path_tolerance = map.number_in("path_tolerance", task.path_tolerance, 0.0, 1.0);
  task.gaze_threshold = map.number_in("gaze_threshold", task.gaze_threshold, 1e-4, 3.0);
  task.end_gaze = map.boolean("end_gaze", task.end_gaze);
  task.clearance = read_clearance(map, task.scenario);
  if (const yaml::Node* limits = map.optional("limits"))
    task.limits = read_limits(*limits, *task.scenario.robot);
  const long knots = map.integer("knots", task.knots);
  if (knots < kFewestKnots || knots > kMostKnots)
    map.required("knots").fail(
        fmt::format("{} knots; the number must lie in {} .. {}", knots, kFewestKnots, kMostKnots),
        fmt::format("{} .. {}", kFewestKnots, kMostKnots));
  task.knots = static_cast<int>(knots);
  task.smoothness = map.number_in("smoothness", task.smoothness, 0.0, 1e3);
  map.finish();
  check_plan_task(map, task);
  return task;
}

JointVector acceleration_limits(const PlanTask& task) {
  const JointVector of_robot = task.scenario.robot->acceleration_limits();
  return task.limits.acceleration.size() > 0 ? of_robot.cwiseMin(task.limits.acceleration).eval() : of_robot;
}

std::string plan_task_yaml(const PlanTask& task) {
  std::string text =
      fmt::format("description: {}\ntask: {}\nscenario: {}\nat: {}\n", yaml::quoted(task.description),
                  name(task.kind), yaml::quoted(portable_reference(task.scenario.source)), cell(task.at));
  if (!task.start.rollout.empty())
    text += fmt::format("start: {{rollout: {}}}\n", yaml::quoted(portable_reference(task.start.rollout)));
  if (task.start.position.size() > 0) {
    text += "start:\n  position: " + list(task.start.position) + "\n";
    if (task.start.velocity.size() > 0) text += "  velocity: " + list(task.start.velocity) + "\n";
    if (task.start.acceleration.size() > 0) text += "  acceleration: " + list(task.start.acceleration) + "\n";
  }
  if (task.goal.size() > 0) text += "goal: " + list(task.goal) + "\n";
  if (task.duration) text += "duration: " + cell(*task.duration) + "\n";
  const auto add = [&](const char* key, const std::string& value) {
    if (has_effect(key, task)) text += fmt::format("{}: {}\n", key, value);
  };
  add("hold", cell(task.hold));
  add("least_error", task.least_error ? "true" : "false");
  add("path_tolerance", cell(task.path_tolerance));
  add("gaze_threshold", cell(task.gaze_threshold));
  add("end_gaze", task.end_gaze ? "true" : "false");
  text += "clearance: " + cell(task.clearance) + "\n";
  text += fmt::format("limits:\n  velocity: {}\n  effort: {}\n", cell(task.limits.velocity),
                      cell(task.limits.effort));
  if (task.limits.acceleration.size() > 0) text += "  acceleration: " + list(task.limits.acceleration) + "\n";
  if (task.limits.jerk.size() > 0) text += "  jerk: " + list(task.limits.jerk) + "\n";
  text += fmt::format("knots: {}\nsmoothness: {}\n", task.knots, cell(task.smoothness));
  return text;
}

}  // namespace armtune::internal
