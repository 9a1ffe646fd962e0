#include "tuner/planning/output/binding_limits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace armtune {
namespace {

constexpr double kActive = 1e-5;         // relative distance from a bound that counts as none
constexpr double kLeastStrength = 1e-4;  // of the strongest limit's

}  // namespace

std::vector<BindingLimit> binding_limits(const PlannedTrajectory& planned) {
  TrajectoryProgram& program = *planned.program;
  Eigen::VectorXd residual, row;
  program.evaluate(planned.result.z, residual, row);
  std::map<std::pair<std::string, std::string>, std::pair<BindingLimit, int>> found;
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    if (program.bounds.lower[i] == program.bounds.upper[i]) continue;
    const double y = planned.result.multipliers[i];
    const double bound = y > 0.0 ? program.bounds.upper[i] : program.bounds.lower[i];
    if (!(std::abs(row[i] - bound) <= kActive * std::max(1.0, std::abs(bound))) &&
        !(row[i] > program.bounds.upper[i]) && !(row[i] < program.bounds.lower[i]))
      continue;
    const RowMeaning meaning = program.meaning(i);
    if (meaning.part.empty()) continue;  // how short a phase may be is no limit of the arm
    auto& [limit, count] = found[{meaning.limit, meaning.part}];
    const double time = planned.trajectory.time[static_cast<std::size_t>(meaning.knot)];
    if (count++ == 0) {
      limit.limit = meaning.limit;
      limit.part = meaning.part;
      limit.first = time;
    }
    limit.last = time;
    limit.strength += std::abs(y);
  }
  std::vector<BindingLimit> limits;
  double strongest = 0.0;
  for (auto& [key, value] : found) {
    value.first.share =
        static_cast<double>(value.second) / static_cast<double>(planned.trajectory.time.size());
    strongest = std::max(strongest, value.first.strength);
    limits.push_back(value.first);
  }
  std::erase_if(limits, [&](const BindingLimit& l) { return l.strength < kLeastStrength * strongest; });
  std::sort(limits.begin(), limits.end(),
            [](const BindingLimit& a, const BindingLimit& b) { return a.strength > b.strength; });
  return limits;
}

}  // namespace armtune
