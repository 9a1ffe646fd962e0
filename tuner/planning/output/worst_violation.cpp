#include "tuner/planning/output/worst_violation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "tuner/report/plan_recording.hpp"

namespace armtune::internal {

WorstViolation worst_violation(const PlannedTrajectory& planned) {
  TrajectoryProgram& program = *planned.program;
  Eigen::VectorXd residual, row;
  program.evaluate(planned.result.z, residual, row);
  const RowBounds& bounds = program.bounds;
  const Eigen::VectorXd violation = (bounds.lower - row).cwiseMax(row - bounds.upper).cwiseMax(0.0);
  Eigen::Index worst = 0;
  WorstViolation found;
  found.violation = violation.maxCoeff(&worst);
  found.meaning = program.meaning(worst);
  found.time = planned.trajectory.time[static_cast<std::size_t>(found.meaning.knot)];
  found.equation = bounds.lower[worst] == bounds.upper[worst];
  const double bound = row[worst] > bounds.upper[worst] ? bounds.upper[worst] : bounds.lower[worst];
  found.value = program.natural(worst, row[worst]);
  found.bound = program.natural(worst, bound);
  return found;
}

std::string sentence(const WorstViolation& worst) {
  const RowMeaning& meaning = worst.meaning;
  const std::string what = report::limit_words(meaning.limit, meaning.part);
  const std::string unit = meaning.unit.empty() ? "" : " " + meaning.unit;
  if (worst.equation)
    return fmt::format("{} is missed by {:.4g}{} at {:.4g} s", what, std::abs(worst.value - worst.bound),
                       unit, worst.time);
  return fmt::format("{} would be {:.4g}{} at {:.4g} s; its limit is {:.4g}{}", what, worst.value, unit,
                     worst.time, worst.bound, unit);
}

}  // namespace armtune::internal
