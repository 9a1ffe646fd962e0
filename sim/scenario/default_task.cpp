#include "sim/scenario/default_task.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "armtune/error.hpp"
#include "core/control/pose_search.hpp"
#include "core/robot/holding_load.hpp"
#include "sim/scenario/holding_torques.hpp"
#include "sim/scenario/path_walk.hpp"
#include "sim/scenario/start_of_task.hpp"
#include "sim/scenario/task_places.hpp"

namespace armtune::internal {
namespace {

constexpr int kHalvings = 3;
constexpr double kRadius = 0.09;     // radius of the circle, as a share of the reach
constexpr double kAhead = 0.35;      // distance of the targets ahead of the tool, as a share of the reach
constexpr double kNearest = 0.15;    // the smallest such distance, if the floor is closer than kAhead
constexpr double kApart = 0.1;       // distance of a target from the middle, as a share of the reach
constexpr double kAboveFloor = 0.1;  // m, smallest height
constexpr double kFolded = 0.08;     // smallest distance from the tool to the arm, as a share of the reach
constexpr double kFromCell = 0.05;   // m, smallest distance of a link from its surroundings
constexpr double kLightLoad = 0.5;   // share of an effort limit that is allowed on the way to the task
constexpr int kStartHalvings = 5;    // largest number of halvings of the start's distance from the goal
constexpr double kModelScale = 0.8;  // parameters with which the controller starts, as a share of the model's
constexpr double kTurn = 10.0;       // s, one lap of the circle
constexpr double kDuration = 30.0;   // s
constexpr double kSwitch = 7.5;      // s, between target switches
constexpr double kCentering = 0.2;   // 1/s
constexpr double kSingular = 1e-4;   // m^3, for a reach of 1 m: a smaller manipulability counts as singular

/// Returns the height of the floor [m], or -infinity if there is no floor.
double floor_of(const RobotModel& robot, const TaskOptions& options) {
  const double none = -std::numeric_limits<double>::infinity();
  if (options.cell) return options.cell->floor.value_or(none);
  return options.floor.value_or(assumes_floor(robot, options) ? 0.0 : none);
}

/// Rounds to three decimals, as a person would write the number.
double rounded(double x) {
  return std::round(x * 1e3) / 1e3;
}
Vec3 rounded(const Vec3& x) {
  return {rounded(x.x()), rounded(x.y()), rounded(x.z())};
}

/// Returns the distance of the targets ahead of the tool [m]. It is reduced if the lower target would
/// otherwise be below the floor.
double distance_ahead(const Poses& poses, const RobotModel& robot, double floor, double size) {
  const double down = -height_of(poses.R_0T.col(2), robot);
  const double aside = kApart * size * std::abs(height_of(poses.R_0T.col(0), robot));
  const double height = height_of(poses.p_0T, robot) - aside - floor;
  return down * kAhead * size > height ? height / down : kAhead * size;
}

void put_task(const Poses& poses, double ahead, double size, double shrunk, Scenario& scenario) {
  const Vec3 center = rounded(poses.p_0T);
  const double radius = kRadius * size * shrunk;
  scenario.path.center = center;
  scenario.path.terms = {
      {1, rounded(Vec3(radius * poses.R_0T.col(0))), rounded(Vec3(radius * poses.R_0T.col(1)))}};
  const Vec3 middle = center + ahead * poses.R_0T.col(2);
  const Vec3 aside = kApart * size * shrunk * poses.R_0T.col(0);
  scenario.targets = {{"left", {rounded(Vec3(middle + aside)), 0.0, 0.0, {}}},
                      {"right", {rounded(Vec3(middle - aside)), 0.0, 0.0, {}}}};
}

/// Finds places for circle, targets, goal and start, and remembers why other places were rejected.
class Placing {
 public:
  Placing(DefaultTask& task, double floor, bool thorough)
      : task_(task), arm_(*task.scenario.robot), floor_(floor), thorough_(thorough), size_(reach(arm_)) {
    if (!task_.scenario.clearance) return;
    const ClearanceModel& model = *task_.scenario.clearance;
    for (const ContactPair& pair : model.pairs()) {
      // In every task, the first two links are close to where the arm is mounted.
      const bool counts = pair.of != Clearance::kSelf && model.arm().solids[pair.solid].body > 1;
      required_.push_back(counts ? kFromCell : -std::numeric_limits<double>::infinity());
    }
  }

  /// Returns tasks at the first places that fit, at most `count`.
  std::vector<DefaultTask> first(std::size_t count) {
    std::vector<DefaultTask> found;
    const double lowest = floor_ + kAboveFloor + kRadius * size_;
    const std::vector<TaskPlace> places = task_places(arm_, task_.scenario.mask, lowest, thorough_);
    // A smaller circle is preferred to one that leads close to a joint's limit.
    std::set<std::pair<int, std::size_t>> close;  // (halvings, place): rejected for the margin alone
    for (int halving = 0; halving <= kHalvings; ++halving) {
      for (std::size_t k = 0; k < places.size(); ++k) {
        const Fit fit = place_at(places[k], 1.0 / (1 << halving), 0.5 * kEnoughMargin);
        if (fit == Fit::kCloseToALimit) close.emplace(halving, k);
        if (fit != Fit::kGood) continue;
        found.push_back(task_);
        if (found.size() == count) return found;
      }
    }
    for (const auto& [halving, k] : close) {
      if (place_at(places[k], 1.0 / (1 << halving), 0.2 * kEnoughMargin) != Fit::kGood) continue;
      found.push_back(task_);
      if (found.size() == count) return found;
    }
    return found;
  }

