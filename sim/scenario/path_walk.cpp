#include "sim/scenario/path_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "armtune/error.hpp"
#include "core/control/laws/starting_gains.hpp"
#include "core/control/pose_search.hpp"
#include "core/control/task_goal.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal {
namespace {

constexpr double kStep = 0.02;         // s
constexpr double kLongestStep = 0.05;  // s: TaskGoal's errors die at 3 /s
constexpr long kMostSteps = 20000;     // thirty walks of them take seconds
constexpr double kMillimetres = 20.0;  // times the reach: no path in metres lies there
constexpr double kOffPath = 1e-3;      // m: the inverse kinematics itself is a hundred times closer
constexpr double kSingular = 0.02;     // of the largest manipulability of the walk
constexpr double kAway = 20.0 * M_PI / 180.0;
constexpr double kAwaySliding = 0.1;   // m
constexpr double kAwayShare = 0.1;     // of the range, at most
constexpr double kCentering = 0.2;     // 1/s, where no gains are known
constexpr double kEnoughMargin = 0.1;  // of the range: more is no better
constexpr unsigned kPlacesTried = 30;
constexpr int kTimesLooked = 20;    // at a path that was lost, for where it cannot be reached at all
constexpr double kAtTarget = 0.02;  // m: as close no gaze can turn as fast as the line does

/// Whether nothing in the cell moves.
bool parts_rest(const Scenario& scenario) {
  if (!scenario.clearance) return true;
  const auto& parts = scenario.clearance->cell().parts;
  return std::all_of(parts.begin(), parts.end(), [](const CellPart& part) { return part.path.rests(); });
}

/// One turn is as good as many where nothing else moves.
double walked_time(const Scenario& scenario) {
  const bool targets_rest =
      parts_rest(scenario) && std::all_of(scenario.targets.begin(), scenario.targets.end(),
                                          [](const NamedPath& target) { return target.path.rests(); });
  const double rest = scenario.next_switch(0.0) < scenario.duration ? scenario.duration : 1.0;
  // A turn through waypoints does not come round with the path.
  const bool turns = scenario.orientation && scenario.orientation->turn;
  if (!targets_rest || turns) return scenario.duration;
  if (scenario.path.rests()) return std::min(scenario.duration, rest);
  const double turn = scenario.path.period();
  return turn > 0.0 ? std::min(scenario.duration, std::max(rest, turn)) : scenario.duration;
}

ToolGoal goal_at(const Scenario& scenario, double time) {
  ToolGoal goal{scenario.path.at(time).position, {}};
  if (!tracks_orientation(scenario.mask)) return goal;
  if (!scenario.orientation) {
    goal.target = scenario.targets[scenario.active_target(time)].path.at(time).position;
    return goal;
  }
  const Eigen::Quaterniond wanted = scenario.orientation->at(time, scenario.path).orientation;
  // Of an axis alone: a point that it passes.
  if (scenario.mask == TaskMask::kPositionAndAxis) goal.target = goal.tool + wanted * Vec3::UnitZ();
  if (scenario.mask == TaskMask::kPose) goal.orientation = wanted;
  return goal;
}

ToolGoal beginning(const Scenario& scenario) {
  return goal_at(scenario, scenario.start_time);
}

/// The smallest distance from the goal's place that the tool was found to have, however it is turned [m].
double closest(const RobotModel& robot, const ToolGoal& goal) {
  double least = std::numeric_limits<double>::infinity();
  Poses poses;
  for (unsigned start = 0; start < kPlacesTried && least > kOffPath; ++start) {
    JointVector q = sample_position(robot, start);
    reach_goal(robot, {goal.tool, {}}, q);
    forward_kinematics(robot.chain, q, poses);
    least = std::min(least, (poses.p_0T - goal.tool).norm());
  }
  return least;
}

/// Whether the arm can have its tool there at all, on whatever way.
bool can_reach(const RobotModel& robot, const ToolGoal& goal) {
  for (unsigned start = 0; start < kPlacesTried; ++start) {
    JointVector q = sample_position(robot, start);
    if (reach_goal(robot, goal, q)) return true;
  }
  return false;
}

bool is_off_path(const PathWalk& walk) {
  return !(walk.error.value <= kOffPath);
}
bool is_singular(const PathWalk& walk) {
  return !(walk.manipulability.value >= kSingular * walk.largest_manipulability);
}

/// Where the arm touches itself or its cell; null: nowhere.
const LeastClearance* contact(const PathWalk& walk) {
  for (const LeastClearance& least : walk.nearest) {
    if (least.distance < 0.0) return &least;
  }
  return nullptr;
}

/// How deep the arm comes into itself or its cell [m].
double depth(const PathWalk& walk) {
  double deepest = 0.0;
  for (const LeastClearance& least : walk.nearest) deepest = std::max(deepest, -least.distance);
  return deepest;
}

}  // namespace

