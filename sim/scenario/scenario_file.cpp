// Reads scenario files. Implements load_scenario of scenario.hpp.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/robot/kinematics.hpp"
#include "core/robot/link_radius.hpp"
#include "sim/scenario/cell_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/named_paths_file.hpp"
#include "sim/scenario/orientation_file.hpp"
#include "sim/scenario/path_file.hpp"
#include "sim/scenario/plant_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "sim/scenario/scenario_times.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "sim/scenario/stimulus_file.hpp"
#include "sim/scenario/waypoints_file.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMaxBaseFiles = 16;

/// Reads the task mask. If node is null, returns the largest mask that the number of joints allows.
TaskMask read_mask(const yaml::Node* node, int joints) {
  if (node == nullptr) return largest_mask(joints);
  const std::string text = node->as_string();
  for (const TaskMask mask : {TaskMask::kPose, TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
    if (text != name(mask)) continue;
    const TaskMask most = largest_mask(joints);
    if (components(mask) > joints) {
      const bool has_most = components(most) <= joints;
      node->fail(
          fmt::format("{} needs {} joints, but the arm has {}; {}", text, components(mask), joints,
                      has_most ? fmt::format("the largest possible task_mask is {}", name(most))
                               : "leave the key 'task_mask' out: the arm then follows the position as far as "
                                 "its joints allow"),
          has_most ? fmt::format("at most {}", name(most)) : "no task_mask");
    }
    return mask;
  }
  node->fail_choice({"pose", "position_and_axis", "position"});
}

/// Reads from where on the arm the distance to obstacles is measured: `joints`, from the joints' origins, or
/// `links`, from capsules around the links.
void read_distance(const yaml::Node& node, Scenario& scenario) {
  if (node.is_word("joints")) return;
  if (!node.is_word("links"))
    node.fail("'" + node.as_string() + "' is neither joints nor links", "joints or links");
  scenario.robot = std::make_shared<const RobotModel>(with_link_surfaces(*scenario.robot));
}

/// Returns the path of a file, relative to the folder of the file that names it, which may be a base file.
std::string path_in(const yaml::Node& node) {
  return file_beside(node.as_string(), node.file());
}

ThetaStart read_theta_start(const yaml::Node& node) {
  yaml::MapReader map(node);
  ThetaStart start;
  const bool has_file = map.has("file");
  if (has_file == map.has("model_scale")) {
    node.fail("give either file or model_scale (0: theta starts at zero, 1: at the robot's model)",
              "file or model_scale");
  }
  if (has_file) {
    start.file = path_in(map.required("file"));
  }
  start.model_scale = map.number_in("model_scale", 0.0, 0.0, 10.0);
  map.finish();
  return start;
}

/// Reads a file and, recursively, its base files. The keys of a file replace those of its base files.
yaml::Node parse_with_base(const std::string& path, std::vector<std::string>& files) {
  yaml::Node own = yaml::parse_file(path);
  files.push_back(path);
  const yaml::Node* base = own.find("base");
  if (base == nullptr) return own;
  std::vector<std::string> names;
  if (base->kind() == yaml::Node::Kind::kSequence) {
    names = base->as_strings();
  } else {
    names.push_back(base->as_string());
  }
  std::vector<yaml::Node> layers;
  for (const std::string& name : names) {
    if (files.size() > kMaxBaseFiles)
      base->fail(fmt::format("more than {} base files; does a file name itself as its base?", kMaxBaseFiles),
                 fmt::format("at most {} base files", kMaxBaseFiles));
    layers.push_back(parse_with_base(find_data_file("scenarios", name, folder_of(path)), files));
  }
  layers.push_back(own);
  return yaml::overlay(layers);
}

void read_start(const yaml::Node& node, Scenario& scenario) {
  scenario.start_position = in_si(*scenario.robot, yaml::joint_values(node, joint_names(*scenario.robot)));
  for (int i = 0; i < scenario.robot->n(); ++i) {
    const JointInfo& joint = scenario.robot->joints[static_cast<std::size_t>(i)];
    const double q = scenario.start_position[i];
    if (joint.limits.has_position && (q < joint.limits.lower || q > joint.limits.upper)) {
      node.fail(InputFault{
          .problem = fmt::format("{} starts at {:.6g} (in rad or m), outside its limits", joint.name, q),
          .value = fmt::format("{:.6g}", q),
          .limit = fmt::format("{:.6g} to {:.6g}", joint.limits.lower, joint.limits.upper)});
    }
  }
}

/// Sets the task of a scenario that has nothing but a planned motion: to stay where the motion ends.
void hold_the_end(Scenario& scenario) {
  constexpr double kAhead = 1.0;  // m
  scenario.holds_end = true;
  Poses poses;
  forward_kinematics(scenario.robot->chain, scenario.planned->knots().back().position, poses);
  scenario.path = Path{poses.p_0T, 0.0, 0.0, {}};
  scenario.targets = {{"ahead", Path{poses.p_0T + kAhead * poses.R_0T.col(2), 0.0, 0.0, {}}}};
}

/// Returns true if orientation and path come from one waypoint file. Throws InputError if they give different
/// units or columns for it.
bool is_one_file(const yaml::Node& turns, const yaml::Node& points) {
  const UserTable a = read_waypoints_node(turns);
  const UserTable b = read_waypoints_node(points);
  if (a.path != b.path) return false;
  if (a.units.time != b.units.time || a.columns != b.columns)
    turns.fail(
        "this entry and the path read the same file with different 'units' or 'columns'; give both the same "
        "ones");
  return true;
}

/// Reads the tool's path, and its gaze targets or its orientation.
void read_task(yaml::MapReader& map, Scenario& scenario) {
  const bool has_task = map.has("path") || map.has("orientation") || map.has("targets");
  if (scenario.planned && !has_task) return hold_the_end(scenario);
  const yaml::Node* orientation = map.optional("orientation");
  yaml::MapReader tool_path(map.required("path"));
  // Tool poses have their positions and orientations in one file.
  const yaml::Node* turns = orientation == nullptr ? nullptr : orientation->find("waypoints");
  const yaml::Node* points = map.required("path").find("waypoints");
  const bool of_poses = turns != nullptr && points != nullptr && is_one_file(*turns, *points);
  scenario.path = read_path(tool_path, scenario.inputs, of_poses);
  tool_path.finish();
  if (orientation == nullptr) {
    const yaml::Node& targets = map.required("targets");
    scenario.targets = read_targets(targets, scenario.inputs);
    if (scenario.targets.empty())
      targets.fail(
          "the list is empty; give at least one target for the gaze, or give the tool's 'orientation' "
          "instead",
          "at least one target");
    return;
  }
  if (const yaml::Node* targets = map.optional("targets");
      targets != nullptr && !read_targets(*targets, scenario.inputs).empty())
    orientation->fail("the tool's orientation cannot be combined with gaze targets; set 'targets' to []",
                      "no gaze targets");
  if (!tracks_orientation(scenario.mask))
    orientation->fail(
        "the tool's orientation has no effect with 'task_mask: position'; remove it, or give a larger "
        "task_mask",
        "a task_mask with an orientation");
  scenario.orientation = read_orientation(*orientation, scenario.path, scenario.inputs);
  if (scenario.orientation->approach && scenario.mask != TaskMask::kPose)
    orientation->fail(
        "along_path sets the rotation about the tool's z axis, which the task_mask leaves free; give "
        "rpy_deg, or a task_mask of pose",
        "a task_mask of pose");
}

/// Reads the scenario's cell and adds the scenario's obstacles to it. node: null if the scenario has no cell
/// of its own; the cell of the robot file is then used.
void read_clearance(const yaml::Node* node, const RobotFile& robot, Scenario& scenario) {
  std::optional<Cell> cell =
      node != nullptr ? std::optional(read_cell(*node, scenario.inputs)) : cell_of(robot, scenario.inputs);
  if (!cell) return;
  for (const MovingObstacle& obstacle : scenario.obstacles) {
    const bool taken = std::any_of(cell->parts.begin(), cell->parts.end(),
                                   [&](const CellPart& part) { return part.name == obstacle.name; });
    if (taken)
      throw InputError(
          InputPlace{scenario.source, 0, "obstacles"},
          fmt::format("an obstacle and a part of the cell are both called '{}'; rename one of them",
                      obstacle.name))
          .with_value(obstacle.name, "another name");
    if (obstacle.radius > 0.0)
      cell->parts.push_back({obstacle.name, sphere(obstacle.radius), Mat3::Identity(), obstacle.path, true});
  }
  scenario.clearance = std::make_shared<const ClearanceModel>(scenario.robot, std::move(*cell));
  for (const std::string& mesh : scenario.clearance->arm().meshes) scenario.inputs.push_back(mesh);
}

/// Names the scenario after its file.
void name_after(const std::string& path, Scenario& scenario) {
  scenario.name = stem(path);
  check_result_name(scenario.name, path);
  if (scenario.name == kAllScenarios)
    throw InputError(
        InputPlace{path},
        fmt::format("the name '{}' is reserved, because it means all scenarios together; rename the file",
                    kAllScenarios))
        .with_value(scenario.name, "another name");
  scenario.source = path;
}

/// Reads the times at which the gaze changes its target.
void read_target_switches(yaml::MapReader& map, Scenario& scenario) {
  scenario.switch_every = map.number_in("switch_every", 0.0, 0.0, kInfinity);
  if (const yaml::Node* schedule = map.optional("schedule")) {
    scenario.schedule = read_schedule(*schedule, scenario.targets);
    if (scenario.switch_every > 0.0 && !scenario.schedule.empty())
      schedule->fail("a schedule cannot be combined with 'switch_every'; set 'switch_every' to 0",
                     "no switch_every");
  }
}

/// Reads the test signal. Throws InputError if the scenario leaves it without effect.
void read_test_signal(const yaml::Node& node, Scenario& scenario) {
  if (scenario.planned)
    node.fail(
        "a stimulus has no effect while the planned trajectory is followed; remove 'stimulus' or 'planned'",
        "no planned trajectory");
  scenario.stimulus = read_stimulus(node, scenario.duration, scenario.control_period);
  if (scenario.stimulus->on == Stimulus::On::kTarget && scenario.targets.empty())
    node.fail("the stimulus shifts a target, but the scenario has no targets; give 'on: path'", "on: path");
  if (scenario.stimulus->on == Stimulus::On::kTarget && scenario.next_switch(0.0) < HUGE_VAL) {
    node.fail(
        "a stimulus on a target needs a target that does not switch; take switch_every and schedule out",
        "neither switch_every nor schedule");
  }
}

}  // namespace

