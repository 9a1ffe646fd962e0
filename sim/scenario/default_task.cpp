#include "sim/scenario/default_task.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/measured_arm.hpp"
#include "core/control/pose_search.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr unsigned kSamples = 2000;
constexpr std::size_t kTried = 40;  // of the samples, the best first
constexpr int kHalvings = 3;
constexpr double kRadius = 0.09;       // of the reach
constexpr double kAhead = 0.35;        // of the reach
constexpr double kApart = 0.1;         // of the reach, each target from the middle
constexpr double kEnoughMargin = 0.1;  // of a joint's range
constexpr double kTurn = 10.0;         // s
constexpr double kCentering = 0.2;     // 1/s
constexpr double kSingular = 1e-4;     // m^3, for a reach of 1 m: anything less is one by rounding

struct Place {
  JointVector q;
  double score = 0.0;
  double manipulability = 0.0;
};

std::vector<Place> good_places(const RobotModel& robot, TaskMask mask) {
  std::vector<Place> places;
  places.reserve(kSamples);
  MeasuredArm arm;
  const JointVector rest = JointVector::Zero(robot.n());
  for (unsigned sample = 0; sample < kSamples; ++sample) {
    Place place{sample_position(robot, sample), 0.0, 0.0};
    arm.measure(robot.chain, place.q, rest, {0.0, 1.0, 0.0}, mask);
    place.manipulability = arm.inverse.manipulability();
    const double margin = tightest_joint(robot, place.q).margin;
    const double down = 0.5 * (1.0 - arm.poses.R_0T(2, 2));
    const double above = arm.poses.p_0T.z() > kRadius * reach(robot) ? 1.0 : 0.2;
    place.score = place.manipulability * std::min(1.0, margin / kEnoughMargin) * (0.1 + 0.9 * down) * above;
    places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.score > b.score; });
  places.resize(kTried);
  return places;
}

/// Three digits: what a person would write.
double rounded(double x) {
  return std::round(x * 1e3) / 1e3;
}
Vec3 rounded(const Vec3& x) {
  return {rounded(x.x()), rounded(x.y()), rounded(x.z())};
}

void put_task(const Poses& poses, double size, double shrunk, Scenario& scenario) {
  const Vec3 center = rounded(poses.p_0T);
  const double radius = kRadius * size * shrunk;
  scenario.path = {
      center,
      2.0 * M_PI / kTurn,
      0.0,
      {{1, rounded(Vec3(radius * poses.R_0T.col(0))), rounded(Vec3(radius * poses.R_0T.col(1)))}}};
  const Vec3 ahead = center + kAhead * size * poses.R_0T.col(2);
  const Vec3 aside = kApart * size * shrunk * poses.R_0T.col(0);
  scenario.targets = {{"left", {rounded(Vec3(ahead + aside)), 0.0, 0.0, {}}},
                      {"right", {rounded(Vec3(ahead - aside)), 0.0, 0.0, {}}}};
}

std::string list(const Vec3& x) {
  return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", x.x(), x.y(), x.z());
}

/// Circle, targets, goal and start where they fit. False: nowhere.
bool place_task(DefaultTask& task) {
  Scenario& scenario = task.scenario;
  const RobotModel& arm = *scenario.robot;
  const double size = reach(arm);
  const std::vector<Place> places = good_places(arm, scenario.mask);
  for (int halving = 0; halving <= kHalvings; ++halving) {
    const double shrunk = 1.0 / (1 << halving);
    for (const Place& place : places) {
      if (!(place.manipulability > kSingular * std::pow(size, 3))) continue;
      Poses poses;
      forward_kinematics(arm.chain, place.q, poses);
      put_task(poses, size, shrunk, scenario);
      // From the circle's centre to where it begins.
      task.goal = place.q;
      ToolGoal begin{scenario.path.at(0.0).position, {}};
      if (tracks_orientation(scenario.mask)) begin.target = scenario.targets[0].path.center;
      if (!reach_goal(arm, begin, task.goal)) continue;
      const PathWalk walk = walk_path(scenario, task.goal, kCentering);
      if (!is_clear(walk)) continue;
      task.manipulability = walk.manipulability.value;
      scenario.start_position = off_goal(arm, task.goal);
      return true;
    }
  }
  return false;
}

}  // namespace

DefaultTask default_task(std::shared_ptr<const RobotModel> robot) {
  DefaultTask task;
  Scenario& scenario = task.scenario;
  scenario.name = "task";
  scenario.robot = std::move(robot);
  const RobotModel& arm = *scenario.robot;
  scenario.duration = 30.0;
  scenario.control_period = 0.002;
  scenario.switch_every = 7.5;
  scenario.theta.model_scale = 0.8;
  scenario.plant.position_noise = 1e-4;
  scenario.plant.velocity_noise = 0.01;
  scenario.plant.torque_delay_periods = 1;
  double mass = 0.0;
  for (int i = 0; i < arm.n(); ++i) mass += arm.chain.link[static_cast<std::size_t>(i)].mass;
  scenario.plant.payload.mass = rounded(0.02 * mass);
  // The gaze leaves the roll to the arm: that many joints less are needed.
  for (const TaskMask mask : {TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
    scenario.mask = mask;
    if (components(mask) <= arm.n() && place_task(task)) return task;
  }
  throw InputError(fmt::format(
      "{}: no place was found where {} can draw even a circle of {:.2g} m{}; write a scenario with "
      "a path of its own",
      arm.source, arm.name, kRadius * reach(arm) / (1 << kHalvings),
      arm.n() < components(TaskMask::kPosition)
          ? fmt::format(": {} joints are too few to have a tool anywhere, which takes three", arm.n())
          : ""));
}

std::string default_task_yaml(const DefaultTask& task, const std::string& robot) {
  const Scenario& s = task.scenario;
  const std::string description =
      fmt::format("a circle where {} moves well{}", s.robot->name,
                  tracks_orientation(s.mask) ? ", the gaze at two targets that take turns" : "");
  std::string text = fmt::format(
      "description: {0}\nrobot: {1}\nduration: {2}            "
      "# s\ncontrol_period: {3}   # s\nstart_position_deg: [{4:.4g}]\n"
      "task_mask: {5}   # what the arm is to hold: pose, position_and_axis or position\n\n"
      "# center + sum of cos and sin terms of order k at k * frequency, base frame\npath:\n  center: {6}   # "
      "m\n"
      "  frequency: {7}   # rad/s\n  terms:\n    - {{order: 1, cos: {8}, sin: {9}}}\n\nswitch_every: {10}   "
      "# s\ntargets:\n",
      yaml::quoted(description), yaml::quoted(robot), s.duration, s.control_period,
      fmt::join(in_degrees(*s.robot, s.start_position), ", "), name(s.mask), list(s.path.center),
      s.path.frequency, list(s.path.terms[0].cosine), list(s.path.terms[0].sine), s.switch_every);
  for (const NamedPath& target : s.targets)
    text += fmt::format("  - {{name: {}, center: {}}}\n", target.name, list(target.path.center));
  text += fmt::format(
      "\n# What the real arm has and the controller does not know.\ntheta_start: {{model_scale: "
      "{}}}\nplant:\n"
      "  position_noise: {}      # rad, m\n  velocity_noise: {}      # rad/s, m/s\n  torque_delay_periods: "
      "{}\n"
      "  payload: {{mass: {:.4g}, center: [0, 0, 0]}}   # kg, at the tool\nseed: 1\n",
      s.theta.model_scale, s.plant.position_noise, s.plant.velocity_noise, s.plant.torque_delay_periods,
      s.plant.payload.mass);
  return text;
}

}  // namespace armtune::internal