bool can_follow(const PathWalk& walk) {
  return !is_off_path(walk) && !is_singular(walk) && walk.margin.value >= 0.0;
}

bool is_clear(const PathWalk& walk) {
  return can_follow(walk) && contact(walk) == nullptr;
}

namespace {

/// What the tool is to aim at. `wanted` keeps the orientation that it points to.
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

/// Over `walked` seconds; the joints that it ends with are left in q.
PathWalk walk_for(const Scenario& scenario, double walked, JointVector& q, double centering_gain,
                  double roll_gain, WalkUntil until) {
  const RobotModel& robot = *scenario.robot;
  const double scale = std::min(1.0, std::pow(reach(robot), 3));
  const InverseDamping damping{1e-3 * scale, 1e-3 * scale, 1.0};
  const JointCentering centering = joint_centering(robot, centering_gain);
  RollCentering roll(robot, scenario.orientation ? 0.0 : roll_gain, scenario.mask);
  const bool looks = tracks_orientation(scenario.mask) && !scenario.orientation;
  TaskGoal motion;
  motion.start(q);
  MeasuredArm arm;
  WalkExtremes extremes(scenario, kOffPath);
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
    walk.steps = k;
    walk.ended = time;
    q = joints.position;
    if (!std::isfinite(walk.error.value)) break;
    if (until == WalkUntil::kLost && (is_off_path(walk) || walk.margin.value < 0.0)) break;
  }
  return walk;
}

}  // namespace

PathWalk walk_path(const Scenario& scenario, const JointVector& q, double centering_gain, double roll_gain,
                   WalkUntil until) {
  const double walked = walked_time(scenario);
  JointVector end = q;
  PathWalk walk = walk_for(scenario, walked, end, centering_gain, roll_gain, until);
  if (until == WalkUntil::kLost && !can_follow(walk)) return walk;
  // A lap about the base winds a joint up: the next one does not begin where this one did. Where as many as
  // there are may lead to a limit, all of them are gone.
  const JointVector wound = q + scenario.duration / walked * (end - q);
  if (walked >= scenario.duration || tightest_joint(*scenario.robot, wound).margin >= 0.0) return walk;
  end = q;
  return walk_for(scenario, scenario.duration, end, centering_gain, roll_gain, until);
}

namespace {

std::string place(const WalkPlace& at) {
  return fmt::format("at {:.4g} s, tool at ({:.4g}, {:.4g}, {:.4g}) m", at.time, at.tool.x(), at.tool.y(),
                     at.tool.z());
}

/// Where the arm cannot have its tool at all, from where the walk lost the path on; empty: nowhere there.
std::string out_of_reach(const PathWalk& walk, const Scenario& scenario) {
  WalkPlace farthest;
  std::optional<WalkPlace> turned_wrong;
  for (int look = 0; look < kTimesLooked; ++look) {
    const double time = walk.left.time + (walk.ended - walk.left.time) * look / (kTimesLooked - 1);
    const ToolGoal goal = goal_at(scenario, time);
    const double distance = closest(*scenario.robot, goal);
    if (distance > std::max(kOffPath, farthest.value)) farthest = {time, goal.tool, distance};
    if (distance <= kOffPath && !turned_wrong && !can_reach(*scenario.robot, goal))
      turned_wrong = {time, goal.tool, 0.0};
  }
  const char* how = !tracks_orientation(scenario.mask) ? ""
                    : scenario.orientation             ? " with the tool turned as it is to be"
                                                       : " with the tool's z axis on the target";
  if (farthest.value > kOffPath) {
    return fmt::format(
        "the path leaves the workspace of {}, from {:.4g} s on: {} it comes no closer than {:.3g} m; move or "
        "shrink the path",
        scenario.robot->name, walk.left.time, place(farthest), farthest.value);
  }
  if (!turned_wrong) return {};
  return fmt::format(
      "the path leaves the workspace of {}{}, {}: within its joint limits it cannot; move or shrink the "
      "path, or turn the "
      "tool otherwise",
      scenario.robot->name, how, place(*turned_wrong));
}

}  // namespace

