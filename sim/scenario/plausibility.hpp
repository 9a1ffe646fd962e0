#pragma once
// Figures of a robot file that are valid and still can hardly be those of an arm: placeholders, other units,
// a gripper taken for a joint. They make a simulation quietly wrong.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::internal {

/// A value that a robot YAML could give in place of what is doubted.
struct ProposedValue {
  std::string key;    ///< of the robot YAML: limits, inertia, hold
  std::string name;   ///< joint or link
  std::string field;  ///< of its map; empty: the value is the name's own
  std::string value;  ///< empty: only the arm's maker knows it
};

struct Doubt {
  std::string says;  ///< one sentence, with names, values and what to do
  std::vector<ProposedValue> proposed = {};
};

/// Returns what is doubtful; empty if nothing is. It doubts links too light for their joint's effort, inertia
/// that no body of the mass can have, rotor inertia far from what the limits suggest, position limits and
/// velocities that look like degrees, efforts that cannot hold the arm, and a last joint that moves like a
/// gripper's finger.
std::vector<Doubt> doubts_with_proposals(const RobotModel& robot);

/// The sentences alone.
std::vector<std::string> doubts(const RobotModel& robot);

/// The text of a robot YAML for the arm of `urdf` in which every doubt and what is proposed are comments.
std::string proposals_yaml(const std::string& urdf, const std::vector<Doubt>& found);

}  // namespace armtune::internal
