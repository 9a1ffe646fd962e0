#include "tuner/trade_off/pareto_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sim/csv/cell.hpp"
#include "sim/scenario/data_files.hpp"

namespace armtune::internal {
namespace {

/// True if the study's objective is a criterion. If not, pareto.csv has a further column with it.
bool has_objective(const ParetoOptions& options) {
  return std::any_of(options.criteria.begin(), options.criteria.end(),
                     [](const Criterion& c) { return !c.metric; });
}

std::string start_name(const Study& study) {
  return fmt::format("start ({})", stem(study.gains));
}

}  // namespace

std::vector<Column> pareto_columns(const Study& study, const ParetoOptions& options) {
  std::vector<Column> columns;
  const auto add = [&columns](const std::string& name, const std::string& unit, const std::string& meaning) {
    columns.push_back({name, unit, meaning, {}});
  };
  add("point", "1", "number of the point; its gains are in points/");
  add("kind", "", "front: a point that no other point dominates; start: the study's start gains");
  add("evaluation", "1", "number of the point in evaluations.csv");
  add("dominates_start", "1",
      "1 if the point is better than the start in at least one criterion and worse in none");
  for (const Criterion& c : options.criteria) {
    add(c.name(), c.unit(),
        c.metric ? fmt::format("{}; worst value of all scenarios", field(*c.metric).meaning)
                 : "weighted metrics, each divided by its value with the start gains; 1 for the start gains");
  }
  if (!has_objective(options)) add("objective", "1", "weighted metrics relative to the start gains");
  for (const Parameter& p : study.space.free) add(p.entry.name, p.entry.field->unit, p.entry.field->meaning);
  return columns;
}

std::string pareto_csv(const Study& study, const ParetoOptions& options, const ParetoResult& result) {
  std::string text;
  for (const Column& column : pareto_columns(study, options)) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  const auto row = [&](const std::string& point, const char* kind, const ParetoPoint& p) {
    text +=
        fmt::format("{},{},{},{}", point, kind, p.evaluation, dominates(p.costs, result.start.costs) ? 1 : 0);
    for (const Criterion& c : options.criteria) text += "," + cell(value(c, p.e, study.scenarios));
    if (!has_objective(options)) text += "," + cell(p.e.objective);
    for (const Parameter& parameter : study.space.free) {
      text += "," + cell(value(p.e.gains, parameter.entry));
    }
    text += '\n';
  };
  for (std::size_t i = 0; i < result.front.size(); ++i)
    row(fmt::format("{}", i + 1), "front", result.front[i]);
  row("", "start", result.start);
  return text;
}

std::string pareto_table(const Study& study, const ParetoOptions& options, const ParetoResult& result) {
  std::string text = fmt::format("{:<20}", "point");
  for (const Criterion& c : options.criteria) text += fmt::format("  {:>28}", c.name());
  text += "\n";
  const auto row = [&](const std::string& name, const ParetoPoint& p, const char* note) {
    text += fmt::format("{:<20}", name);
    for (const Criterion& c : options.criteria)
      text += fmt::format("  {:>28.5g}", value(c, p.e, study.scenarios));
    text += fmt::format("{}\n", note);
  };
  std::set<std::size_t> shown;
  for (const ParetoLevel& level : result.levels) shown.insert(level.best);
  if (!result.front.empty()) shown.insert({0, result.front.size() - 1});
  for (const std::size_t i : shown) {
    const bool better = dominates(result.front[i].costs, result.start.costs);
    row(point_file(i), result.front[i], better ? "  dominates the start" : "");
  }
  row(start_name(study), result.start,
      result.start.e.feasible ? "" : "  breaks a constraint; the points above do not");
  // If larger values of a metric are better, its cost is negative, and the hypervolume may exceed 1.
  const bool bounded =
      std::all_of(result.start.costs.begin(), result.start.costs.end(), [](double c) { return c > 0.0; });
  if (result.front.empty()) {
    return text +
           "\nno feasible point was found; evaluations.csv shows which constraints are broken. Allow more "
           "evaluations, or relax the study's constraints.\n";
  }
  text += fmt::format("\n{} of the front's {} points dominate the start; hypervolume {:.4f}{}\n",
                      result.dominating_start(), result.front.size(), result.hypervolume,
                      bounded ? " (share of the region better than the start; at most 1)" : "");
  return text;
}

std::string point_file(std::size_t point) {
  return fmt::format("points/{:02}.yaml", point + 1);
}

}  // namespace armtune::internal
