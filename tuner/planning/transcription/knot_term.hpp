#pragma once
// Defines the terms of a trajectory optimisation. A term is a cost, or a group of constraints, that applies
// at some knots (points) of the time grid. Its rows depend on the time and on the motion of the joints at one
// knot.

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/kinematics.hpp"
#include "tuner/record/limit_kind.hpp"

namespace armtune::internal {

/// The arm at one knot.
struct Knot {
  int index = 0;
  double time = 0.0;                    ///< [s]
  JointVector q, qd, qdd;               ///< (n) [rad, m and per s, s^2]
  double s = 0.0, sd = 0.0, sdd = 0.0;  ///< path coordinate, if the task has one, and its derivatives
  Poses poses;                          ///< at q
};

/// The places where a term writes the values and derivatives of its rows. Derivatives are stored row by row,
/// in natural units. A null pointer means that the derivatives are not needed.
struct KnotRows {
  double* value = nullptr;
  double* by_q = nullptr;  ///< rows x (n, then 1 for the path coordinate if the task has one)
  double* by_qd = nullptr;
  double* by_qdd = nullptr;
  double* by_time = nullptr;  ///< one per row
  int columns = 0;            ///< number of columns of by_q, by_qd, by_qdd each
};

/// A cost, or limits, at the knots first_knot to last_knot. The value of a cost is a residual, whose square
/// is minimised.
struct KnotTerm {
  std::string name;
  std::optional<LimitKind> kind;  ///< empty: an equation, such as a start state
  std::vector<std::string> rows;  ///< name of each row, such as a joint or an axis
  int first_knot = 0;
  int last_knot = 0;
  bool on_velocity = false;      ///< true if the rows depend on velocities
  bool on_acceleration = false;  ///< true if the rows depend on accelerations
  bool on_time = false;          ///< true if the rows depend on the time of the knot
  bool cost = false;             ///< true if the term is a cost, false if it is a group of limits
  bool linear = false;           ///< true if all second derivatives of the rows are zero
  bool hard = false;             ///< true if the rows must never be violated
  double lower =
      -std::numeric_limits<double>::infinity();  ///< bounds of every row; values are divided by their limit
  double upper = std::numeric_limits<double>::infinity();
  std::function<void(const Knot&, const KnotRows&)> evaluate;
  std::vector<std::string> units;  ///< units of the values that `natural` returns; empty: 1
  /// Returns a row's value in the user's unit, such as a torque in N m. Null: the value already has this
  /// unit.
  std::function<double(std::size_t row, double value)> natural;
};

}  // namespace armtune::internal