std::string trouble(const PathWalk& walk, const Scenario& scenario) {
  if (is_clear(walk)) return {};
  if (walk.sight.value < kAtTarget) {
    return fmt::format(
        "the tool passes the target that it looks at, {}, {:.3g} m from it; move the path or the target",
        place(walk.sight), walk.sight.value);
  }
  // A path that leaves the workspace stretches the arm into a singularity, but off one within it the damped
  // inverse alone may lead.
  if (is_off_path(walk)) {
    if (std::string beyond = out_of_reach(walk, scenario); !beyond.empty()) return beyond;
  }
  if (is_singular(walk)) {
    return fmt::format(
        "the path runs through a singularity of {}: {} manipulability is {:.3g}, elsewhere on it up to "
        "{:.3g}; "
        "move the path, or give another start",
        scenario.robot->name, place(walk.manipulability), walk.manipulability.value,
        walk.largest_manipulability);
  }
  if (is_off_path(walk)) {
    return fmt::format(
        "from its start {} cannot keep to the path, {} by {:.3g} m, though it can have its tool there; move "
        "the path, or "
        "give another start",
        scenario.robot->name, place(walk.error), walk.error.value);
  }
  if (walk.margin.value >= 0.0) {
    const LeastClearance& touched = *contact(walk);
    return fmt::format("on the path {} touch, at {:.4g} s; move the path, or give another start",
                       scenario.clearance->name(*touched.pair), touched.time);
  }
  return fmt::format(
      "on the path {} leaves its limits by {:.2g} of its range, {}; move the path, or give another start",
      scenario.robot->joints[static_cast<std::size_t>(walk.joint)].name, -walk.margin.value,
      place(walk.margin));
}

JointVector best_start_of_task(const Scenario& scenario) {
  const ToolGoal goal = beginning(scenario);
  const auto best =
      best_pose(*scenario.robot, goal, sample_position(*scenario.robot, 0), [&](const JointVector& q) {
        const PathWalk walk = walk_path(scenario, q, kCentering);
        const double ease = walk.manipulability.value * std::min(1.0, walk.margin.value / kEnoughMargin);
        // Where the whole walk fails, still the pose that does best.
        return is_clear(walk) ? ease
                              : -1.0 - walk.error.value - std::max(0.0, -walk.margin.value) - depth(walk);
      });
  if (best) return *best;
  const Vec3& tool = goal.tool;
  throw InputError(
      fmt::format("{}: {} cannot have its tool at ({:.4g}, {:.4g}, {:.4g}) m, where the path begins{}, "
                  "within its joint limits; move "
                  "the path, or give start_position_deg{}",
                  shown_path(scenario.source), scenario.robot->name, tool.x(), tool.y(), tool.z(),
                  scenario.orientation ? ", turned as it is to be"
                  : goal.target        ? ", with its z axis on the target"
                                       : "",
                  tool.norm() > kMillimetres * reach(*scenario.robot)
                      ? "; if these are millimetres, say so: units: {length: mm}"
                      : ""));
}

TaskTrouble find_task_trouble(const Scenario& scenario, const Gains& gains) {
  if (scenario.planned) return {};
  JointVector q = in_si(*scenario.robot, with_goal(gains, scenario).joint_space_goal);
  if (!reach_goal(*scenario.robot, beginning(scenario), q)) {
    try {
      q = best_start_of_task(scenario);
    } catch (const InputError& error) {
      return {error.what()};
    }
  }
  const PathWalk walk = walk_path(scenario, q, gains.joint_centering_gain, gains.roll_centering_gain);
  const bool leaves_limits = !is_off_path(walk) && !is_singular(walk) && walk.margin.value < 0.0;
  // The roll of a gaze drifts by itself, which moves the last joint; a roll control would hold it.
  const bool roll_drifts = walk.joint == scenario.robot->n() - 1 &&
                           RollCentering(*scenario.robot, 1.0, scenario.mask).is_on() &&
                           !scenario.orientation && gains.roll_centering_gain == 0.0;
  return {trouble(walk, scenario), leaves_limits && !roll_drifts};
}

JointVector off_goal(const RobotModel& robot, const JointVector& goal) {
  JointVector start = goal;
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointLimits& limits = robot.joints[k].limits;
    const bool slides = robot.chain.motion[k] == JointMotion::kPrismatic;
    double away = slides ? kAwaySliding : kAway;
    if (limits.has_position) away = std::min(away, kAwayShare * (limits.upper - limits.lower));
    const double middle = limits.has_position ? 0.5 * (limits.lower + limits.upper) : 0.0;
    start[i] += goal[i] > middle ? -away : away;
  }
  return start;
}

}  // namespace armtune::internal
