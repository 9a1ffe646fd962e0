#!/usr/bin/env python3
"""Usage: scripts/published_controllers.py [--help]

Prints the joint_trajectory_controllers whose published gains scripts/check-controllers and scripts/compare-optuna tune. These
import from here the gains, with their sources, and functions that write a parameter file and a motion. package_file writes keys and
numbers as the package has them, in the layout of its version of ROS. parameter_file writes the same gains as a ROS 2 file.
"""

import math
import sys

UR5E = [0.0, -1.57, 1.2, -1.2, -1.57, 0.0]
UR_JOINTS = ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint", "wrist_2_joint", "wrist_3_joint"]

# Robot, where its gains are published, command interface, rate of the controller [Hz], where the motion begins [rad], p, i, d, i_clamp by
# joint, and the share of the desired velocity. The package of xarm7_effort has no joint_trajectory_controller with efforts: its file gives
# these p, i and d to one JointPositionController for each joint, without an i_clamp. Here a joint_trajectory_controller has them, with an
# i_clamp that they hardly reach. The rate is that of the file for fr3_effort and ur5e_velocity; the other files give none.
PACKAGES = {
    "ur5e_effort": (
        "ur5e",
        "ros-industrial/universal_robot, ur_gazebo/config/ur5e_controllers.yaml, 25726cfd",
        "effort", 500,
        UR5E,
        {"shoulder_pan_joint": (4000, 1, 200, 1), "shoulder_lift_joint": (10000, 1, 200, 1), "elbow_joint": (2000, 1, 20, 1),
         "wrist_1_joint": (500, 1, 1, 1), "wrist_2_joint": (500, 1, 1, 1), "wrist_3_joint": (10, 0, 0.1, 1)},
        0.0),
    "fr3_effort": (
        "fr3",
        "frankaemika/franka_ros2, franka_fr3_moveit_config/config/fr3_ros_controllers.yaml, 66727a26",
        "effort", 1000,
        [0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785],
        {f"fr3_joint{k}": gains for k, gains in enumerate(
            [(600, 0, 30, 1)] * 4 + [(250, 0, 10, 1), (150, 0, 10, 1), (50, 0, 5, 1)], 1)},
        0.0),
    "xarm7_effort": (
        "xarm7",
        "xArm-Developer/xarm_ros, xarm_controller/config/xarm7_effort_controllers.yaml, 38a1255c (there for "
        "JointPositionControllers, one for each joint, without an i_clamp; here 100 N m)",
        "effort", 500,
        [0.0, -0.3, 0.0, 1.2, 0.0, 1.5, 0.0],
        {f"joint{k}": (*gains, 100) for k, gains in enumerate(
            [(1200, 5, 10), (1400, 5, 10), (1200, 5, 5), (850, 3, 5), (500, 3, 1), (500, 1, 1), (300, 0.05, 1)], 1)},
        0.0),
    "gen3_7_effort": (
        "gen3_7",
        "Kinovarobotics/ros_kortex, kortex_control/arms/gen3/7dof/config/joint_position_controllers.yaml, 7d2ba775",
        "effort", 1000,
        [0.0, 0.26, 0.0, -1.57, 0.0, 0.96, 1.57],
        {f"joint_{k}": gains for k, gains in enumerate(
            [(3000, 0, 2, 100), (50000, 0, 0, 5), (3000, 0, 0, 1), (50000, 0, 0, 1), (750, 0, 0.2, 1), (5000, 0, 1, 1),
             (100, 0, 0, 0.1)], 1)},
        0.0),
    "ur5e_velocity": (
        "ur5e",
        "UniversalRobots/Universal_Robots_ROS_Driver, ur_robot_driver/config/ur5e_controllers.yaml, 9507f929",
        "velocity", 500,
        UR5E,
        {joint: (5.0, 0.05, 0.1, 1) for joint in UR_JOINTS},
        1.0),
    "xarm6_velocity": (
        "xarm6",
        "xArm-Developer/xarm_ros, xarm_controller/config/xarm6/xarm6_controllers.yaml, 17aefe53",
        "velocity", 500,
        [0.0, -0.3, -1.0, 0.0, 1.2, 0.0],
        {f"joint{k}": (10, 0, 0, 1) for k in range(1, 7)},
        0.25),
}


