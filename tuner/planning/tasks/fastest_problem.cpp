#include "tuner/planning/tasks/fastest_problem.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armtune/error.hpp"
#include "core/trajectory/quintic.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/planning/transcription/arm_terms.hpp"
#include "tuner/planning/transcription/state_term.hpp"

namespace armtune::internal {
namespace {

/// Returns the motion of the joints and of the path coordinate in time. way: joint motion as a function of
/// the path coordinate. coordinate: path coordinate as a function of time.
Trajectory along(const Trajectory& way, const Quintic<double>& coordinate, const TimeGrid& grid) {
  const double duration = grid.phases.front().duration;
  const int intervals = grid.intervals();
  const Eigen::Index n = way.position.rows();
  Trajectory motion;
  motion.durations = {duration};
  motion.position.resize(n + 1, intervals + 1);
  motion.velocity.resize(n + 1, intervals + 1);
  motion.acceleration.setZero(n + 1, intervals + 1);
  for (int k = 0; k <= intervals; ++k) {
    const double t = duration * k / intervals;
    const MotionPoint<double> s = coordinate.at(t);
    const TrajectoryPoint at = point_at(way, way.time.front() + s.position);
    motion.time.push_back(grid.start + t);
    motion.position.col(k) << at.position, s.position;
    motion.velocity.col(k) << at.velocity * s.velocity, s.velocity;
  }
  return motion;
}

}  // namespace

PlanProblem fastest_problem(const PlanCommon& common) {
  const Scenario& scenario = common.task.scenario;
  // The path coordinate is the path's own time, over one turn.
  const double turn = scenario.path.period();
  if (turn == 0.0)
    throw InputError(
        InputPlace{shown_path(common.task.source), 0, "scenario"},
        fmt::format("the tool path of {} stands still or does not close, so that a 'fastest' task cannot "
                    "go around it; give a scenario with a closed path",
                    scenario.name))
        .with_value(scenario.name, "a scenario with a closed path");
  const double from = common.task.at;
  const ToolCurve curve = [path = scenario.path, from](double s) { return path.at(from + s); };
  PlanProblem problem;
  problem.grid = common.grid({common.phase("along the path", common.task.knots, turn)});
  problem.task = [common, curve, turn](const TimeGrid& grid) {
    TrajectoryTask program = common.on(grid);
    Coordinate s;
    s.name = "path";
    s.least_velocity = 0.0;
    s.velocity_scale = 1.0;
    s.acceleration_scale = 1.0 / kAccelerationTime;
    program.coordinates.push_back(s);
    const int last = grid.intervals();
    const auto joints = joint_names(*common.robot);
    // The motion goes from rest at the curve's start to rest at its end.
    program.terms.push_back(path_coordinate_at(0, 0.0));
    program.terms.push_back(path_coordinate_at(last, turn));
    program.terms.push_back(
        given_state("end", joints, position_units(*common.robot), last,
                    {{}, JointVector::Zero(common.n()), acceleration_at_rest(common.task)}));
    program.terms.push_back(tool_on_curve(*common.robot, {1, last}, curve, common.task.path_tolerance));
    return program;
  };
  const MovingPoint target = active_target(scenario);
  // `way` follows the path at the path's own speed. The guess runs through it from rest to rest in the
  // grid's duration.
  TimeGrid one_turn = problem.grid;
  one_turn.phases.front().duration = turn;
  const Trajectory way = follow(
      *common.robot, common.start.position, one_turn, [&](double t) { return scenario.path.at(t); }, target);
  problem.guess = along(way, rest_to_rest(0.0, turn, problem.grid.phases.front().duration), problem.grid);
  return problem;
}

}  // namespace armtune::internal
