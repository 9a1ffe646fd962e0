#include "tuner/planning/transcription/term_parts.hpp"

namespace armtune::internal {

KnotTerm over(KnotRange knots, const std::string& name, const std::vector<std::string>& rows) {
  KnotTerm term;
  term.name = name;
  term.rows = rows;
  term.first_knot = knots.first;
  term.last_knot = knots.last;
  return term;
}

std::vector<std::string> units_by_motion(const RobotModel& robot, const char* turning, const char* sliding) {
  std::vector<std::string> units;
  units.reserve(static_cast<std::size_t>(robot.n()));
  for (int i = 0; i < robot.n(); ++i) {
    const bool turns = robot.chain.motion[static_cast<std::size_t>(i)] == JointMotion::kRevolute;
    units.emplace_back(turns ? turning : sliding);
  }
  return units;
}

std::vector<std::string> position_units(const RobotModel& robot) {
  return units_by_motion(robot, "rad", "m");
}

void in_meters(double factor, KnotTerm& term) {
  term.units.assign(term.rows.size(), "m");
  term.natural = [factor](std::size_t, double value) { return value / factor; };
}

}  // namespace armtune::internal
