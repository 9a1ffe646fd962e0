#include "tuner/planning/output/contact_note.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

namespace armtune::internal {

std::string contact_note(const PlanTask& task) {
  std::vector<std::string> kept;
  const auto& clearance = task.scenario.clearance;
  if (task.clearance > 0.0 && !task.scenario.obstacles.empty())
    kept.emplace_back("the obstacles (measured at the tool and the joint origins)");
  if (task.clearance > 0.0 && clearance) {
    if (clearance->has(Clearance::kCell)) kept.emplace_back("the parts of the cell");
    if (clearance->has(Clearance::kFloor)) kept.emplace_back("the floor");
  }
  const bool self = task.clearance > 0.0 && clearance && clearance->has(Clearance::kSelf);
  if (kept.empty() && !self) return "The plan ignores the arm's surroundings and contact between its links.";
  std::string text;
  if (!kept.empty())
    text = fmt::format("At its knots (points in time), the motion keeps at least {:g} m from {} of {}. ",
                       task.clearance, fmt::join(kept, ", "), task.scenario.name);
  text += self ? "At the knots of the motion, links do not touch each other."
               : "The plan ignores contact between links.";
  const auto drawn = clearance ? drawn_links(clearance->arm()) : std::vector<std::string>{};
  if (!drawn.empty())
    text += fmt::format(
        " The distances are measured from the drawn shapes of {}, which have no collision shapes.",
        fmt::join(drawn, ", "));
  if (clearance && !clearance->arm().unknown.empty())
    text += fmt::format(" Not checked, because their shapes are not known: {}.",
                        fmt::join(clearance->arm().unknown, ", "));
  return text;
}

}  // namespace armtune::internal
