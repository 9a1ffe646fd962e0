#pragma once
// Makes constraints that fix the motion at one knot (point) of a trajectory, such as its start state or its
// goal.

#include "tuner/planning/transcription/knot_term.hpp"
#include "tuner/record/words.hpp"

namespace armtune::internal {

/// The given position, velocity and acceleration of every coordinate [rad, m and per s, s^2]. A vector is
/// empty if it is not given.
struct GivenState {
  Eigen::VectorXd position, velocity, acceleration;
};

/// Returns equations that give the coordinates called `names` the given state at the knot. units: units of
/// the positions.
inline KnotTerm given_state(const std::string& name, const std::vector<std::string>& names,
                            const std::vector<std::string>& units, int knot, const GivenState& given) {
  KnotTerm term;
  term.name = name;
  term.first_knot = term.last_knot = knot;
  term.lower = term.upper = 0.0;
  term.linear = true;
  term.on_velocity = given.velocity.size() > 0;
  term.on_acceleration = given.acceleration.size() > 0;
  const auto add = [&](const char* what, const char* per) {
    for (const std::string& coordinate : names) term.rows.push_back(coordinate + " " + what);
    for (const std::string& unit : units) term.units.push_back(unit + per);
  };
  if (given.position.size() > 0) add("position", "");
  if (given.velocity.size() > 0) add("velocity", "/s");
  if (given.acceleration.size() > 0) add("acceleration", "/s^2");
  term.evaluate = [given](const Knot& at, const KnotRows& out) {
    int row = 0;
    const auto put = [&](const Eigen::VectorXd& wanted, const JointVector& is, double path, double* by) {
      for (Eigen::Index j = 0; j < wanted.size(); ++j, ++row) {
        out.value[row] = (j < is.size() ? is[j] : path) - wanted[j];
        if (by != nullptr) by[row * out.columns + j] = 1.0;
      }
    };
    if (given.position.size() > 0) put(given.position, at.q, at.s, out.by_q);
    if (given.velocity.size() > 0) put(given.velocity, at.qd, at.sd, out.by_qd);
    if (given.acceleration.size() > 0) put(given.acceleration, at.qdd, at.sdd, out.by_qdd);
  };
  return term;
}

/// Returns an equation that gives the path coordinate the value `s` at the knot.
inline KnotTerm path_coordinate_at(int knot, double s) {
  KnotTerm term;
  term.name = kept_words::kPathCoordinate;
  term.rows = {"s"};
  term.units = {"s"};
  term.first_knot = term.last_knot = knot;
  term.lower = term.upper = 0.0;
  term.linear = true;
  term.evaluate = [s](const Knot& at, const KnotRows& out) {
    out.value[0] = at.s - s;
    if (out.by_q != nullptr) out.by_q[at.q.size()] = 1.0;
  };
  return term;
}

}  // namespace armtune::internal
