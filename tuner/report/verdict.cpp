#include "tuner/report/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tuner/report/findings.hpp"
#include "tuner/report/tables.hpp"
#include "tuner/report/words.hpp"
#include "tuner/rollouts/comparison.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostLines = 12;

std::vector<StudyTerm> headline_terms() {
  std::vector<StudyTerm> terms;
  for (const Metric metric : headline_metrics()) terms.push_back({metric, {}});
  return terms;
}

/// Returns the verdict of a run that has no record yet.
Verdict of_unfinished(const ReportData& data, const VerdictFacts& facts) {
  Verdict verdict;
  std::string so_far = "nothing was evaluated";
  if (data.evaluations && data.evaluations->chosen >= 0) {
    const Evaluations& e = *data.evaluations;
    const auto best = static_cast<std::size_t>(e.chosen);
    so_far = e.feasible[best]
                 ? fmt::format("the best feasible one of {} evaluations has an objective of {:.3g}",
                               e.objective.size(), e.objective[best])
                 : fmt::format("none of {} evaluations is feasible", e.objective.size());
  } else if (data.evaluations) {
    so_far = fmt::format("{} evaluations", data.evaluations->objective.size());
  } else if (data.robustness) {
    so_far = fmt::format("{} of {} arms keep every limit", data.robustness->kept, data.robustness->samples);
  }
  verdict.sentence = joined({data.live ? "This run is still running"
                                       : "This run is not finished: it is still running, or it was killed",
                             "so far " + so_far});
  if (facts.resumable && !data.live) {
    verdict.details.push_back(fmt::format("To resume it: armtune {} --resume FOLDER", name(data.kind)));
  }
  return verdict;
}

/// Compares the result with the start. For a study on many arms, uses the risk measures over the arms.
Verdict of_tune(const ReportData& data, const VerdictFacts& facts) {
  const std::size_t tuned = data.sets.size() - 1;
  const std::vector<Table>& tables = data.judged ? data.judged->tables : data.tables;
  const SearchFacts* search = facts.search();
  const TunedFacts* found = facts.tuned();
  const double objective = found != nullptr ? found->objective.value_or(NAN) : NAN;
  const auto all = changes(tables, facts.study ? facts.study->terms : headline_terms(), tuned);
  const auto asked = facts.study ? facts.study->limits : limits_of_arm();
  const auto broken = wrong_with(tables, asked, tuned);
  const auto beside = beyond_arm(tables, asked, tuned);
  const bool feasible = found != nullptr ? found->feasible : broken.empty();
  const bool interrupted = search != nullptr && search->ended == SearchEnd::kInterrupted;
  std::string gain;
  if (!std::isnan(objective)) {
    gain = objective < 1.0
               ? fmt::format("the objective falls by {:.0f} %", 100.0 * (1.0 - objective))
               : fmt::format("the objective did not improve: it is {:.3g} times that of the start gains",
                             objective);
  }
  std::string kept = feasible ? "every constraint holds" : "";
  if (feasible && !beside.empty()) kept += ", but the arm's own limits do not: " + first_of(beside);
  Verdict verdict;
  verdict.sentence =
      joined({interrupted ? "Interrupted before the search was finished" : "",
              feasible ? "" : "no feasible point was found: even the best point breaks a constraint",
              feasible ? "" : first_of(broken), gain, improvements(all, tables.size()),
              closest_joint(tables, tuned), kept});
  if (data.judged) {
    verdict.details.push_back(
        fmt::format("Every number in this summary is the {}; the numbers of the nominal arm are below",
                    data.judged->measure));
  }
  if (data.evaluations) {
    const std::string reason = search != nullptr ? search->reason : "";
    verdict.details.push_back(fmt::format("{} evaluations{}", data.evaluations->objective.size(),
                                          reason.empty() ? "" : "; " + reason));
  }
  add(verdict.details, broken, kMostLines);
  if (beside.size() > 1 || !feasible) add(verdict.details, beside, kMostLines);
  if (const std::string worse = price(tables, tuned); !worse.empty()) {
    verdict.details.push_back("The price: " + worse);
  }
  for (const Change& change : all) {
    if (noticeable(change.ratio)) verdict.details.push_back(capital(exact_words(change, tables.size())));
  }
  return verdict;
}

/// Returns the largest value of the first set over the scenarios; NaN if none has a value.
double largest(const std::vector<Table>& tables, Metric metric) {
  double found = NAN;
  for (const Table& table : tables) found = std::fmax(found, value_of(table, metric, 0));
  return found;
}

