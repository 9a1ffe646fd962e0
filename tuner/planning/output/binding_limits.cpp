#include "tuner/planning/output/binding_limits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace armtune::internal {
namespace {

constexpr double kActive = 1e-5;         // relative distance from a bound up to which the bound is active
constexpr double kLeastStrength = 1e-4;  // relative to the strongest limit

/// The knots at which a limit is active. `upper` tells for each knot whether this is the upper bound.
struct Activity {
  std::map<int, bool> upper;
  double strength = 0.0;
  double beyond = -INFINITY;  ///< largest excess, relative to the limit
  Eigen::Index worst = 0;     ///< row with the largest excess
};

std::vector<Stretch> stretches_of(const Activity& activity, const std::vector<double>& time) {
  std::vector<Stretch> found;
  int before = -2;
  for (const auto& [knot, upper] : activity.upper) {
    const double t = time[static_cast<std::size_t>(knot)];
    if (knot != before + 1 || found.back().upper != upper) found.push_back({t, t, upper});
    found.back().to = t;
    before = knot;
  }
  return found;
}

}  // namespace

std::vector<BindingLimit> binding_limits(const PlannedTrajectory& planned) {
  TrajectoryProgram& program = *planned.program;
  const std::vector<double>& time = planned.trajectory.time;
  Eigen::VectorXd residual, row;
  program.evaluate(planned.result.z, residual, row);
  std::map<std::pair<std::string, std::string>, Activity> found;
  for (Eigen::Index i = 0; i < row.size(); ++i) {
    if (program.bounds.lower[i] == program.bounds.upper[i]) continue;
    const double y = planned.result.multipliers[i];
    const bool above = row[i] > program.bounds.upper[i];
    const bool below = row[i] < program.bounds.lower[i];
    const bool upper = above || (!below && y > 0.0);
    const double bound = upper ? program.bounds.upper[i] : program.bounds.lower[i];
    if (!(std::abs(row[i] - bound) <= kActive * std::max(1.0, std::abs(bound))) && !above && !below) continue;
    const RowMeaning meaning = program.meaning(i);
    if (meaning.part.empty()) continue;  // the bounds of a phase's duration are not limits of the arm
    // A velocity limit has two rows at a knot; they count once.
    Activity& activity = found[{meaning.limit, meaning.part}];
    activity.upper.insert_or_assign(meaning.knot, upper);
    activity.strength += std::abs(y) / planned.weight;
    const double beyond = upper ? row[i] - bound : bound - row[i];
    if (beyond > activity.beyond) {
      activity.beyond = beyond;
      activity.worst = i;
    }
  }
  std::vector<BindingLimit> limits;
  limits.reserve(found.size());
  double strongest = 0.0;
  for (const auto& [key, activity] : found) {
    BindingLimit limit;
    limit.limit = key.first;
    limit.part = key.second;
    limit.share = static_cast<double>(activity.upper.size()) / static_cast<double>(time.size());
    limit.stretches = stretches_of(activity, time);
    limit.first = limit.stretches.front().from;
    limit.last = limit.stretches.back().to;
    const Eigen::Index worst = activity.worst;
    const bool upper = activity.upper.at(program.meaning(worst).knot);
    limit.value = program.natural(worst, row[worst]);
    limit.bound = program.natural(worst, upper ? program.bounds.upper[worst] : program.bounds.lower[worst]);
    limit.unit = program.meaning(worst).unit;
    limit.strength = activity.strength;
    strongest = std::max(strongest, limit.strength);
    limits.push_back(std::move(limit));
  }
  std::erase_if(limits, [&](const BindingLimit& l) { return l.strength < kLeastStrength * strongest; });
  std::sort(limits.begin(), limits.end(),
            [](const BindingLimit& a, const BindingLimit& b) { return a.strength > b.strength; });
  return limits;
}

}  // namespace armtune::internal
