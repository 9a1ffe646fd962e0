#pragma once
// Checks the start and the goal of a plan before anything is solved, so that an impossible state is reported
// as such.

#include <optional>
#include <string>
#include <vector>

#include "tuner/planning/tasks/plan_common.hpp"

namespace armtune::internal {

/// Throws InputError if, at the start, the arm is closer to an obstacle or to the cell than the task allows,
/// or two of its links are closer to each other. Throws InputError too if a joint cannot give the torque that
/// the arm needs at rest at the goal, or at the start with the acceleration that the task gives for it.
void check_given_states(const PlanCommon& common);

/// The state of the arm at rest at q (n) [rad, m], at a time [s].
Knot at_rest(const RobotModel& robot, const JointVector& q, double time);

/// A limit of a term that a state breaks.
struct BrokenTerm {
  std::string value;   ///< in words: "torque of elbow_joint would be 161 N m"
  double limit = 0.0;  ///< in the same unit
};

/// Returns the first limit of the term that the state breaks, or nothing if it breaks none.
std::optional<BrokenTerm> broken_term(const KnotTerm& term, const Knot& state);

/// Returns the distance [m] of the arm at q (n) [rad, m] from the nearest obstacle's surface at a time [s].
/// It is measured at the tool and at every joint origin that can move. It is infinite without obstacles.
double clearance_at(const RobotModel& robot, const JointVector& q, double time,
                    const std::vector<MovingObstacle>& obstacles);

}  // namespace armtune::internal