Verdict of_simulate(const ReportData& data) {
  if (data.tables.empty()) return {"The numbers of this run could not be read.", {}};
  const auto failed = failures(data.tables, 0);
  const auto broken = violations(data.tables, limits_of_arm(), 0);
  const double position = largest(data.tables, Metric::kPositionMax);
  const double orientation = largest(data.tables, Metric::kOrientationMax);
  const std::size_t count = data.tables.size();
  const std::string completed = count == 1   ? "the scenario completed"
                                : count == 2 ? "both scenarios completed"
                                             : fmt::format("all {} scenarios completed", count);
  Verdict verdict;
  verdict.sentence = joined(
      {failed.empty() ? completed
                      : fmt::format("{} of {} scenarios failed: {}", failed.size(), count, first_of(failed)),
       std::isnan(position) ? ""
                            : fmt::format("while tracking, the tool error is up to {:.3g} mm and {:.3g} deg",
                                          1e3 * position, orientation * 180.0 / std::numbers::pi),
       closest_joint(data.tables, 0),
       !broken.empty()  ? first_of(broken)
       : failed.empty() ? "no limit of the arm is broken"
                        : ""});
  if (failed.size() > 1) add(verdict.details, failed, kMostLines);
  if (broken.size() > 1) add(verdict.details, broken, kMostLines);
  return verdict;
}

Verdict of_compare(const ReportData& data) {
  if (data.sets.size() < 2 || data.tables.empty()) return of_simulate(data);
  const std::size_t last = data.sets.size() - 1;
  const auto all = changes(data.tables, headline_terms(), last);
  const auto broken = wrong_with(data.tables, limits_of_arm(), last);
  const auto better = std::count_if(all.begin(), all.end(), improvement);
  Verdict verdict;
  verdict.sentence = joined({fmt::format("compared with {}, {} is better in {} of {} metrics", data.sets[0],
                                         data.sets[last], better, all.size()),
                             improvements(all, data.tables.size()), price(data.tables, last),
                             closest_joint(data.tables, last),
                             broken.empty() ? "no limit of the arm is broken" : first_of(broken)});
  for (std::size_t set = 0; set < data.sets.size(); ++set) {
    if (set > 0 && set < last) {
      const auto others = improvements(changes(data.tables, headline_terms(), set), data.tables.size());
      if (!others.empty()) verdict.details.push_back(fmt::format("{}: {}", data.sets[set], others));
    }
    if (const std::string closest = closest_joint(data.tables, set); !closest.empty()) {
      verdict.details.push_back(fmt::format("{}: {}", data.sets[set], closest));
    }
    std::vector<std::string> lines;
    for (const std::string& line : wrong_with(data.tables, limits_of_arm(), set)) {
      lines.push_back(fmt::format("{}: {}", data.sets[set], line));
    }
    add(verdict.details, lines, kMostLines);
  }
  return verdict;
}

/// True if the point is in no criterion worse than the start, and in some criterion better.
bool beats(const FrontPoint& point, const FrontPoint& start, const Front& front) {
  bool somewhere = false;
  for (std::size_t c = 0; c < front.criteria.size(); ++c) {
    const auto metric = metric_from_name(front.criteria[c].name);
    const double sign = metric && larger_is_better(*metric) ? -1.0 : 1.0;
    const double difference = sign * (point.values[c] - start.values[c]);
    if (!(difference <= 0.0)) return false;
    somewhere = somewhere || difference < 0.0;
  }
  return somewhere;
}

