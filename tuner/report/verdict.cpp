#include "tuner/report/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include "tuner/report/tables.hpp"
#include "tuner/run/comparison.hpp"

namespace armtune::report {
namespace {

/// Below this a change is not worth a word.
constexpr double kNoticeable = 0.01;

/// What every arm asks for, where there is no study.
std::vector<StudyLimit> limits_of_arm() {
  return {{Metric::kJointVelocityMaxRatio, true, 1.0, {}},
          {Metric::kJointPositionMinMargin, false, 0.0, {}},
          {Metric::kJointEffortMaxRatio, true, 1.0, {}}};
}

std::string entry(const VerdictFacts& facts, const std::string& key) {
  const auto found = facts.run.find(key);
  return found == facts.run.end() ? std::string() : found->second;
}

double number_entry(const VerdictFacts& facts, const std::string& key) {
  const std::string text = entry(facts, key);
  double value = NAN;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool noticeable(const Change& change) {
  return std::abs(change.ratio - 1.0) >= kNoticeable;
}

/// "falls by 62 %"
std::string how_much(const Change& change) {
  const double percent = 100.0 * (change.ratio - 1.0);
  return percent > 1000.0
             ? fmt::format("rises {:.3g}-fold", change.ratio)
             : fmt::format("{} by {:.0f} %", percent < 0.0 ? "falls" : "rises", std::abs(percent));
}

/// "the largest orientation error falls by 62 %"
std::string words(const Change& change) {
  return fmt::format("the {} {}", field(change.metric).words, how_much(change));
}

/// "error/orientation/max falls by 62 % (largest angle to the gaze orientation while tracking)"
std::string exact_words(const Change& change) {
  return fmt::format("{} {} ({})", name(change.metric), how_much(change), field(change.metric).meaning);
}

/// The best one or two improvements; empty if there is none.
std::string improvements(const std::vector<Change>& all) {
  std::vector<std::string> told;
  for (const Change& change : all) {
    if (told.size() < 2 && change.worsening() < 1.0 - kNoticeable) told.push_back(words(change));
  }
  return fmt::format("{}", fmt::join(told, " and "));
}

/// What got worse the most; empty if nothing did.
std::string price(const std::vector<Change>& all) {
  if (all.empty() || all.back().worsening() < 1.0 + kNoticeable) return {};
  return words(all.back());
}

/// The parts that are not empty as one sentence. Names of joints and metrics keep their letters.
std::string joined(const std::vector<std::string>& parts) {
  std::vector<std::string> told;
  for (const std::string& part : parts) {
    if (!part.empty()) told.push_back(part);
  }
  if (told.empty()) return {};
  std::string text = fmt::format("{}.", fmt::join(told, "; "));
  const std::string first = text.substr(0, text.find(' '));
  if (first.find_first_of("_/") == std::string::npos && first.front() >= 'a' && first.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string violated(const std::vector<std::string>& broken) {
  if (broken.empty()) return {};
  return broken.size() == 1 ? broken.front()
                            : fmt::format("{} (and {} more)", broken.front(), broken.size() - 1);
}

void add(std::vector<std::string>& details, const std::vector<std::string>& lines, std::size_t most) {
  for (std::size_t i = 0; i < lines.size() && i < most; ++i) details.push_back(lines[i]);
  if (lines.size() > most) details.push_back(fmt::format("and {} more", lines.size() - most));
}

std::vector<StudyTerm> headline_terms() {
  std::vector<StudyTerm> terms;
  for (const Metric metric : headline_metrics()) terms.push_back({metric, {}});
  return terms;
}

constexpr std::size_t kMostLines = 12;

Verdict of_tune(const ReportData& data, const VerdictFacts& facts) {
  const std::size_t tuned = data.sets.size() - 1;
  const std::string ended = entry(facts, "ended");
  const double objective = number_entry(facts, "objective");
  const auto all = changes(data.tables, facts.study ? facts.study->terms : headline_terms(), tuned);
  const auto broken = violations(facts.judged.empty() ? data.tables : facts.judged,
                                 facts.study ? facts.study->limits : limits_of_arm(), tuned);
  const bool feasible =
      entry(facts, "feasible") == "true" || (entry(facts, "feasible").empty() && broken.empty());
  const bool interrupted = ended.find("interrupted") != std::string::npos;
  std::string gain;
  if (!std::isnan(objective)) {
    gain = objective < 1.0 ? fmt::format("the objective falls by {:.0f} %", 100.0 * (1.0 - objective))
                           : fmt::format("the objective is {:.3g} times the start's, no better", objective);
  }
  Verdict verdict;
  verdict.sentence = joined({interrupted ? "Interrupted before the search was finished" : "",
                             feasible ? "" : "no feasible point was found: the best one breaks a constraint",
                             feasible ? "" : violated(broken), gain, improvements(all),
                             closest_joint(data.tables, tuned), feasible ? "every constraint holds" : ""});
  if (data.evaluations) {
    verdict.details.push_back(fmt::format("{} evaluations{}", data.evaluations->objective.size(),
                                          ended.empty() ? "" : "; " + ended));
  }
  add(verdict.details, broken, kMostLines);
  const std::string worse =
      price(changes(data.tables, headline_terms(), tuned));  // whether the study asks or not
  if (!worse.empty()) verdict.details.push_back("The price: " + worse);
  for (const Change& change : all) {
    if (!noticeable(change)) continue;
    verdict.details.push_back(exact_words(change) + ", over the study's scenarios");
  }
  return verdict;
}

/// Over the scenarios, of the first set; NaN where none has a value.
double largest(const std::vector<Table>& tables, Metric metric) {
  double found = NAN;
  for (const Table& table : tables) found = std::fmax(found, value_of(table, metric, 0));
  return found;
}

Verdict of_simulate(const ReportData& data) {
  std::vector<std::string> failed;
  for (const Table& table : data.tables) {
    for (const std::string& status : table.status) {
      if (!status.empty() && status != "completed")
        failed.push_back(fmt::format("{} is {}", table.scenario, status));
    }
  }
  const auto broken = violations(data.tables, limits_of_arm(), 0);
  const double position = largest(data.tables, Metric::kPositionMax);
  const double orientation = largest(data.tables, Metric::kOrientationMax);
  Verdict verdict;
  verdict.sentence = joined(
      {failed.empty()
           ? fmt::format("all {} scenarios completed", data.tables.size())
           : fmt::format("{} of {} scenarios failed: {}", failed.size(), data.tables.size(), failed.front()),
       std::isnan(position) ? ""
                            : fmt::format("while tracking the tool is at most {:.3g} mm and {:.3g} deg off",
                                          1e3 * position, orientation * 180.0 / std::numbers::pi),
       closest_joint(data.tables, 0), broken.empty() ? "no limit of the arm is broken" : violated(broken)});
  add(verdict.details, failed, kMostLines);
  add(verdict.details, broken, kMostLines);
  return verdict;
}

Verdict of_compare(const ReportData& data) {
  const std::size_t last = data.sets.size() - 1;
  const auto all = changes(data.tables, headline_terms(), last);
  const auto broken = violations(data.tables, limits_of_arm(), last);
  const auto better = std::count_if(all.begin(), all.end(),
                                    [](const Change& c) { return c.worsening() < 1.0 - kNoticeable; });
  Verdict verdict;
  verdict.sentence = joined({fmt::format("against {}, {} is better in {} of {} figures", data.sets[0],
                                         data.sets[last], better, all.size()),
                             improvements(all), price(all), closest_joint(data.tables, last),
                             broken.empty() ? "no limit of the arm is broken" : violated(broken)});
  for (std::size_t set = 0; set < data.sets.size(); ++set) {
    if (const std::string closest = closest_joint(data.tables, set); !closest.empty()) {
      verdict.details.push_back(fmt::format("{}: {}", data.sets[set], closest));
    }
    std::vector<std::string> lines;
    for (const std::string& line : violations(data.tables, limits_of_arm(), set)) {
      lines.push_back(fmt::format("{}: {}", data.sets[set], line));
    }
    add(verdict.details, lines, kMostLines);
  }
  return verdict;
}

/// Nowhere worse than the start and somewhere better.
bool beats(const FrontPoint& point, const FrontPoint& start, const Front& front) {
  bool somewhere = false;
  for (std::size_t c = 0; c < front.criteria.size(); ++c) {
    const auto metric = metric_from_name(front.criteria[c].first);
    const double sign = metric && larger_is_better(*metric) ? -1.0 : 1.0;
    const double difference = sign * (point.values[c] - start.values[c]);
    if (!(difference <= 0.0)) return false;
    somewhere = somewhere || difference < 0.0;
  }
  return somewhere;
}

Verdict of_pareto(const ReportData& data) {
  Verdict verdict;
  if (!data.front) return verdict;
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
        "{} from {:.4g} to {:.4g}{}", data.front->criteria[c].first, low, high,
        start != data.front->points.end() ? fmt::format(" (start {:.4g})", start->values[c]) : ""));
  }
  const std::size_t last = data.sets.empty() ? 0 : data.sets.size() - 1;
  const auto better =
      start == data.front->points.end()
          ? 0
          : std::count_if(data.front->points.begin(), data.front->points.end(),
                          [&](const FrontPoint& p) { return is_point(p) && beats(p, *start, *data.front); });
  verdict.sentence = joined(
      {points == 0
           ? "no feasible point was found"
           : fmt::format("the front has {} points, {} of them nowhere worse than the start and somewhere "
                         "better: {}",
                         points, better, fmt::join(ranges, ", ")),
       data.front->hypervolume ? fmt::format("hypervolume {:.3f}", *data.front->hypervolume) : "",
       last > 0 ? closest_joint(data.tables, last) : ""});
  verdict.details = std::move(ranges);
  if (last > 0) {
    for (const Change& change : changes(data.tables, headline_terms(), last)) {
      if (!noticeable(change)) continue;
      verdict.details.push_back(fmt::format("{}: {}", data.sets[last], exact_words(change)));
    }
  }
  return verdict;
}

Verdict of_robustness(const ReportData& data) {
  Verdict verdict;
  if (!data.robustness || data.robustness->samples == 0) {
    verdict.sentence = "Interrupted before the first arm was simulated.";
    return verdict;
  }
  const Robustness& r = *data.robustness;
  verdict.sentence = joined(
      {fmt::format("{:.1f} % of {} arms keep every limit (95 % confidence: {:.1f} to {:.1f} %)",
                   100.0 * static_cast<double>(r.kept) / static_cast<double>(r.samples), r.samples,
                   100.0 * r.interval.first, 100.0 * r.interval.second),
       r.broken.empty()
           ? ""
           : fmt::format("most often broken: {}, by {}", r.broken.front().first, r.broken.front().second),
       closest_joint(data.tables, 0).empty() ? "" : "on the nominal arm " + closest_joint(data.tables, 0)});
  for (const auto& [limit, count] : r.broken) {
    verdict.details.push_back(fmt::format("{} of {} arms: {}", count, r.samples, limit));
  }
  return verdict;
}

}  // namespace

Verdict verdict_of(const ReportData& data, const VerdictFacts& facts) {
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
  }
  return {};
}

}  // namespace armtune::report
