#include "sim/scenario/path_walk.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/laws/starting_gains.hpp"
#include "core/control/pose_search.hpp"
#include "core/control/task_goal.hpp"
#include "core/robot/kinematics.hpp"

namespace armtune::internal {
namespace {

constexpr double kStep = 0.02;         // s
constexpr double kLongestStep = 0.05;  // s: short enough for the errors of TaskGoal, which decay at 3 /s
constexpr long kMostSteps = 20000;     // thirty walks with so many steps take seconds
constexpr double kOffPath = 1e-3;      // m: the inverse kinematics itself is a hundred times more accurate
constexpr double kSingular = 0.02;     // as a share of the largest manipulability of the walk

/// Returns true if no part of the cell moves.
bool parts_rest(const Scenario& scenario) {
  if (!scenario.clearance) return true;
  const auto& parts = scenario.clearance->cell().parts;
  return std::all_of(parts.begin(), parts.end(), [](const CellPart& part) { return part.path.rests(); });
}

/// Returns the time that a walk must cover [s]. One lap of the path is enough if nothing else moves.
double walked_time(const Scenario& scenario) {
  const bool targets_rest =
      parts_rest(scenario) && std::all_of(scenario.targets.begin(), scenario.targets.end(),
                                          [](const NamedPath& target) { return target.path.rests(); });
  const double rest = scenario.next_switch(0.0) < scenario.duration ? scenario.duration : 1.0;
  // A rotation through waypoints does not repeat with the path.
  const bool turns = scenario.orientation && scenario.orientation->turn;
  if (!targets_rest || turns) return scenario.duration;
  if (scenario.path.rests()) return std::min(scenario.duration, rest);
  const double turn = scenario.path.period();
  return turn > 0.0 ? std::min(scenario.duration, std::max(rest, turn)) : scenario.duration;
}

/// Returns the desired aim of the tool. `wanted` stores the orientation to which the result refers.
ToolAim aim_at(const Scenario& scenario, double time, OrientationPoint& wanted) {
  ToolAim aim;
  aim.axis_only = scenario.mask == TaskMask::kPositionAndAxis;
  if (scenario.orientation) {
    wanted = scenario.orientation->at(time, scenario.path);
    aim.orientation = &wanted;
  } else {
    aim.target = scenario.targets[scenario.active_target(time)].path.at(time);
  }
  return aim;
}

/// Walks for `walked` seconds from q, and sets q to the joint positions at the end. kept: receives the joint
/// motion; null: it is not kept. required: see walk_path.
PathWalk walk_for(const Scenario& scenario, double walked, JointVector& q, double centering_gain,
                  double roll_gain, WalkUntil until, const std::vector<double>& required,
                  JointWalk* kept = nullptr) {
  const RobotModel& robot = *scenario.robot;
  const double scale = std::min(1.0, std::pow(reach(robot), 3));
  const InverseDamping damping{1e-3 * scale, 1e-3 * scale, 1.0};
  const JointCentering centering = joint_centering(robot, centering_gain);
  RollCentering roll(robot, scenario.orientation ? 0.0 : roll_gain, scenario.mask);
  const bool looks = tracks_orientation(scenario.mask) && !scenario.orientation;
  TaskGoal motion;
  motion.start(q);
  MeasuredArm arm;
  WalkExtremes extremes(scenario, kOffPath, required);
  PathWalk walk;
  const double dt = std::clamp(walked / kMostSteps, kStep, kLongestStep);
  const auto steps = static_cast<long>(std::min<double>(kMostSteps, std::ceil(walked / dt)));
  for (long k = 0; k <= steps; ++k) {
    const double time = scenario.start_time + static_cast<double>(k) * dt;
    const MotionPoint<Vec3> path = scenario.path.at(time);
    OrientationPoint wanted;
    const ToolAim aim = aim_at(scenario, time, wanted);
    if (looks) take_smaller({time, path.position, (aim.target.position - path.position).norm()}, walk.sight);
    const MotionPoint<JointVector>& joints =
        motion.step(robot.chain, path, aim, damping, scenario.mask, centering, dt, &roll);
    arm.measure(robot.chain, joints.position, joints.velocity, damping, scenario.mask);
    extremes.see(time, path.position, arm, joints.position, walk);
    if (kept != nullptr) {
      kept->time.push_back(time);
      kept->positions.push_back(joints);
    }
    walk.steps = k;
    walk.ended = time;
    q = joints.position;
    if (!std::isfinite(walk.error.value)) break;
    if (until == WalkUntil::kLost && (is_off_path(walk) || walk.margin.value < 0.0)) break;
  }
  extremes.finish(walk);
  return walk;
}

}  // namespace

bool is_off_path(const PathWalk& walk) {
  return !(walk.error.value <= kOffPath);
}

bool is_singular(const PathWalk& walk) {
  return !(walk.manipulability.value >= kSingular * walk.largest_manipulability);
}

const LeastClearance* contact(const PathWalk& walk) {
  for (const LeastClearance& least : walk.nearest) {
    if (least.distance < 0.0) return &least;
  }
  return nullptr;
}

double depth(const PathWalk& walk) {
  double deepest = 0.0;
  for (const LeastClearance& least : walk.nearest) deepest = std::max(deepest, -least.distance);
  return deepest;
}

bool can_follow(const PathWalk& walk) {
  return !is_off_path(walk) && !is_singular(walk) && walk.margin.value >= 0.0;
}

bool is_clear(const PathWalk& walk) {
  return can_follow(walk) && contact(walk) == nullptr;
}

JointWalk joints_along_path(const Scenario& scenario, const JointVector& q, double centering_gain) {
  JointWalk kept;
  JointVector end = q;
  kept.walk = walk_for(scenario, scenario.duration, end, centering_gain, 0.0, WalkUntil::kEnd, {}, &kept);
  return kept;
}

PathWalk walk_path(const Scenario& scenario, const JointVector& q, double centering_gain, double roll_gain,
                   WalkUntil until, const std::vector<double>& required) {
  const double walked = walked_time(scenario);
  JointVector end = q;
  PathWalk walk = walk_for(scenario, walked, end, centering_gain, roll_gain, until, required);
  if (until == WalkUntil::kLost && !can_follow(walk)) return walk;
  // A lap about the base winds a joint up, so that the next lap begins at other joint positions. If all laps
  // of the scenario together could lead to a limit, all of them are walked.
  const JointVector wound = q + scenario.duration / walked * (end - q);
  if (walked >= scenario.duration || tightest_joint(*scenario.robot, wound).margin >= 0.0) return walk;
  end = q;
  return walk_for(scenario, scenario.duration, end, centering_gain, roll_gain, until, required);
}

}  // namespace armtune::internal