Verdict of_pareto(const ReportData& data) {
  Verdict verdict;
  if (!data.front) return {"The trade-off front of this run could not be read.", {}};
  const auto is_point = [](const FrontPoint& p) { return p.role != "start"; };
  const auto points = std::count_if(data.front->points.begin(), data.front->points.end(), is_point);
  const auto start = std::find_if_not(data.front->points.begin(), data.front->points.end(), is_point);
  std::vector<std::string> ranges;
  for (std::size_t c = 0; c < data.front->criteria.size(); ++c) {
    double low = INFINITY;
    double high = -INFINITY;
    for (const FrontPoint& point : data.front->points) {
      if (!is_point(point)) continue;
      low = std::min(low, point.values[c]);
      high = std::max(high, point.values[c]);
    }
    if (points == 0) continue;
    ranges.push_back(fmt::format(
        "{} from {:.4g} to {:.4g}{}", data.front->criteria[c].name, low, high,
        start != data.front->points.end() ? fmt::format(" (start {:.4g})", start->values[c]) : ""));
  }
  const std::size_t last = data.sets.empty() ? 0 : data.sets.size() - 1;
  const auto better =
      start == data.front->points.end()
          ? 0
          : std::count_if(data.front->points.begin(), data.front->points.end(),
                          [&](const FrontPoint& p) { return is_point(p) && beats(p, *start, *data.front); });
  verdict.sentence =
      joined({points == 0 ? "no feasible point was found"
                          : fmt::format("the trade-off front has {} points (dominating the start: {}) and "
                                        "spans {}",
                                        points, better, fmt::join(ranges, ", ")),
              data.front->hypervolume ? fmt::format("hypervolume {:.3f}", *data.front->hypervolume) : "",
              last > 0 ? closest_joint(data.tables, last) : ""});
  verdict.details = std::move(ranges);
  if (last > 0) {
    verdict.details.push_back(fmt::format("Replay, plots and tables show {}, which has the best {}",
                                          data.sets[last], data.front->criteria.front().name));
    const auto told = improvements(changes(data.tables, headline_terms(), last), data.tables.size());
    if (!told.empty()) verdict.details.push_back(fmt::format("{}: {}", data.sets[last], told));
    const std::string worse = price(data.tables, last);
    if (!worse.empty()) verdict.details.push_back("The price: " + worse);
    add(verdict.details, violations(data.tables, limits_of_arm(), last), kMostLines);
  }
  return verdict;
}

Verdict of_robustness(const ReportData& data) {
  Verdict verdict;
  if (!data.robustness) return {"The samples of this run could not be read.", {}};
  if (data.robustness->samples == 0) {
    verdict.sentence = "Interrupted before the first arm was simulated.";
    return verdict;
  }
  const Robustness& r = *data.robustness;
  verdict.sentence = joined(
      {fmt::format("{:.1f} % of {} arms keep every limit (95 % confidence: {:.1f} to {:.1f} %)",
                   100.0 * r.yield(), r.samples, 100.0 * r.interval.first, 100.0 * r.interval.second),
       r.broken.empty() ? ""
                        : fmt::format("most often broken: {}, by {} of the arms", r.broken.front().first,
                                      r.broken.front().second),
       closest_joint(data.tables, 0).empty() ? "" : "on the nominal arm, " + closest_joint(data.tables, 0)});
  for (const auto& [limit, count] : r.broken) {
    verdict.details.push_back(fmt::format("{} of {} arms: {}", count, r.samples, limit));
  }
  return verdict;
}

Verdict of_run(const ReportData& data, const VerdictFacts& facts) {
  const bool searches =
      data.kind == RunKind::kTune || data.kind == RunKind::kPareto || data.kind == RunKind::kRobustness;
  if (searches && !facts.ended) return of_unfinished(data, facts);
  switch (data.kind) {
    case RunKind::kSimulate:
      return of_simulate(data);
    case RunKind::kTune:
      return of_tune(data, facts);
    case RunKind::kPareto:
      return of_pareto(data);
    case RunKind::kRobustness:
      return of_robustness(data);
    case RunKind::kCompare:
      return of_compare(data);
    default:  // plan_report.cpp, validation_report.cpp and calibration_report.cpp make their own
      break;
  }
  return {};
}

/// The simulation checks come before everything else.
void put_checks_first(const SimulationVerdict& checks, Verdict& verdict) {
  verdict.sentence = headline(checks) + ". " + verdict.sentence;
  std::vector<std::string> lines;
  for (const Check& check : checks.checks) {
    if (!check.passed) lines.push_back("Failed: " + to_text(check));
  }
  const auto add_list = [&lines](const char* what, const std::vector<std::string>& items) {
    if (!items.empty()) lines.push_back(fmt::format("{}: {}", what, fmt::join(items, "; ")));
  };
  add_list("Not checked", checks.not_checked);
  add_list("Assumes", checks.assumes);
  for (const std::string& note : checks.notes) lines.push_back("Note: " + note);
  verdict.details.insert(verdict.details.begin(), lines.begin(), lines.end());
}

}  // namespace

Verdict verdict_of(const ReportData& data, const VerdictFacts& facts) {
  Verdict verdict = of_run(data, facts);
  const std::size_t result = data.sets.empty() ? 0 : data.sets.size() - 1;
  const std::string sentence = yardstick_sentence(data.yardstick, result);
  if (!sentence.empty()) verdict.details.insert(verdict.details.begin(), sentence);
  if (facts.checks) put_checks_first(*facts.checks, verdict);
  return verdict;
}

}  // namespace armtune::internal::report
