#include "tuner/sensitivity/sensitivity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/csv/cell.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/sensitivity/merits.hpp"

namespace armtune::internal {
namespace {

/// A smaller relative change of the merit counts as no effect.
constexpr double kNoEffect = 1e-3;

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return values[i] < values[k]; });
  std::vector<double> rank(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    for (std::size_t k = i; k < end; ++k) rank[order[k]] = 0.5 * static_cast<double>(i + end - 1);
    i = end;
  }
  return rank;
}

double clamp_to_box(double x) {
  return std::clamp(x, 0.0, 1.0);
}

/// Returns "complete", or the names of the missing figures, each with the reason.
std::string missing(const ParameterSensitivity& s) {
  std::string text;
  const auto add = [&text](const char* figure, const char* why) {
    text += fmt::format("{}no {}: {}", text.empty() ? "" : "; ", figure, why);
  };
  if (!std::isfinite(s.importance)) add("importance", "a merit is not finite");
  if (!std::isfinite(s.local)) add("local", "the best merit is zero or a merit is not finite");
  if (!std::isfinite(s.elasticity)) add("elasticity", "the gain or the best merit is zero");
  if (!std::isfinite(s.rank_correlation))
    add("rank_correlation", "fewer than three evaluations or the gain never changed");
  return text.empty() ? "complete" : text;
}

}  // namespace

double rank_correlation(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() < 3) return NAN;
  const auto ra = ranks(a);
  const auto rb = ranks(b);
  const double mean = 0.5 * static_cast<double>(a.size() - 1);
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (ra[i] - mean) * (rb[i] - mean);
    aa += (ra[i] - mean) * (ra[i] - mean);
    bb += (rb[i] - mean) * (rb[i] - mean);
  }
  return aa > 0.0 && bb > 0.0 ? ab / std::sqrt(aa * bb) : NAN;
}

std::optional<Sensitivity> sensitivity(
    const Study& study, const Objective& objective, const Gains& best,
    const std::vector<EvaluationRow>& journal, CandidateRunner& workers, const std::atomic<bool>& stop,
    const std::function<void(std::size_t done, std::size_t all)>& progress) {
  const std::size_t n = study.space.free.size();
  const std::vector<double> x = study.space.point_of(best);
  const std::vector<double> start = study.space.start_point();
  const double penalty = study.solver.penalty;

  // The best, then below, above and reset of each parameter.
  std::vector<std::vector<double>> points(1 + 3 * n, x);
  for (std::size_t i = 0; i < n; ++i) {
    points[points_of(i).below][i] = clamp_to_box(x[i] - kSensitivityStep);
    points[points_of(i).above][i] = clamp_to_box(x[i] + kSensitivityStep);
    points[points_of(i).reset][i] = start[i];
  }
  const Engine engine = engine_of_search(study);
  Merits simulated(study, objective, workers, stop, progress);
  auto found = simulated.of(points, engine);
  if (found && engine != Engine::kSimbody) found = simulated.confirmed(points, std::move(*found), kConfirmed);
  if (!found) return std::nullopt;
  const auto merit = [&](std::size_t p) { return (*found)[p]; };
  const auto gain_at = [&](std::size_t p, const GainEntry& entry) {
    return value(study.space.gains_at(points[p]), entry);
  };

  std::vector<double> merits;
  merits.reserve(journal.size());
  for (const EvaluationRow& row : journal) merits.push_back(row.objective + penalty * row.violation);
  Sensitivity result;
  result.merit = merit(0);
  for (std::size_t i = 0; i < n; ++i) {
    ParameterSensitivity& s = result.parameters.emplace_back();
    const GainEntry& entry = study.space.free[i].entry;
    const auto [below, above, reset] = points_of(i);
    s.parameter = i;
    s.best = gain_at(0, entry);
    s.local = std::max(std::abs(merit(below) - merit(0)), std::abs(merit(above) - merit(0))) / merit(0);
    const double spread = gain_at(above, entry) - gain_at(below, entry);
    s.elasticity = s.best > 0.0 ? (merit(above) - merit(below)) / merit(0) / (spread / s.best) : NAN;
    std::vector<double> coordinates;
    coordinates.reserve(journal.size());
    for (const EvaluationRow& row : journal) coordinates.push_back(row.x[i]);
    s.rank_correlation = rank_correlation(coordinates, merits);
    s.importance = merit(reset) - merit(0);
  }
  std::stable_sort(result.parameters.begin(), result.parameters.end(),
                   [](const auto& a, const auto& b) { return a.importance > b.importance; });
  return result;
}

