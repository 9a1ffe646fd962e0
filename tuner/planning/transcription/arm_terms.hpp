#pragma once
// What a task asks of the arm at a knot: torque limits, tool on a path, gaze at a target, distance from
// obstacles. Lengths count relative to a tolerance or a radius, torques to their limit, so that violations
// are relative.

#include "core/control/obstacle.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/path.hpp"
#include "sim/cell/clearance_model.hpp"
#include "tuner/planning/transcription/knot_term.hpp"

namespace armtune::internal {

struct KnotRange {
  int first = 0;
  int last = 0;
};

/// "rad" or "m" for each joint.
std::vector<std::string> position_units(const RobotModel& robot);

/// |tau_i| <= margin * limit of every joint, by the arm's inverse dynamics.
KnotTerm torque_limits(const RobotModel& robot, KnotRange knots, double margin);

/// Tool within `tolerance` [m] of path(t) along x, y, z; 0: on it, in units of 1 m.
KnotTerm tool_on_path(const RobotModel& robot, KnotRange knots, const Path& path, double tolerance);

/// The tool moves with path(t): velocity and acceleration are the path's own [m/s, m/s^2].
KnotTerm tool_moves_with_path(const RobotModel& robot, int knot, const Path& path);

/// Cost: the tool's distance from path(t); `weight` per (m^2).
KnotTerm tool_path_cost(const RobotModel& robot, KnotRange knots, const Path& path, double weight);

/// Tool z within `angle` [rad] of the line to target(t).
KnotTerm gaze_within(const RobotModel& robot, KnotRange knots, const Path& target, double angle);

/// Cost: the sine of the angle between tool z and the line to target(t); `weight` per (rad^2).
KnotTerm gaze_cost(const RobotModel& robot, KnotRange knots, const Path& target, double weight);

/// Every joint's origin that can move, and the tool, at least `radius` [m] from the obstacle's surface.
KnotTerm clear_of(const RobotModel& robot, KnotRange knots, const MovingObstacle& obstacle, double radius);

/// Between links no more than this is asked for [m]: on many arms the shoulder is always close to the base.
inline constexpr double kBetweenLinks = 0.005;

/// Every pair of bodies that must not meet at least `radius` [m] apart, links of the arm kBetweenLinks at
/// most: a term for each part of the cell, one for the floor and one for the arm itself, with a row for each
/// pair.
std::vector<KnotTerm> clear_of_cell(const std::shared_ptr<const ClearanceModel>& model, KnotRange knots,
                                    double radius);

/// Returns the smallest distance [m] of the points that clear_of looks at from the surfaces of the obstacles
/// at `time` [s]; infinite without obstacles.
double clearance_at(const Chain& chain, const Poses& poses, double time,
                    const std::vector<MovingObstacle>& obstacles);

/// A curve of the tool over a coordinate s: position [m] and its derivative.
using ToolCurve = std::function<MotionPoint<Vec3>(double s)>;

/// Tool at curve(s) in x, y, z, s being the path coordinate.
KnotTerm tool_on_curve(const RobotModel& robot, KnotRange knots, const ToolCurve& curve, double tolerance);

}  // namespace armtune::internal
