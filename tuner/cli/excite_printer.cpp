#include "tuner/cli/excite_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void ExcitePrinter::designed(const ExciteOutcome& so_far) {
  if (so_far.design) {
    say(fmt::format("{} evaluations; before them, the best of 50 random series had condition number {:.4g}\n",
                    so_far.design->evaluations, so_far.design->random_condition));
  }
  const ExcitationUse& use = so_far.use;
  say(fmt::format(
      "condition number {:.4g}; largest velocity {:.3g} and largest effort {:.3g} as shares of their limits; "
      "{:.3g} rad or m from the nearest position limit; lowest point at {:.3g} m\n",
      use.condition, use.velocity_ratio, use.effort_ratio, use.position_margin, use.lowest));
}

void ExcitePrinter::logged(const Scenario& scenario, const ExcitationLog& log) {
  say(fmt::format(
      "{}: {} samples, the arm stays within {:.3g} rad or m of the trajectory, largest velocity {:.3g} of "
      "its limit{}\n",
      scenario.name, log.samples.size(), log.tracking_error, log.velocity_ratio,
      log.saturated ? ", torques saturate" : ""));
}

void ExcitePrinter::ended(const ExciteSettings& settings, const ExciteOutcome& outcome) {
  say(fmt::format("wrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
}

}  // namespace armtune::internal::cli
