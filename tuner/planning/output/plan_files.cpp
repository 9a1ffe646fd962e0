#include "tuner/planning/output/plan_files.hpp"

#include "core/common/message_text.hpp"
#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

std::string header(const std::vector<PlanColumn>& columns) {
  std::string text;
  for (const PlanColumn& column : columns) text += (text.empty() ? "" : ",") + column.name;
  return text + '\n';
}

void add_row(const std::vector<PlanColumn>& columns, const PlanSample& at, std::string& text) {
  for (std::size_t c = 0; c < columns.size(); ++c) text += (c == 0 ? "" : ",") + cell(columns[c].value(at));
  text += '\n';
}

/// Returns the text in quotes, because names may contain commas. If a spreadsheet would take the text for a
/// formula, the cell begins with an apostrophe.
std::string text_cell(const std::string& text) {
  std::string out = is_formula(text) ? "\"'" : "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

/// Returns the periods in which one bound is active, such as "8.01:8.05 8.2:8.21" [s].
std::string stretches(const LimitUse& use, bool upper) {
  std::string text;
  for (const Stretch& stretch : use.stretches) {
    if (stretch.upper == upper)
      text += (text.empty() ? "" : " ") + cell(stretch.from) + ":" + cell(stretch.to);
  }
  return text;
}

}  // namespace

std::string trajectory_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory) {
  const std::vector<PlanColumn> columns = trajectory_columns(task, *problem.robot);
  std::string text = header(columns);
  PlanSampler sampler(task, problem, trajectory);
  for (Eigen::Index k = 0; k < trajectory.position.cols(); ++k) add_row(columns, sampler.at_knot(k), text);
  return text;
}

std::vector<double> motion_rows(const PlanTask& task, const PlanProblem& problem,
                                const Trajectory& trajectory, int rows) {
  const std::vector<PlanColumn> columns = motion_columns(task, *problem.robot);
  std::vector<double> values;
  PlanSampler sampler(task, problem, trajectory);
  const double start = trajectory.time.front();
  const double duration = trajectory.time.back() - start;
  for (int row = 0; row < rows; ++row) {
    const PlanSample& at = sampler.at(start + duration * row / (rows - 1));
    for (const PlanColumn& column : columns) values.push_back(column.value(at));
  }
  return values;
}

std::string motion_csv(const PlanTask& task, const PlanProblem& problem, const Trajectory& trajectory,
                       int rows) {
  const std::vector<PlanColumn> columns = motion_columns(task, *problem.robot);
  std::string text = header(columns);
  std::size_t column = 0;
  for (const double value : motion_rows(task, problem, trajectory, rows)) {
    text += cell(value);
    column = (column + 1) % columns.size();
    text += column == 0 ? '\n' : ',';
  }
  return text;
}

std::string limits_csv(const std::vector<LimitUse>& uses) {
  std::string text;
  for (const Column& column : limits_columns()) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (const LimitUse& use : uses) {
    text += text_cell(use.limit) + "," + text_cell(name(use.kind)) + "," + text_cell(use.part) + "," +
            text_cell(use.unit) + "," + cell(use.lower) + "," + cell(use.upper) + "," + cell(use.from) + "," +
            cell(use.to) + "," + cell(use.at_knots) + "," +
            // A limit that applies at a single knot has no value between knots.
            (use.from < use.to ? cell(use.between) : "") + "," + cell(use.share) + "," + cell(use.strength) +
            "," + stretches(use, false) + "," + stretches(use, true) + "\n";
  }
  return text;
}

std::vector<Column> limits_columns() {
  return {{"limit", "", "name of the limit", {}},
          {"kind",
           "",
           "kind of limit: position, velocity, acceleration, jerk, torque, tool path, gaze, or the distance "
           "to an obstacle, a cell part or the floor, or between links",
           {}},
          {"part", "", "joint, axis or link that the limit applies to", {}},
          {"unit", "", "unit of lower and upper", {}},
          {"lower", "", "lower limit of the task; empty if there is none", {}},
          {"upper", "", "upper limit of the task; empty if there is none", {}},
          {"from", "s", "time from which the limit applies", {}},
          {"to", "s", "time until which the limit applies", {}},
          {"at_knots", "1", "largest share of the limit used at any knot; 1: the limit is reached", {}},
          {"between_knots",
           "1",
           "largest share of the limit used between knots, where torque, tool path, gaze and distances are "
           "not constrained; empty if the limit applies at a single knot",
           {}},
          {"active", "1", "share of the knots at which the limit is active", {}},
          {"strength",
           "",
           "sum of the limit's Lagrange multipliers: seconds or cost saved if the limit is relaxed by one "
           "unit",
           {}},
          {"active_lower", "s", "time intervals FROM:TO in which the lower limit is active", {}},
          {"active_upper", "s", "time intervals FROM:TO in which the upper limit is active", {}}};
}

}  // namespace armtune::internal
