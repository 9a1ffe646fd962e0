#include "tuner/evaluation/evaluations_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

/// A scenario (index) and a metric, which have one column even if they occur in several terms.
using Figure = std::pair<std::size_t, Metric>;

bool of_margin(const ObjectiveTerm&) {
  return false;
}
bool of_margin(const Constraint& constraint) {
  return constraint.margin.has_value();
}

template <typename Term>
std::vector<Figure> figures(const std::vector<Term>& terms) {
  std::vector<Figure> all;
  for (const Term& term : terms) {
    if (of_margin(term)) continue;
    for (const std::size_t s : term.scenarios) {
      const Figure figure{s, term.metric};
      if (std::find(all.begin(), all.end(), figure) == all.end()) all.push_back(figure);
    }
  }
  return all;
}

}  // namespace

std::vector<Column> evaluation_columns(const Study& study, const std::vector<ExtraColumn>& extra) {
  std::vector<Column> columns;
  const auto add = [&columns](const std::string& name, const char* unit, const std::string& meaning) {
    columns.push_back({name, unit, meaning, {}});
  };
  add("evaluation", "1", "number of the evaluation, from 0");
  add("phase", "",
      "phase of the search: start, sweep, warm, global, search, gradient, final, verify; in a trade-off: "
      "start, warm, anchor, level, gradient");
  add("engine", "", "engine of the simulation: simbody or native");
  add("objective", "1", "objective of the evaluation, relative to the start gains; 1 for the start gains");
  add("feasible", "1", "1 if every constraint holds in every scenario");
  add("violation", "1",
      "sum of the violations of all constraints, each relative to its limit; if a scenario did not complete, "
      "larger than for any candidate that completed every scenario");
  add("status", "", "completed, or the reason why the first failed scenario ended");
  for (const Parameter& p : study.space.free) add(p.entry.name, p.entry.field->unit, p.entry.field->meaning);
  for (const auto& [s, metric] : figures(study.terms)) {
    const MetricField& f = field(metric);
    add(fmt::format("{}/{}", study.scenarios[s].name, f.name), f.unit, f.meaning);
  }
  for (const auto& [s, metric] : figures(study.constraints)) {
    const MetricField& f = field(metric);
    add(fmt::format("constraint/{}/{}", study.scenarios[s].name, f.name), f.unit, f.meaning);
  }
  for (const MarginDemand& demand : study.margins) {
    add(fmt::format("margin/{}", name(demand.kind)), "1",
        fmt::format("largest violation of a limit in any scenario, simulated with {} at {}; 0 or less if "
                    "every limit holds",
                    name(demand.kind), demand.value));
  }
  if (study.final_phase) {
    add("copies", "1",
        "number of perturbed copies simulated for derivatives so far; each counts as one evaluation of the "
        "study's max_evaluations, and has no row");
  }
  for (const ExtraColumn& e : extra) columns.push_back(e.column);
  add("time/wall", "s", "wall time of the run so far");
  return columns;
}

EvaluationsFile::EvaluationsFile(const std::string& path, const Study& study, std::vector<ExtraColumn> extra,
                                 AppendFile::Open open)
    : file_(path, open), study_(study), extra_(std::move(extra)) {
  std::string header;
  for (const Column& column : evaluation_columns(study, extra_)) {
    header += (header.empty() ? "" : ",") + cell(column.name);
  }
  file_.append(header + "\n", false);
}

void EvaluationsFile::append(const std::string& phase, const Evaluation& e) {
  std::string row =
      fmt::format("{},{},{},{},{},{},{}", count_++, phase, name(e.engine), cell(e.objective),
                  e.feasible ? 1 : 0, cell(e.violation), cell(e.completed ? "completed" : e.reason));
  for (const Parameter& p : study_.space.free) row += "," + cell(value(e.gains, p.entry));
  for (const auto& [s, metric] : figures(study_.terms)) row += "," + cell(e.results[s].metrics[metric]);
  for (const auto& [s, metric] : figures(study_.constraints)) row += "," + cell(e.results[s].metrics[metric]);
  for (std::size_t m = 0; m < study_.margins.size(); ++m) {
    const std::size_t c = study_.constraints.size() - study_.margins.size() + m;
    row += "," + cell(c < e.constraints.size() ? e.constraints[c] : NAN);
  }
  if (study_.final_phase) row += fmt::format(",{}", e.copies);
  for (const ExtraColumn& extra : extra_) row += "," + cell(extra.value(e));
  // Only the journal has to survive a power cut, because this file can be written again from it.
  file_.append(row + fmt::format(",{:.3f}\n", e.seconds), false);
  if (!e.recalled) file_.publish();
}

}  // namespace armtune::internal
