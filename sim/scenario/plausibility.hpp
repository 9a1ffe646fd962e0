#pragma once
// Finds numbers in a robot file that are valid but implausible for a real arm. Typical causes are placeholder
// values, wrong units, and a gripper's finger that is taken for the last joint of the arm. Such numbers make
// a simulation wrong without an error.

#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "core/robot/urdf_options.hpp"

namespace armtune::internal {

/// A value that the user could write into a robot YAML in place of a doubtful one.
struct ProposedValue {
  std::string key;    ///< top-level key of the robot YAML: limits, inertia, hold or rotor_inertia
  std::string name;   ///< joint, link, or "estimated" for rotor_inertia: a key in the map of `key`
  std::string field;  ///< key in the map of `name`; empty: the value belongs to the name itself
  std::string value;  ///< empty: armtune cannot propose a value; the arm's maker can give it
};

struct Doubt {
  std::string says;  ///< one sentence, with names, values and what to do
  std::vector<ProposedValue> proposed = {};
};

/// Returns everything that is doubtful; empty if nothing is. Doubtful are:
///   - an arm that is so light that every joint could hold all of it, at full reach, with a fifth of its
///     effort limit,
///   - links that are too light for the effort limit of their joint,
///   - link inertia that is too large or too small for the link's mass (radius of gyration),
///   - links that all have the same mass and inertia, if there are at least four,
///   - rotor inertia far from the value that the joint's limits suggest,
///   - position and velocity limits that look like degrees,
///   - effort limits that are too low to hold the arm still,
///   - a last joint with a range as small as that of a gripper's finger.
/// missing: data for which the model has placeholders (load_robot). Values that depend on one of these are
/// not reported.
std::vector<Doubt> doubts_with_proposals(const RobotModel& robot, const MissingData& missing = {});

/// Returns the sentences of these doubts, without proposals.
std::vector<std::string> doubts(const RobotModel& robot);

}  // namespace armtune::internal