Scenario load_scenario(const std::string& name_or_path) {
  const std::string path = find_data_file("scenarios", name_or_path);
  Scenario scenario;
  const yaml::Node root = parse_with_base(path, scenario.inputs);
  yaml::MapReader map(root);
  map.ignore("base");
  name_after(path, scenario);
  scenario.description = map.string("description", "");
  const yaml::Node& robot_node = map.required("robot");
  const std::string robot = robot_node.as_string();
  const std::string robot_folder = folder_of(robot_node.file());
  scenario.robot = load_robot(robot, robot_folder);
  for (const std::string& file : scenario.robot->files) scenario.inputs.push_back(file);
  const auto joints = joint_names(*scenario.robot);
  read_times(map, scenario);
  scenario.mask = read_mask(map.optional("task_mask"), scenario.robot->n());
  read_task(map, scenario);
  read_target_switches(map, scenario);
  if (const yaml::Node* obstacles = map.optional("obstacles"))
    scenario.obstacles = read_obstacles(*obstacles, scenario.inputs);
  read_clearance(map.optional("cell"), read_robot_file(robot, robot_folder), scenario);
  // The start of a planned motion has priority over start_position_deg, which a base file may give.
  if (const yaml::Node* start = map.optional("start_position_deg"); start != nullptr && !scenario.planned) {
    read_start(*start, scenario);
  } else if (!scenario.planned) {
    scenario.goal_position = best_start_of_task(scenario);
    scenario.start_position = off_goal(*scenario.robot, scenario.goal_position);
  }
  if (const yaml::Node* camera = map.optional("target_camera")) {
    if (scenario.orientation)
      camera->fail("the scenario has no targets for the camera; take the key out", "no camera");
    scenario.camera = read_camera(*camera);
  }
  if (const yaml::Node* from = map.optional("obstacle_distance")) read_distance(*from, scenario);
  if (const yaml::Node* stimulus = map.optional("stimulus")) read_test_signal(*stimulus, scenario);
  scenario.theta = read_theta_start(map.required("theta_start"));
  if (const yaml::Node* plant = map.optional("plant")) scenario.plant = read_plant(*plant, joints);
  const long seed = map.integer("seed", 1);
  if (seed < 0) map.required("seed").fail("must not be negative", "not negative");
  scenario.seed = static_cast<std::uint64_t>(seed);
  map.finish();
  if (!scenario.theta.file.empty()) start_theta_from(std::string(scenario.theta.file), scenario);
  return scenario;
}

}  // namespace armtune::internal
