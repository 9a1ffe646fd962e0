// The sections with the results of a search: its evaluations and fronts.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/report/sections.hpp"
#include "tuner/trade_off/front.hpp"

namespace armtune::internal::report {
namespace {

/// Returns the row with the gains of the last set. Of several such rows, prefers one that Simbody simulated,
/// and then the best one.
long chosen_row(const CsvTable& table, const Evaluations& e, const std::vector<Gain>& gains) {
  std::vector<std::pair<std::size_t, double>> wanted;  // column, value
  for (const Gain& gain : gains) {
    const auto column = table.find(gain.name);
    if (column && !gain.values.empty() && std::isfinite(gain.values.back())) {
      wanted.emplace_back(*column, gain.values.back());
    }
  }
  const auto has_them = [&](std::size_t r) {
    return std::all_of(wanted.begin(), wanted.end(), [&](const std::pair<std::size_t, double>& w) {
      // A gain in gains.yaml and in evaluations.csv may differ in its last bit.
      return std::abs(table.number(r, w.first) - w.second) <= 1e-12 * std::abs(w.second);
    });
  };
  const auto better = [&e](std::size_t a, std::size_t b) {
    if (e.feasible[a] != e.feasible[b]) return static_cast<bool>(e.feasible[a]);
    if (!e.feasible[a] && e.violation[a] != e.violation[b]) return e.violation[a] < e.violation[b];
    return e.objective[a] < e.objective[b];
  };
  // 2: these gains, simulated by Simbody; 1: these gains; 0: other gains.
  const auto rank = [&](std::size_t r) {
    if (wanted.empty() || !has_them(r)) return 0;
    return e.native.empty() || !e.native[r] ? 2 : 1;
  };
  long best = -1;
  int best_rank = -1;
  for (std::size_t r = 0; r < e.objective.size(); ++r) {
    const int now = rank(r);
    if (now > best_rank || (now == best_rank && better(r, static_cast<std::size_t>(best)))) {
      best = static_cast<long>(r);
      best_rank = now;
    }
  }
  return best;
}

/// Returns the start, the chosen point, and the feasible points that no other feasible point dominates.
std::vector<FrontPoint> essential(const std::vector<FrontPoint>& points) {
  std::vector<Costs> costs;
  std::vector<std::size_t> feasible;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].feasible) continue;
    costs.push_back(points[i].values);
    feasible.push_back(i);
  }
  std::vector<bool> keep(points.size(), false);
  for (const std::size_t i : non_dominated(costs)) keep[feasible[i]] = true;
  std::vector<FrontPoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (keep[i] || points[i].role != "point") kept.push_back(points[i]);
  }
  return kept;
}

}  // namespace

Evaluations evaluations_of(const CsvTable& table, const std::vector<Gain>& gains) {
  const std::size_t phase = table.column("phase");
  const std::size_t feasible = table.column("feasible");
  Evaluations e;
  e.objective = table.numbers(table.column("objective"));
  e.violation = table.numbers(table.column("violation"));
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const std::string name = table.text(r, phase);
    const auto found = std::find(e.phases.begin(), e.phases.end(), name);
    e.of.push_back(static_cast<std::size_t>(found - e.phases.begin()));
    if (found == e.phases.end()) e.phases.push_back(name);
    e.feasible.push_back(table.number(r, feasible) != 0.0);
    if (e.start < 0 && name == "start") e.start = static_cast<long>(r);
  }
  if (const auto engine = table.find("engine")) {  // older files have none
    for (std::size_t r = 0; r < table.rows(); ++r) e.native.push_back(table.text(r, *engine) == "native");
    if (std::find(e.native.begin(), e.native.end(), true) == e.native.end()) e.native.clear();
  }
  e.chosen = chosen_row(table, e, gains);
  return e;
}

std::optional<Front> front_of_search(const CsvTable& table, const Evaluations& evaluations,
                                     const std::vector<StudyLimit>& limits) {
  constexpr std::size_t kMost = 1000;
  const std::string metric = name(Metric::kJointVelocityMaxRatio);
  std::vector<std::size_t> columns;
  for (std::size_t c = 0; c < table.header().size(); ++c) {
    const std::string& header = table.header()[c];
    if (header.starts_with("constraint/") && header.ends_with("/" + metric)) columns.push_back(c);
  }
  if (columns.empty()) return std::nullopt;
  Front front;
  front.criteria = {{"objective", "1"}, {metric, field(Metric::kJointVelocityMaxRatio).unit}};
  // The ratio of a point is the worst of these scenarios. A limit is drawn only if it holds for all of them.
  for (const StudyLimit& limit : limits) {
    const bool all = limit.scenarios.empty() || limit.scenarios.size() >= columns.size();
    if (limit.metric == Metric::kJointVelocityMaxRatio && limit.upper && limit.value && all) {
      front.limits.push_back({1, *limit.value});
    }
  }
  for (std::size_t r = 0; r < table.rows(); ++r) {
    double worst = 0.0;
    for (const std::size_t c : columns) {
      const double value = table.number(r, c);
      worst = std::isnan(value) || value > worst ? value : worst;
      if (std::isnan(worst)) break;
    }
    const double objective = evaluations.objective[r];
    if (!std::isfinite(worst) || !std::isfinite(objective)) continue;
    const auto number = static_cast<long>(r);
    const std::string role = number == evaluations.chosen  ? "chosen"
                             : number == evaluations.start ? "start"
                                                           : "point";
    const bool native = !evaluations.native.empty() && evaluations.native[r];
    front.points.push_back({{objective, worst},
                            role == "start"
                                ? role
                                : fmt::format("evaluation {}, {}{}", r, evaluations.phases[evaluations.of[r]],
                                              native ? ", in the native engine" : ""),
                            evaluations.feasible[r],
                            role});
  }
  if (front.points.size() > kMost) front.points = essential(front.points);
  if (front.points.empty()) return std::nullopt;
  return front;
}

Front front_of(const CsvTable& table, const std::vector<std::string>& criteria, const std::string& shown,
               std::optional<double> hypervolume) {
  Front front;
  front.hypervolume = hypervolume;
  std::vector<std::size_t> columns;
  for (const std::string& criterion : criteria) {
    columns.push_back(table.column(criterion));
    const auto metric = metric_from_name(criterion);
    front.criteria.push_back({criterion, metric ? field(*metric).unit : "1"});
  }
  const std::size_t kind = table.column("kind");
  const std::size_t point = table.column("point");
  for (std::size_t r = 0; r < table.rows(); ++r) {
    FrontPoint p;
    p.values.reserve(columns.size());
    for (const std::size_t c : columns) p.values.push_back(table.number(r, c));
    const bool start = table.text(r, kind) == "start";
    const std::string number = table.text(r, point);
    p.label = start ? "start" : "point " + number;
    p.feasible = !start;  // unknown for the start; every point of a front is feasible
    p.role = start ? "start" : number == shown ? "shown" : "point";
    front.points.push_back(std::move(p));
  }
  return front;
}

}  // namespace armtune::internal::report
