#include "sim/scenario/task_places.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/control/measured_arm.hpp"
#include "core/control/pose_search.hpp"
#include "core/robot/holding_load.hpp"
#include "sim/scenario/walk_extremes.hpp"

namespace armtune::internal {
namespace {

struct Effort {
  unsigned samples;   ///< number of joint positions that are rated
  std::size_t tried;  ///< number of the best ones that are returned
};
constexpr Effort kQuick = {2000, 200};
constexpr Effort kThorough = {20000, 500};
constexpr double kUnlikely = 0.02;  // factor on the score of a place that is hardly usable

}  // namespace

std::vector<TaskPlace> task_places(const RobotModel& robot, TaskMask mask, double lowest, bool thorough) {
  const Effort& effort = thorough ? kThorough : kQuick;
  std::vector<TaskPlace> places;
  places.reserve(effort.samples);
  MeasuredArm arm;
  const JointVector rest = JointVector::Zero(robot.n());
  const JointVector efforts = robot.effort_limits();
  JointVector gravity;
  for (unsigned sample = 0; sample < effort.samples; ++sample) {
    TaskPlace place{sample_position(robot, sample), 0.0, 0.0};
    arm.measure(robot.chain, place.q, rest, {0.0, 1.0, 0.0}, mask);
    place.manipulability = arm.inverse.manipulability();
    const double margin = tightest_joint(robot, place.q).margin;
    const double down = 0.5 * (1.0 - height_of(arm.poses.R_0T.col(2), robot));
    const bool high = height_of(arm.poses.p_0T, robot) > lowest;
    const double load = holding_load(robot.chain, arm.poses, efforts, gravity).share;
    place.score = place.manipulability * std::min(1.0, margin / kEnoughMargin) * (0.1 + 0.9 * down) *
                  (high ? 1.0 : kUnlikely) *
                  (load < kMostLoad ? std::pow(1.0 - load, 3) : kUnlikely * kUnlikely);
    if (thorough && !(high && load < kMostLoad)) continue;
    places.push_back(std::move(place));
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const TaskPlace& a, const TaskPlace& b) { return a.score > b.score; });
  if (places.size() > effort.tried) places.resize(effort.tried);
  return places;
}

}  // namespace armtune::internal
