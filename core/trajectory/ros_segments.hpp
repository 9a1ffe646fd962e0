#pragma once
// Points of a joint trajectory as ROS's controllers join them, each with the polynomial of lowest degree that
// takes what both points give: position alone a straight line, velocity too a cubic, acceleration too a
// quintic.
// ros2_controllers, joint_trajectory_controller/src/trajectory.cpp, interpolate_between_points; branches
// `humble` and `jazzy` of August 2026, and ros_controllers, `noetic-devel`, give the same polynomials.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

/// What every point of a trajectory gives: kVelocities stands for positions and velocities.
enum class PointsGive { kPositions, kVelocities, kAccelerations };

/// Returns the segments between neighbouring points. time [s]: rising, at least two, as many as points.
/// points: n joints each (rad or m); what they do not give does not count.
std::vector<Quintic<JointVector>> ros_segments(const std::vector<double>& time,
                                               const std::vector<MotionPoint<JointVector>>& points,
                                               PointsGive given);

}  // namespace armtune::internal