# The distribution of ROS whose rules apply, and the controller's name in the package's file.
FORMS = {
    "ur5e_effort": ("noetic", "eff_joint_traj_controller"),
    "fr3_effort": ("jazzy", "fr3_arm_controller"),
    "xarm7_effort": ("noetic", "effort_joint_traj_controller"),
    "gen3_7_effort": ("noetic", "gen3_joint_trajectory_controller"),
    "ur5e_velocity": ("noetic", "vel_joint_traj_controller"),
    "xarm6_velocity": ("noetic", "xarm6_velo_traj_controller"),
}


def clamps(name, clamp):
    """The keys of a joint's clamp: the package of Gen3 gives both bounds."""
    return f"i_clamp_min: {-clamp}, i_clamp_max: {clamp}" if name == "gen3_7_effort" else f"i_clamp: {clamp}"


def package_file(name):
    """The parameter file with the package's keys for gains, and `armtune` options for what it does not say."""
    _, _, interface, rate, _, gains, feed_forward = PACKAGES[name]
    distro, controller = FORMS[name]
    options = ["--distro", distro]
    lists = [f"  {joint}: {{p: {p}, i: {i}, d: {d}, {clamps(name, clamp)}}}" for joint, (p, i, d, clamp) in gains.items()]
    joints = f"joints: [{', '.join(gains)}]"
    if distro != "noetic":
        lines = ["/**:", "  controller_manager:", "    ros__parameters:", f"      update_rate: {rate}",
                 f"      {controller}: {{type: joint_trajectory_controller/JointTrajectoryController}}", f"  {controller}:",
                 "    ros__parameters:", f"      command_interfaces: [{interface}]", "      state_interfaces: [position, velocity]",
                 f"      {joints}", "      gains:", *(f"      {line}" for line in lists)]
        return "\n".join(lines) + "\n", options
    lines = [f"{controller}:", f"  type: {interface}_controllers/JointTrajectoryController", f"  {joints}", "  gains:",
             *(f"  {line}" for line in lists)]
    if interface == "velocity":
        lines += ["  velocity_ff:", *(f"    {joint}: {feed_forward}" for joint in gains)]
    if name == "ur5e_velocity":
        lines = ["hardware_control_loop:", f"  loop_hz: {rate}", *lines]
    else:
        options += ["--rate", str(rate)]
    return "\n".join(lines) + "\n", options


def parameter_file(interface, rate, gains, feed_forward):
    lines = ["controller_manager:", "  ros__parameters:", f"    update_rate: {rate}",
             "    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}", "arm_controller:",
             "  ros__parameters:", f"    joints: [{', '.join(gains)}]", f"    command_interfaces: [{interface}]",
             "    state_interfaces: [position, velocity]", "    gains:   # as published"]
    lines += [f"      {joint}: {{p: {p}, i: {i}, d: {d}, i_clamp: {clamp}, ff_velocity_scale: {feed_forward}}}"
              for joint, (p, i, d, clamp) in gains.items()]
    return "\n".join(lines) + "\n"


def motion(joints, start):
    """Half a radian to and fro in three seconds, neighbours in opposite directions, twice."""
    rows = ["time," + ",".join(f"joint/{joint}/{what}" for what in ("position", "velocity") for joint in joints)]
    period, reach = 3.0, 0.5
    for k in range(121):
        t = 0.05 * k
        angle = 2.0 * math.pi * t / period
        way = [0.5 * reach * (-1) ** j for j in range(len(joints))]
        q = [q0 + w * (1.0 - math.cos(angle)) for q0, w in zip(start, way)]
        qd = [w * 2.0 * math.pi / period * math.sin(angle) for w in way]
        rows.append(",".join(f"{value:.9g}" for value in [t, *q, *qd]))
    return "\n".join(rows) + "\n"


if __name__ == "__main__":
    print(__doc__ if set(sys.argv) & {"--help", "-h"} else "\n".join(f"{name}: {package[1]}" for name, package in PACKAGES.items()))
