#include "tuner/planning/tasks/plan_common.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/scenario/data_files.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"
#include "tuner/planning/transcription/state_term.hpp"

namespace armtune::internal {
namespace {

constexpr double kShortest = 2e-3;   // least value of a free duration [s]
constexpr double kLongest = 100.0;   // greatest value of a free duration, relative to its first guess
constexpr double kLeastGuess = 0.2;  // least first guess of a duration [s]

}  // namespace

std::vector<Coordinate> PlanCommon::coordinates() const {
  const std::vector<std::string> units = position_units(*robot);
  const JointVector acceleration = acceleration_limits(task);
  std::vector<Coordinate> found;
  for (int i = 0; i < n(); ++i) {
    const JointInfo& joint = robot->joints[static_cast<std::size_t>(i)];
    Coordinate c;
    c.name = joint.name;
    c.unit = units[static_cast<std::size_t>(i)];
    if (joint.limits.has_position) {
      c.lower = joint.limits.lower;
      c.upper = joint.limits.upper;
    }
    c.velocity = task.limits.velocity * joint.limits.velocity;
    c.acceleration = acceleration[i];
    if (task.limits.jerk.size() > 0) c.jerk = task.limits.jerk[i];
    c.velocity_scale = c.velocity;
    c.acceleration_scale = std::min(c.acceleration, c.velocity / kAccelerationTime);
    found.push_back(c);
  }
  return found;
}

TrajectoryTask PlanCommon::on(const TimeGrid& grid) const {
  TrajectoryTask program;
  program.chain = robot->chain;
  program.grid = grid;
  program.coordinates = coordinates();
  // If neither time nor errors have a cost, the smoothest motion is wanted. At equal velocities, jerk is
  // proportional to 1/T^2, and the integral of its square to 1/T^3. Hence the factor T^3.
  const bool errors_cost = task.kind == PlanKind::kTrack || task.least_error;
  program.smoothness.jerk = task.duration && !errors_cost ? std::pow(*task.duration, 3) : task.smoothness;
  program.duration_cost = 1.0;
  const int last = grid.intervals();
  program.terms.push_back(given_state("start", joint_names(*robot), position_units(*robot), 0,
                                      {start.position, start.velocity, start.acceleration}));
  program.terms.back().hard = true;  // the start state is given, and must never be violated
  program.terms.push_back(torque_limits(*robot, {0, last}, task.limits.effort));
  if (task.clearance > 0.0) {
    for (const MovingObstacle& obstacle : task.scenario.obstacles)
      program.terms.push_back(clear_of(*robot, {0, last}, obstacle, task.clearance));
    if (task.scenario.clearance) {
      for (KnotTerm& term : clear_of_cell(task.scenario.clearance, {0, last}, task.clearance))
        program.terms.push_back(std::move(term));
    }
  }
  return program;
}

Phase PlanCommon::phase(const char* name, int intervals, double guess) const {
  return task.duration ? Phase{name, intervals, *task.duration, false}
                       : Phase{name, intervals, guess, true, kShortest, kLongest * guess};
}

TimeGrid PlanCommon::grid(std::vector<Phase> phases) const {
  TimeGrid made;
  made.start = task.at;
  made.phases = std::move(phases);
  return made;
}

void PlanCommon::no_pose(const Vec3& tool) const {
  const std::string point = fmt::format("({:.4g}, {:.4g}, {:.4g}) m", tool.x(), tool.y(), tool.z());
  throw OutOfReach(
      InputPlace{shown_path(task.source), 0, "scenario"},
      InputFault{.problem = fmt::format(
                     "within its joint limits, {} cannot place its tool at {} (with the tool's z axis on the "
                     "gaze target, if the task requires it); move the path",
                     robot->name, point),
                 .value = point});
}

double PlanCommon::first_duration(double otherwise) const {
  if (task.duration) return *task.duration;
  if (controller && controller->reached) return std::max(kLeastGuess, *controller->reached);
  return otherwise;
}

double PlanCommon::turning_time() const {
  double longest = 0.0;
  const std::vector<Coordinate> joints = coordinates();
  for (int i = 0; i < n(); ++i) {
    const double braking =
        std::abs(start.velocity[i]) / joints[static_cast<std::size_t>(i)].acceleration_scale;
    longest = std::max(longest, 2.0 * braking);
  }
  return longest;
}

double PlanCommon::likely_duration(const JointVector& way) const {
  return std::max(
      kLeastGuess,
      (way.array().abs() / (0.5 * task.limits.velocity * robot->velocity_limits().array())).maxCoeff());
}

}  // namespace armtune::internal
