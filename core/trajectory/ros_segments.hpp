#pragma once
// The segments between the points of a joint trajectory, as ROS's controllers compute them. Each is the
// polynomial of lowest degree that matches both points: a straight line for positions only, a cubic with
// velocities, a quintic with accelerations.
// Source: ros2_controllers, joint_trajectory_controller/src/trajectory.cpp, interpolate_between_points.
// Its branches `humble` and `jazzy` of August 2026 and the branch `noetic-devel` of ros_controllers give the
// same polynomials.

#include <vector>

#include "core/common/types.hpp"
#include "core/trajectory/motion_point.hpp"
#include "core/trajectory/quintic.hpp"

namespace armtune::internal {

/// The data that every point of a trajectory has. kVelocities: positions and velocities. kAccelerations:
/// positions, velocities and accelerations.
enum class PointsGive { kPositions, kVelocities, kAccelerations };

/// Returns the segments between neighbouring points. time [s]: increasing, at least two, as many as points.
/// points: of n joints each (rad or m); data that `given` does not include is ignored.
std::vector<Quintic<JointVector>> ros_segments(const std::vector<double>& time,
                                               const std::vector<MotionPoint<JointVector>>& points,
                                               PointsGive given);

}  // namespace armtune::internal