  /// Returns the reason why circles that the arm could follow were rejected; empty if there were none.
  std::string obstacle() const {
    if (lightest_.value < PathWalk::kUnseen) {
      const JointInfo& joint = arm_.joints[static_cast<std::size_t>(loaded_)];
      const char* unit = effort_unit(arm_, loaded_);
      const double effort = joint.limits.effort;
      const Vec3& tool = lightest_.tool;
      return fmt::format(
          "joint '{}' needs {:.3g} {} to hold the arm with its tool at ({:.3g}, {:.3g}, {:.3g}) m, and its "
          "effort limit is {:.3g} {}. A first task may need at most {:.0f} % of a limit, but no place with a "
          "lower load was found; check this limit and the masses",
          joint.name, lightest_.value * effort, unit, tool.x(), tool.y(), tool.z(), effort, unit,
          100.0 * kMostLoad);
    }
    if (nears_ > lows_) return fmt::format("on the circles that {} can follow, {}", arm_.name, near_);
    if (lows_ > 0) {
      return fmt::format(
          "the circles that {} can follow are less than {} m above the floor, which is at a height of {:.3g} "
          "m in the base frame; if the floor is lower, give its height with --floor",
          arm_.name, kAboveFloor, floor_);
    }
    return folded_ ? fmt::format("on the circles that {} can follow, the arm comes too close to itself",
                                 arm_.name)
                   : "";
  }

 private:
  enum class Fit { kNone, kCloseToALimit, kGood };

  /// least_margin: smallest distance from a joint's limits on the whole task, as a share of its range.
  Fit place_at(const TaskPlace& place, double shrunk, double least_margin) {
    if (!(place.manipulability > kSingular * std::pow(size_, 3))) return Fit::kNone;
    Scenario& scenario = task_.scenario;
    Poses poses;
    forward_kinematics(arm_.chain, place.q, poses);
    const double ahead = distance_ahead(poses, arm_, floor_, size_);
    if (ahead < kNearest * size_) {
      ++lows_;
      return Fit::kNone;
    }
    put_task(poses, ahead, size_, shrunk, scenario);
    // At the place, the tool is at the centre of the circle. The goal is where the circle begins.
    task_.goal = place.q;
    ToolGoal begin{scenario.path.at(0.0).position, {}};
    if (tracks_orientation(scenario.mask)) begin.target = scenario.targets[0].path.center;
    if (!reach_goal(arm_, begin, task_.goal)) return Fit::kNone;
    const PathWalk walk = walk_path(scenario, task_.goal, kCentering, 0.0, WalkUntil::kLost, required_);
    if (touches(walk) || !is_clear(walk)) return Fit::kNone;
    if (walk.margin.value < least_margin) return Fit::kCloseToALimit;
    if (!is_free(walk)) return Fit::kNone;
    task_.manipulability = walk.manipulability.value;
    task_.load = walk.load.value;
    task_.loaded = walk.loaded;
    scenario.start_position = start_off(task_.goal);
    return Fit::kGood;
  }

  /// Returns start positions (n) off the goal. They are moved closer to the goal if the way to it loads a
  /// joint more than the task does and more than kLightLoad.
  JointVector start_off(const JointVector& goal) const {
    const Chain loaded = with_payload(arm_, task_.scenario.plant.payload).chain;
    const JointVector efforts = arm_.effort_limits();
    const double most = std::max(task_.load, kLightLoad);
    JointVector away = off_goal(arm_, goal) - goal;
    for (int halving = 0; halving < kStartHalvings; ++halving, away *= 0.5) {
      double load = 0.0;
      for (const double share : {0.25, 0.5, 0.75, 1.0})
        load = std::max(load, holding_load(loaded, JointVector(goal + share * away), efforts).share);
      if (load <= most) break;
    }
    return goal + away;
  }

  /// Returns true if the arm touches something on a walk that it could follow otherwise, and remembers what.
  bool touches(const PathWalk& walk) {
    if (!can_follow(walk)) return false;
    for (const LeastClearance& least : walk.nearest) {
      if (least.pair == nullptr || least.distance > 0.0) continue;
      if (least.pair->of == Clearance::kSelf) folded_ = true;
      if (least.pair->of == Clearance::kFloor) ++lows_;
      if (least.pair->of == Clearance::kCell) {
        near_ = task_.scenario.clearance->name(*least.pair) + " touch";
        ++nears_;
      }
      return true;
    }
    return false;
  }

