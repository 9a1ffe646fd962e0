#pragma once
// The constraints and costs of a planning task that concern the arm: torque limits, tool on a path, gaze at a
// target, distance from obstacles. They apply at the knots of the trajectory. Lengths are divided by a
// tolerance or a radius, and torques by their limit, so that violations are relative.

#include "core/control/obstacle.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/path.hpp"
#include "sim/cell/clearance_model.hpp"
#include "tuner/planning/transcription/knot_term.hpp"

namespace armtune::internal {

/// A range of knots, both ends included.
struct KnotRange {
  int first = 0;
  int last = 0;
};

/// Returns "rad" or "m" for each joint.
std::vector<std::string> position_units(const RobotModel& robot);

/// Returns the limits |tau_i| <= margin * effort limit of every joint, by the arm's inverse dynamics.
KnotTerm torque_limits(const RobotModel& robot, KnotRange knots, double margin);

/// Returns limits that keep the tool within `tolerance` [m] of path(t) along x, y, z. With a tolerance of 0
/// they are equations: the tool is on the path, in units of 1 m.
KnotTerm tool_on_path(const RobotModel& robot, KnotRange knots, const Path& path, double tolerance);

/// Returns equations by which the tool has the velocity [m/s] and acceleration [m/s^2] of path(t).
KnotTerm tool_moves_with_path(const RobotModel& robot, int knot, const Path& path);

/// Returns a cost of the tool's squared distance from path(t); `weight` per m^2.
KnotTerm tool_path_cost(const RobotModel& robot, KnotRange knots, const Path& path, double weight);

/// Returns a limit that keeps tool z within `angle` [rad] of the line to target(t).
KnotTerm gaze_within(const RobotModel& robot, KnotRange knots, const Path& target, double angle);

/// Returns a cost of the squared sine of the angle between tool z and the line to target(t); `weight` per
/// rad^2.
KnotTerm gaze_cost(const RobotModel& robot, KnotRange knots, const Path& target, double weight);

/// Returns limits that keep the tool, and every joint origin that can move, at least `radius` [m] from the
/// obstacle's surface.
KnotTerm clear_of(const RobotModel& robot, KnotRange knots, const MovingObstacle& obstacle, double radius);

/// Largest distance demanded between links [m]: on many arms the shoulder is always close to the base.
inline constexpr double kBetweenLinks = 0.005;

/// Returns limits that keep every pair of bodies that must not touch at least `radius` [m] apart, and links
/// of the arm at least min(radius, kBetweenLinks). There is one term for each part of the cell, one for the
/// floor and one for the arm itself. Each has one row per pair.
std::vector<KnotTerm> clear_of_cell(const std::shared_ptr<const ClearanceModel>& model, KnotRange knots,
                                    double radius);

/// Returns the smallest distance [m] of the points that clear_of looks at from the surfaces of the obstacles
/// at `time` [s]; infinite without obstacles.
double clearance_at(const Chain& chain, const Poses& poses, double time,
                    const std::vector<MovingObstacle>& obstacles);

/// A curve of the tool over a coordinate s: position [m] and its derivatives by s.
using ToolCurve = std::function<MotionPoint<Vec3>(double s)>;

/// Returns limits like those of tool_on_path for the point curve(s), where s is the path coordinate.
KnotTerm tool_on_curve(const RobotModel& robot, KnotRange knots, const ToolCurve& curve, double tolerance);

}  // namespace armtune::internal
