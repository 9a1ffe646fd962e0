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
       "switch: time until the gaze is on the next target for good; return: time until the path is followed "
       "again; lap: rms of the gaze angle over one turn of the path",
       {}},
      {"time", "s", "when it begins", {}},
      {"state", "", "of the controller, then", {}},
      {"reached", "s, rad", "what the controller reached, counted in rows of the recording", {}},
      {"limit", "s, rad", "the least found within the arm's limits from the same state on", {}},
      {"ratio", "1", "reached / limit; empty where either is missing or the limit is 0", {}},
      {"unit", "", "of reached and limit", {}},
      {"outcome",
       "",
       "reached; already there; not before the next switch; cut off by the end of the rollout or by an "
       "obstacle that is avoided",
       {}},
      {"held_back_by",
       "",
       "the limit that costs the plan most, or, if it is infeasible, is in its way; empty: none",
       {}},
      {"clearance",
       "m",
       "that the plan keeps from every obstacle: the gains' influence radius, or the rollout's own least "
       "distance meanwhile; "
       "empty without obstacles or where they are left out",
       {}},
      {"status",
       "",
       "of the limit: solved; solved without obstacles (no plan was found that keeps clear of them); past "
       "the "
       "next switch (nobody gets there before it); there at once (gaze on target, or tool on the path, to "
       "begin with); "
       "infeasible; not solved",
       {}}};
}

}  // namespace armtune::internal
