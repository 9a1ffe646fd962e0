#pragma once
// The gains and settings of a controller that a person or a search can tune. Those of the published
// controller have the names of its ROS parameters (NOTATION.md).

#include <string>
#include <vector>

#include "core/common/types.hpp"
#include "core/control/force_gains.hpp"
#include "core/control/inverse_damping.hpp"

namespace armtune::internal {

/// The orientation from which a slerp (spherical linear interpolation) turns the tool to its goal. kStart:
/// the tool's orientation at the start of the slerp. kCurrent: its present orientation, as in the code of the
/// published controller.
enum class SlerpReference { kStart, kCurrent };

/// The gains of a controller. core/control/gain_fields.cpp declares unit and meaning of every field. Gains
/// files, help texts and search spaces are made from these declarations. Six-vectors are (x y z rx ry rz);
/// joint vectors have n entries.
struct Gains {
  std::string controller = "adaptive";  ///< a kind's name (core/control/laws/controller_kind.hpp)
  std::vector<JointVector> own;         ///< gains of this kind only, in the order of its declaration
  JointVector joint_space_gains_p;
  JointVector joint_space_gains_d;
  Vec6 task_space_gains_p = Vec6::Zero();
  Vec6 task_space_gains_i = Vec6::Zero();
  JointVector task_space_gains_d;
  ForceGains force_control_gains;
  JointVector joint_space_goal;  ///< [deg], as published; empty: the scenario's own
  double joint_trajectory_duration = 6.0;
  double obstacleInfluenceRadius = 0.325;
  double trajectoryDurationErrorGain = 7.0;
  double slerpAngularErrorThreshold = 0.15;
  double slerpDurationErrorGain = 2.5;
  double interpolation_gain_scale = 0.7;
  double adaptation_gain = 0.05;
  double manipulability_threshold = 0.1;
  double manipulability_damping = 0.05;
  double joint_centering_gain = 0.0;
  double roll_centering_gain = 0.0;
  double slerp_start = 0.0;
  double release_radius = 0.0;
  SlerpReference slerp_reference = SlerpReference::kStart;
  bool adapt_while_avoiding = true;
  // Extensions that the published law lacks. They are off unless a gains file sets them.
  bool variable_damping = false;
  bool gaze_feedforward = false;
  double slerp_start_angle = 0.0;
  bool joint_goal_follows_task = false;
  double velocity_margin = 0.0;
  double velocity_barrier_start = 0.8;
  double velocity_barrier_gain = 0.0;
  double adaptation_leakage = 0.0;
  double adaptation_inertia_leakage = 0.0;
  double adaptation_filter = 0.0;
  bool adaptation_projection = false;
};

inline InverseDamping inverse_damping(const Gains& gains) {
  return {gains.manipulability_threshold, gains.manipulability_damping, gains.variable_damping ? 1.0 : 0.0};
}

}  // namespace armtune::internal
