#pragma once
// Parameter files in the styles in which people publish them, of a controller with three joints each. Unless
// a style says otherwise, they have the p or stiffness (600, 500, 250), and the d or damping (30, 20, 10).

#include <set>
#include <string>
#include <vector>

namespace armtune::internal::test {

inline const std::vector<std::string> kStyleJoints = {"j1", "j2", "j3"};

/// A file with a controller of three joints.
struct Style {
  const char* name;
  const char* text;
  const char* controller = "arm_controller";
  const char* stiffness = "jtc_p";  ///< armtune's names of the two gains
  const char* damping = "jtc_d";
  bool two_in_one = false;  ///< true: j1 and j2 have the same numbers of the text, 600 and 30
  /// The keys before numbers of gains; "" before the items of a list but the first.
  std::set<std::string> keys = {"p", "i", "d"};
};

inline const Style kStyles[] = {
    {"Ros1Flow",
     "arm_controller:\n"
     "  type: effort_controllers/JointTrajectoryController\n"
     "  joints: [j1, j2, j3]\n"
     "  gains:\n"
     "    j1: {p: 600.0, i: 0.0, d: 30.0}\n"
     "    j2: {p: 500, i: 0, d: 20}   # whole numbers\n"
     "    j3: {p: 250.0, i: 0.0, d: 10.0}\n"},
    {"Ros1BlockWithTrailingSpaces",
     "# Regler fuer den Arm, 调整\n"
     "arm_controller:\n"
     "  type: \"effort_controllers/JointTrajectoryController\"  \n"
     "  joints:\n    - j1\n    - j2\n    - j3\n"
     "  constraints:\n    goal_time: 0.6\n    j1: {trajectory: 0.1, goal: 0.1}\n"
     "  velocity_ff:\n    j1: 1.0\n    j2: 1.0\n    j3: 0.5\n"
     "  gains:\n"
     "    j1:\n      p: 600.0   \n      i: 1.0e1\n      d: 30.0\n      i_clamp: 5.0\n"
     "    j2:\n      p: 500.0\n      i: 10.0\n      d: 20.0\n      i_clamp: 5.0\n"
     "    j3:\n      p: 250.0\n      i: 10.0\n      d: 10.0\n      i_clamp: 5.0\n"
     "  stop_trajectory_duration: 0.5\n"},
    {"Ros2SeveralNodes",
     "controller_manager:\n"
     "  ros__parameters:\n"
     "    update_rate: 500  # Hz\n"
     "    joint_state_broadcaster:\n      type: joint_state_broadcaster/JointStateBroadcaster\n"
     "    arm_controller:\n      type: joint_trajectory_controller/JointTrajectoryController\n"
     "    gripper_controller:\n      type: position_controllers/GripperActionController\n"
     "\n"
     "arm_controller:\n"
     "  ros__parameters:\n"
     "    joints:\n      - j1\n      - j2\n      - j3\n"
     "    command_interfaces:\n      - effort\n"
     "    state_interfaces:\n      - position\n      - velocity\n"
     "    gains:\n"
     "      j1: { p: 600.0, d: 30.0, i: 100.0, i_clamp: 50.0, ff_velocity_scale: 1.5 }\n"
     "      j2: { p: 500.0, d: 20.0, i: 100.0, i_clamp: 50.0, ff_velocity_scale: 1.5 }\n"
     "      j3: { p: 250.0, d: 10.0, i: 100.0, i_clamp: 50.0, ff_velocity_scale: 1.5 }\n"
     "\n"
     "gripper_controller:\n  ros__parameters:\n    joint: finger\n"},
    {"Ros2TabsInCommentsAndCarriageReturns",
     "arm_controller:\r\n"
     "  ros__parameters:\r\n"
     "    # joints\tin their order\r\n"
     "    joints: [j1, j2, j3]\r\n"
     "    command_interfaces: [effort]\r\n"
     "    gains:\r\n"
     "      j1: {p: 600.0, i: 0.0, d: 30.0}\r\n"
     "      j2: {p: 500.0, i: 0.0, d: 20.0}\r\n"
     "      j3: {p: 250.0, i: 0.0, d: 10.0}\r\n"},
    {"Wildcard",
     "/**/arm_controller:\n"
     "  ros__parameters:\n"
     "    gains:\n"
     "      j3: {p: 250.0, i: 0.0, d: 10.0}\n"
     "      j2: {p: 500.0, i: 0.0, d: 20.0}\n"
     "      j1: {p: 1.0, i: 0.0, d: 30.0}\n"
     "/**:\n"
     "  ros__parameters:\n    use_sim_time: true\n"
     "    command_interfaces: [\"effort\"]\n"
     "left/arm_controller:\n"
     "  ros__parameters:\n"
     "    joints: [j1, j2, j3]\n"
     "    gains:\n      j1:\n        p: 600.0\n",
     "left/arm_controller"},
    {"NamesWithDots",
     "arm_controller:\n"
     "  ros__parameters:\n"
     "    joints: [j1, j2, j3]\n"
     "    command_interfaces: [effort]\n"
     "    gains.j1.p: 600.0\n    gains.j1.d: 30.0   # shoulder\n"
     "    gains.j2: {p: 500.0, d: 20.0}\n"
     "    gains:\n      j3.p: 250.0\n      j3.d: 10.0\n"},
    {"VelocityCommands",
     "controller_manager:\n"
     "  ros__parameters:\n"
     "    update_rate: 500\n"
     "    arm_controller.type: joint_trajectory_controller/JointTrajectoryController\n"
     "arm_controller:\n"
     "  ros__parameters:\n"
     "    joints: [j1, j2, j3]\n"
     "    command_interfaces: [velocity]\n"
     "    gains:\n"
     "      j1: {p: 600.0, i: 0.0, d: 30.0, ff_velocity_scale: 1.0}\n"
     "      j2: {p: 500.0, i: 0.0, d: 20.0, ff_velocity_scale: 1.0}\n"
     "      j3: {p: 250.0, i: 0.0, d: 10.0, ff_velocity_scale: 1.0}\n",
     "arm_controller", "jtc_velocity_p", "jtc_velocity_d"},
    {"JointImpedance",
     "controller_manager:\n"
     "  ros__parameters:\n"
     "    update_rate: 1000\n"
     "    impedance:\n      type: franka_example_controllers/JointImpedanceExampleController\n"
     "impedance:\n"
     "  ros__parameters:\n"
     "    arm_id: three\n"
     "    k_gains:\n      - 600.0\n      - 500.0\n      - 250.0\n"
     "    d_gains: [30.0, 20.0, 10.0]\n",
     "impedance",
     "joint_impedance_k",
     "joint_impedance_d",
     false,
     {"k_gains", "d_gains", ""}},
    {"Namespace",
     "left:\n"
     "  arm_controller:\n"
     "    ros__parameters:\n"
     "      joints: [j1, j2, j3]\n"
     "      command_interfaces: [effort]\n"
     "      gains:\n"
     "        j1: {p: 600., i: .0, d: 3e1}\n"
     "        j2: {p: +500.0, i: 0.0, d: 2.0e+1}\n"
     "        j3: {p: 250.0, i: 0.0, d: 10.0}\n",
     "left/arm_controller"},
    {"AnchorsForWholeJoints",
     "arm_controller:\n"
     "  type: effort_controllers/JointTrajectoryController\n"
     "  joints: &joints [j1, j2, j3]\n"
     "  constraints: {goal_time: &time 0.5, stopped_velocity_tolerance: *time}\n"
     "  other: *joints\n"
     "  gains:\n"
     "    j1: &big {p: 600.0, i: 0.0, d: 30.0}\n"
     "    j2: *big\n"
     "    j3: {p: 250.0, i: 0.0, d: 10.0}\n",
     "arm_controller", "jtc_p", "jtc_d", true},
    {"MergeKeys",
     "defaults: &defaults {i: 0.0, d: 30.0, i_clamp: 10.0}\n"
     "arm_controller:\n"
     "  type: effort_controllers/JointTrajectoryController\n"
     "  joints: [j1, j2, j3]\n"
     "  gains:\n"
     "    j1: {<<: *defaults, p: 600.0}\n"
     "    j2:\n      <<: *defaults\n      p: 500.0\n      d: 20.0\n"
     "    j3: {p: 250.0, d: 10.0, <<: *defaults}\n"},
    {"JazzyNames",
     "---\n"
     "arm_controller:\n"
     "  ros__parameters:\n"
     "    joints: [j1, j2, j3]\n"
     "    command_interfaces: [effort]\n"
     "    gains:\n"
     "      j1: {p: 600.0, i: 5.0, d: 30.0, i_clamp_max: 9.0, i_clamp_min: -9.0, u_clamp_max: .inf}\n"
     "      j2: {p: 500.0, i: 5.0, d: 20.0, i_clamp_max: 9.0, i_clamp_min: -9.0, antiwindup_strategy: legacy}\n"
     "      j3: {p: 250.0, i: 5.0, d: 10.0, i_clamp: .inf}\n"
     "...\n"},
    {"ByteOrderMarkAndQuotedKeys",
     "\xEF\xBB\xBF\"arm_controller\":\n"
     "  \"ros__parameters\":\n"
     "    'joints': ['j1', 'j2', 'j3']\n"
     "    'command_interfaces': ['effort']\n"
     "    'gains':\n"
     "      'j1': {'p': 600.0, 'i': 0.0, 'd': 30.0}\n"
     "      'j2': {'p': 500.0, 'i': 0.0, 'd': 20.0}\n"
     "      'j3': {'p': 250.0, 'i': 0.0, 'd': 10.0}"},
    {"OnOneLine",
     "{arm_controller: {type: effort_controllers/JointTrajectoryController, joints: [j1, j2, j3], gains: {j1: {p: "
     "600.0, i: 0.0, d: 30.0}, j2: {p: 500.0, i: 0.0, d: 20.0}, j3: {p: 250.0, i: 0.0, d: 10.0}}}}"},
    {"AmongControllersOfOtherKinds",
     "joint_state_controller: {type: joint_state_controller/JointStateController, publish_rate: 50}\n"
     "j1_position_controller:\n"
     "  type: effort_controllers/JointPositionController\n  joint: j1\n  pid: {p: 1.0, i: 0.0, d: 0.0}\n"
     "other:\n  type: my/Pid\n  gains:\n    j1: {p: 1.0, i: 0.0, d: 0.0}\n"
     "arm_controller:\n"
     "  type: effort_controllers/JointTrajectoryController\n  joints: [j1, j2, j3]\n"
     "  gains: # tuned by hand\n"
     "    j1: {p: 600.0, i: 0.0, d: 30.0} # shoulder\n"
     "    j2: {p: 500.0, i: 0.0, d: 20.0}\n"
     "    # wrist\n    j3: {p: 250.0, i: 0.0, d: 10.0}\n"},
};

}  // namespace armtune::internal::test
