#pragma once
// A task for an arm of which nothing is known but its URDF: a circle where it moves best, with two targets
// ahead of it that take turns. Something to begin tuning on, and to edit.

#include <memory>
#include <string>

#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

struct DefaultTask {
  Scenario scenario;
  JointVector goal;             ///< (n) [rad, m] on the task where it begins
  double manipulability = 0.0;  ///< the smallest of the task on its way from there
};

/// The circle is a tenth of the arm's reach, or as much smaller as its limits ask for, perpendicular to the
/// tool's z axis; of the places where the arm moves well one that has the tool look down. The task is
/// position and gaze, or position alone where the arm has no joints for more. Plant: noise, a period of
/// delay, a payload of two per cent of the arm's mass and a model that is a fifth too light, so that gains
/// cannot grow for nothing. Throws InputError if the arm has no place for even a small circle.
DefaultTask default_task(std::shared_ptr<const RobotModel> robot);

/// It as a scenario file. robot: what the file names it by.
std::string default_task_yaml(const DefaultTask& task, const std::string& robot);

}  // namespace armtune::internal
