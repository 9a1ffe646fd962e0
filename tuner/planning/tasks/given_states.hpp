#pragma once
// Checks the start and the goal of a plan before anything is solved, so that an impossible state is reported
// as such.

#include <optional>
#include <string>
#include <vector>

#include "tuner/planning/tasks/plan_common.hpp"

namespace armtune::internal {

/// Throws InputError if the start violates a distance that the task requires: of the arm from the obstacles
/// or from its cell (the floor and bodies around it), or between two links. Throws InputError too if a joint
/// cannot give the torque that the arm needs at rest at the goal. The torque at the start is checked in the
/// same way if the acceleration at the start is fixed.
void check_given_states(const PlanCommon& common);

/// Returns the state of the arm at rest at q (n) [rad, m], at a time [s].
Knot at_rest(const RobotModel& robot, const JointVector& q, double time);

/// A limit that a state violates. A term (knot_term.hpp) is a group of limits, such as those of the torques.
struct BrokenTerm {
  std::string value;    ///< in words: "torque of elbow_joint would be 161 N m"
  double limit = 0.0;   ///< the violated limit, in the same unit
  double number = 0.0;  ///< the value that violates it, in the same unit
};

/// Returns the first limit of the term that the state violates, or nothing if it violates none.
std::optional<BrokenTerm> broken_term(const KnotTerm& term, const Knot& state);

/// Returns the distance [m] of the arm at q (n) [rad, m] from the nearest obstacle's surface at a time [s].
/// It is measured at the tool and at every joint origin that can move. It is infinite without obstacles.
double clearance_at(const RobotModel& robot, const JointVector& q, double time,
                    const std::vector<MovingObstacle>& obstacles);

}  // namespace armtune::internal