std::string sensitivity_csv(const Study& study, const Sensitivity& sensitivity) {
  std::string text =
      "gain,unit,start,best,lower,upper,importance,local,elasticity,rank_correlation,"
      "status\n";
  for (const ParameterSensitivity& s : sensitivity.parameters) {
    const Parameter& p = study.space.free[s.parameter];
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", cell(p.entry.name), p.entry.field->unit,
                        cell(p.start), cell(s.best), cell(p.lower), cell(p.upper), cell(s.importance),
                        cell(s.local), cell(s.elasticity), cell(s.rank_correlation), cell(missing(s)));
  }
  return text;
}

std::vector<std::string> advice(const Study& study, const Sensitivity& sensitivity) {
  std::vector<std::string> lines;
  for (const ParameterSensitivity& s : sensitivity.parameters) {
    const Parameter& p = study.space.free[s.parameter];
    const std::string& name = p.entry.name;
    const bool no_effect = s.local < kNoEffect && std::abs(s.importance) < kNoEffect * sensitivity.merit;
    if (no_effect) {
      lines.push_back(
          fmt::format("{} has no effect: a step of {:.0f} % of its range changes the merit (objective plus "
                      "penalties) by {:.2g} %, and a return to its start value changes the merit by {:.2g} "
                      "%; fix the gain with '{{name: {}, fixed: {:.6g}}}'",
                      name, 100.0 * kSensitivityStep, 100.0 * s.local,
                      100.0 * s.importance / sensitivity.merit, name, p.start));
    } else if (s.best <= p.lower * (1.0 + 1e-9)) {
      lines.push_back(
          p.lower > 0.0
              ? fmt::format(
                    "{} ended at its lower bound {:.6g}; lower values may be better: set 'lower: {:.3g}'",
                    name, p.lower, 0.5 * p.lower)
              : fmt::format("{} ended at zero, the lowest possible value, so it does more harm than good "
                            "here; fix it with '{{name: {}, fixed: 0}}'",
                            name, name));
    } else if (s.best >= p.upper * (1.0 - 1e-9)) {
      lines.push_back(
          fmt::format("{} ended at its upper bound {:.6g}; higher values may be better: set 'upper: {:.3g}'",
                      name, p.upper, 2.0 * p.upper));
    }
  }
  return lines;
}

Study without_less_important_half(const Study& study, const Sensitivity& sensitivity) {
  Study reduced = study;
  reduced.description += " (only the more important half of the parameters)";
  reduced.space.free.clear();
  constexpr std::size_t kGone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> place(study.space.free.size(), kGone);
  const std::size_t kept = (study.space.free.size() + 1) / 2;
  std::vector<bool> keep(study.space.free.size(), false);
  for (std::size_t i = 0; i < kept; ++i) keep[sensitivity.parameters[i].parameter] = true;
  for (std::size_t i = 0; i < keep.size(); ++i) {
    if (!keep[i]) continue;
    place[i] = reduced.space.free.size();
    reduced.space.free.push_back(study.space.free[i]);
  }
  // A gain that was linked to a gain that is now fixed keeps its own start value, which is in the start
  // gains.
  std::erase_if(reduced.space.links, [&](const Link& link) { return place[link.parameter] == kGone; });
  for (Link& link : reduced.space.links) link.parameter = place[link.parameter];
  for (SweepAxis& axis : reduced.sweep) {
    std::erase_if(axis.parameters, [&](std::size_t p) { return place[p] == kGone; });
    for (std::size_t& p : axis.parameters) p = place[p];
  }
  std::erase_if(reduced.sweep, [](const SweepAxis& axis) { return axis.parameters.empty(); });
  return reduced;
}

}  // namespace armtune::internal