  /// Returns a clause that names all bodies that come too close to each other; empty if there are none.
  std::string too_near(const PathWalk& walk) const {
    std::vector<std::string> pairs;
    for (const LeastClearance& least : walk.too_near)
      pairs.push_back(
          fmt::format("{} ({:.2g} m)", task_.scenario.clearance->name(*least.pair), least.distance));
    if (pairs.empty()) return {};
    return fmt::format("{} come closer than {} m to each other", fmt::join(pairs, ", "), kFromCell);
  }

  /// Returns true if a walk without contact keeps all distances and no load on it is too large. Otherwise
  /// remembers the reason.
  bool is_free(const PathWalk& walk) {
    if (walk.low.value < floor_ + kAboveFloor) {
      ++lows_;
      return false;
    }
    if (walk.fold.value < kFolded * size_) {
      folded_ = true;
      return false;
    }
    if (const std::string near = too_near(walk); !near.empty()) {
      near_ = near;
      ++nears_;
      return false;
    }
    if (walk.load.value <= kMostLoad) return true;
    if (walk.load.value < lightest_.value) {
      lightest_ = walk.load;
      loaded_ = walk.loaded;
    }
    return false;
  }

  DefaultTask& task_;
  const RobotModel& arm_;
  double floor_;
  bool thorough_;
  double size_;
  WalkPlace lightest_{0.0, Vec3::Zero(),
                      PathWalk::kUnseen};  ///< smallest load of the walks rejected for their load alone
  int loaded_ = 0;                         ///< joint with this load
  std::vector<double> required_;           ///< distance of each pair below which it is too near [m]
  std::string near_;                       ///< clause about bodies that come too close
  int lows_ = 0;                           ///< number of places that are too low
  int nears_ = 0;                          ///< number of places where bodies come too close
  bool folded_ = false;
};

}  // namespace

bool assumes_floor(const RobotModel& robot, const TaskOptions& options) {
  return !options.floor && !options.cell && !options.without_floor && height_of(Vec3::UnitZ(), robot) > 0.5;
}

DefaultTask default_task(std::shared_ptr<const RobotModel> robot, const TaskOptions& options) {
  return default_tasks(std::move(robot), options, 1).front();
}

std::vector<DefaultTask> default_tasks(std::shared_ptr<const RobotModel> robot, const TaskOptions& options,
                                       std::size_t count) {
  DefaultTask task;
  Scenario& scenario = task.scenario;
  scenario.name = "task";
  scenario.robot = std::move(robot);
  const RobotModel& arm = *scenario.robot;
  refuse_too_heavy(arm, kMostLoad);  // without the search, which would take long
  Cell cell = options.cell.value_or(Cell{});
  if (const double floor = floor_of(arm, options); std::isfinite(floor)) cell.floor = floor;
  scenario.clearance = std::make_shared<const ClearanceModel>(scenario.robot, std::move(cell));
  task.in_given_cell = options.cell.has_value();
  task.without_floor = options.without_floor;
  // If the arm's shapes are not known, there are no distances to compute.
  if (scenario.clearance->pairs().empty()) scenario.clearance.reset();
  // A slow task is as long as it needs to be for two laps, and for both targets and the first one again.
  scenario.duration = std::max({kDuration, 2.0 * kTurn * options.slowness, 3.0 * kSwitch * options.slowness});
  scenario.control_period = 0.002;
  scenario.switch_every = kSwitch * options.slowness;
  scenario.path.frequency = 2.0 * M_PI / (kTurn * options.slowness);
  scenario.theta.model_scale = kModelScale;
  scenario.plant.position_noise = 1e-4;
  scenario.plant.velocity_noise = 0.01;
  scenario.plant.torque_delay_periods = 1;
  double mass = 0.0;
  for (int i = 0; i < arm.n(); ++i) mass += arm.chain.link[static_cast<std::size_t>(i)].mass;
  scenario.plant.payload.mass = rounded(0.02 * mass);
  std::string obstacle;
  // The gaze leaves the roll about the tool's z axis free, and therefore needs one joint less than a pose.
  for (const TaskMask mask : {TaskMask::kPositionAndAxis, TaskMask::kPosition}) {
    scenario.mask = mask;
    if (components(mask) > arm.n()) continue;
    if (options.mask && mask != *options.mask) continue;
    Placing placing(task, floor_of(arm, options), options.thorough);
    if (auto found = placing.first(count); !found.empty()) return found;
    if (obstacle.empty()) obstacle = placing.obstacle();
  }
  if (obstacle.empty() && arm.n() < components(TaskMask::kPosition))
    obstacle = fmt::format("{} joints are too few; a first task needs at least three", arm.n());
  throw InputError(
      InputPlace{arm.source},
      fmt::format(
          "no first task was found for {}, not even a circle with a radius of {:.2g} m{}{}. You can also "
          "write a scenario with your own path",
          arm.name, kRadius * reach(arm) / (1 << kHalvings), obstacle.empty() ? "" : ": ", obstacle));
}

}  // namespace armtune::internal
