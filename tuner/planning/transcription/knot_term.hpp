#pragma once
// A term of a trajectory optimisation: a cost, or constraints, at some knots of the time grid. The rows of a
// term depend on the time and on the motion of the joints at one knot.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/robot/kinematics.hpp"

namespace armtune::internal {

/// The arm at one knot.
struct Knot {
  int index = 0;
  double time = 0.0;                    ///< [s]
  JointVector q, qd, qdd;               ///< (n) [rad, m and per s, s^2]
  double s = 0.0, sd = 0.0, sdd = 0.0;  ///< path coordinate, if the task has one, and its derivatives
  Poses poses;                          ///< at q
};

/// The places where a term writes its rows. Derivatives are stored row by row, in natural units. A null
/// pointer means that the values are not needed.
struct KnotRows {
  double* value = nullptr;
  double* by_q = nullptr;  ///< rows x (n, then 1 for the path coordinate if the task has one)
  double* by_qd = nullptr;
  double* by_qdd = nullptr;
  double* by_time = nullptr;  ///< rows
  int columns = 0;            ///< number of columns of by_q, by_qd, by_qdd each
};

/// A cost, or limits, at the knots first_knot to last_knot. The value of a cost is a residual, whose square
/// is minimised.
struct KnotTerm {
  std::string name;
  std::vector<std::string> rows;  ///< name of each row, such as a joint or an axis
  int first_knot = 0;
  int last_knot = 0;
  bool on_velocity = false;
  bool on_acceleration = false;
  bool on_time = false;
  bool cost = false;
  bool linear = false;  ///< true if it has no curvature
  bool hard = false;    ///< true if its rows must never be violated
  double lower =
      -std::numeric_limits<double>::infinity();  ///< bounds of every row; values are divided by their limit
  double upper = std::numeric_limits<double>::infinity();
  std::function<void(const Knot&, const KnotRows&)> evaluate;
  std::vector<std::string> units;  ///< units of the values that `natural` returns; empty: 1
  /// Returns a row's value in the user's unit, such as a torque in N m. Null: the value has that unit.
  std::function<double(std::size_t row, double value)> natural;
};

}  // namespace armtune::internal
