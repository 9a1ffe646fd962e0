#pragma once
// What a task says about one knot: rows that depend on the joints' motion there and on the time.

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
  double s = 0.0, sd = 0.0, sdd = 0.0;  ///< path coordinate, where there is one, and its derivatives
  Poses poses;                          ///< at q
};

/// Where a term writes its rows. Derivatives are row by row, in natural units; null where not asked for.
struct KnotRows {
  double* value = nullptr;
  double* by_q = nullptr;  ///< rows x (n, then 1 for the path coordinate where there is one)
  double* by_qd = nullptr;
  double* by_qdd = nullptr;
  double* by_time = nullptr;  ///< rows
  int columns = 0;            ///< of by_q, by_qd, by_qdd each
};

/// A cost (value is a residual: its square counts) or limits on a value, at knots first to last.
struct KnotTerm {
  std::string name;
  std::vector<std::string> rows;  ///< a name each: the joint, the axis
  int first_knot = 0;
  int last_knot = 0;
  bool on_velocity = false;
  bool on_acceleration = false;
  bool on_time = false;
  bool cost = false;
  bool linear = false;  ///< has no curvature
  bool hard = false;    ///< its rows never give way
  double lower =
      -std::numeric_limits<double>::infinity();  ///< of every row; values come divided by their limit
  double upper = std::numeric_limits<double>::infinity();
  std::function<void(const Knot&, const KnotRows&)> evaluate;
  std::vector<std::string> units;  ///< of the rows' values as `natural` gives them; empty: 1
  /// A row's value as users know it, such as a torque in N m; null: as it is.
  std::function<double(std::size_t row, double value)> natural;
};

}  // namespace armtune::internal
