#pragma once
// Makes the constraints and costs of a planning task that concern the arm: torque limits, tool on a path,
// gaze (the tool's z axis) at a target, distance from obstacles. They apply at the knots (points) of the
// trajectory's time grid. Lengths are divided by a tolerance or a radius, and torques by their limit, so that
// violations are relative.

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

/// Returns torque limits for every joint: |tau_i|, computed by inverse dynamics, is at most `margin` times
/// the effort limit. margin: share of the effort limits that may be used.
KnotTerm torque_limits(const RobotModel& robot, KnotRange knots, double margin);

/// Returns limits that keep the tool within `tolerance` [m] of path(t) along x, y, z. If the tolerance is 0,
/// the result is equations, in units of 1 m, that keep the tool exactly on the path.
KnotTerm tool_on_path(const RobotModel& robot, KnotRange knots, const Path& path, double tolerance);

/// Returns equations that give the tool the velocity [m/s] and the acceleration [m/s^2] of path(t).
KnotTerm tool_moves_with_path(const RobotModel& robot, int knot, const Path& path);

/// Returns a cost of the tool's squared distance from path(t); `weight` per m^2.
KnotTerm tool_path_cost(const RobotModel& robot, KnotRange knots, const Path& path, double weight);

/// Returns a limit that keeps the tool's z axis within `angle` [rad] of the line to target(t).
KnotTerm gaze_within(const RobotModel& robot, KnotRange knots, const Path& target, double angle);

/// Returns a cost of the squared sine of the angle between the tool's z axis and the line to target(t);
/// `weight` per rad^2.
KnotTerm gaze_cost(const RobotModel& robot, KnotRange knots, const Path& target, double weight);

/// Returns limits that keep the tool, and every joint origin that can move, at least `radius` [m] from the
/// obstacle's surface.
KnotTerm clear_of(const RobotModel& robot, KnotRange knots, const MovingObstacle& obstacle, double radius);

/// Largest distance required between links [m]. It is small because the shoulder of many arms is always close
/// to the base.
inline constexpr double kBetweenLinks = 0.005;

/// Returns limits on the distances between bodies that must not touch. The links of the arm stay at least
/// `radius` [m] from the floor and from each part of the cell (the bodies around the arm). Two links of the
/// arm stay at least min(radius, kBetweenLinks) apart. There is one term for each part of the cell, one for
/// the floor and one for the arm itself. Each term has one row per pair of bodies.
std::vector<KnotTerm> clear_of_cell(const std::shared_ptr<const ClearanceModel>& model, KnotRange knots,
                                    double radius);

/// Returns the smallest distance [m] of the tool, and of every joint origin that can move, from the surfaces
/// of the obstacles at `time` [s]; infinite without obstacles.
double clearance_at(const Chain& chain, const Poses& poses, double time,
                    const std::vector<MovingObstacle>& obstacles);

/// A curve for the tool: its position [m], with derivatives, as a function of the coordinate s.
using ToolCurve = std::function<MotionPoint<Vec3>(double s)>;

/// Returns limits like those of tool_on_path for the point curve(s), where s is the path coordinate.
KnotTerm tool_on_curve(const RobotModel& robot, KnotRange knots, const ToolCurve& curve, double tolerance);

}  // namespace armtune::internal
