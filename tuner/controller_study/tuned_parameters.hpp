#pragma once
// Selects which gains of a controller a study tunes, and between which bounds.

#include <string>
#include <vector>

#include "core/control/gains.hpp"
#include "core/robot/robot_model.hpp"
#include "tuner/controller_study/controller_in_file.hpp"

namespace armtune::internal {

struct TunedParameters {
  std::string lines;                  ///< the study's `parameters`
  std::vector<std::string> undamped;  ///< names of the joints whose d is tuned although it is 0
  std::string note;                   ///< which gains share one number of the file; empty: none
};

/// Returns the gains that a study tunes. These are the gains that are tuned by default, without those that
/// are 0 or that the parameter file does not contain. Gains that share one number of the file are linked to
/// the first of them. Gains that a robot accepts within fixed bounds get these bounds. For a
/// joint_trajectory_controller that commands efforts, a joint's d of 0 is tuned too, provided that the file
/// has a place for this d and that the joint's p is not 0. The range of such a d is 0 to five times the
/// damping that fits the arm's inertia at q (n) [rad, m]. most_stiffness: largest stiffness of each joint (n)
/// [N m/rad, N/m] or axis of the task (6) [N/m, N m]; empty: the stiffness is not tuned.
TunedParameters tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                                 const std::vector<double>& most_stiffness);

}  // namespace armtune::internal
