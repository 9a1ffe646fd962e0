#include "tuner/planning/yardstick/yardstick_file.hpp"

#include <fmt/format.h>

#include "sim/csv/cell.hpp"

namespace armtune::internal {

std::string yardstick_csv(const std::vector<Measure>& measures) {
  std::string text;
  for (const Column& column : yardstick_columns()) text += (text.empty() ? "" : ",") + column.name;
  text += '\n';
  for (const Measure& m : measures) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", cell(m.scenario), name(m.event.kind),
                        cell(m.event.time), name(m.event.state), cell(m.event.reached), cell(m.limit),
                        cell(m.ratio()), unit(m.event.kind), words(m.event.outcome), cell(m.held_back_by),
                        cell(m.clearance), words(m.status));
  }
  return text;
}

std::vector<Column> yardstick_columns() {
  return {
      {"scenario", "", "name of the scenario", {}},
      {"event",
       "",
       "switch: time until the gaze stays on the next target; return: time until the tool follows the path "
       "again; lap: RMS gaze angle over one turn of the path",
       {}},
      {"time", "s", "time at which the event begins", {}},
      {"state", "", "state of the controller at that time", {}},
      {"reached",
       "s, rad",
       "time or RMS angle that the controller achieved, computed from the rows of the rollout's file",
       {}},
      {"limit",
       "s, rad",
       "least time or RMS angle that the planner found within the arm's limits, from the same state",
       {}},
      {"ratio",
       "1",
       "the reached value divided by the limit; empty if either is missing or the limit is 0",
       {}},
      {"unit", "", "unit of reached and limit", {}},
      {"outcome",
       "",
       "how the event ended: reached; already there; not before the next switch; cut off by the end of the "
       "rollout; cut off by an obstacle that the arm avoids",
       {}},
      {"held_back_by",
       "",
       "limit whose relaxation would improve the plan most, or that makes the plan infeasible; empty if "
       "there is none",
       {}},
      {"clearance",
       "m",
       "distance that the plan keeps from every obstacle: the gains' influence radius or, if smaller, the "
       "rollout's own least distance during the event; empty without obstacles or if they are ignored",
       {}},
      {"status",
       "",
       "status of the plan that the event is compared with: solved; solved without obstacles (no plan was "
       "found that "
       "stays clear of them); past the next switch (no motion was found that reaches the target before "
       "that switch); there at once (at the start, gaze on target or tool on the path); infeasible; not solved",
       {}}};
}

}  // namespace armtune::internal
