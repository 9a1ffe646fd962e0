#include "tuner/cli/excite_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tuner/cli/say.hpp"

namespace armtune::internal::cli {

void ExcitePrinter::designed(const ExciteOutcome& so_far) {
  if (so_far.design) {
    say(
        fmt::format("{} trajectories evaluated; the best of 50 random start trajectories had condition "
                    "number {:.4g}\n",
                    so_far.design->evaluations, so_far.design->random_condition));
    if (so_far.design->scale < 1.0)
      say(fmt::format(
          "The best trajectory brought the arm too near to a contact, so its amplitudes were multiplied by "
          "{:.3g}.\n",
          so_far.design->scale));
  }
  const ExcitationUse& use = so_far.use;
  say(fmt::format(
      "condition number {:.4g}; largest velocity {:.3g} of its limit; largest effort {:.3g} of its limit; "
      "smallest distance to a position limit {:.3g} rad or m; lowest point at z = {:.3g} m\n",
      use.condition, use.velocity_ratio, use.effort_ratio, use.position_margin, use.lowest));
  say(so_far.contact + "\n");
}

void ExcitePrinter::logged(const Scenario& scenario, const ExcitationLog& log) {
  say(fmt::format(
      "{}: {} samples; every joint stays within {:.3g} rad or m of the trajectory; largest velocity {:.3g} "
      "of its limit{}\n",
      scenario.name, log.samples.size(), log.tracking_error, log.velocity_ratio,
      log.saturated ? "; some torques saturate" : ""));
}

void ExcitePrinter::ended(const ExciteSettings& settings, const ExciteOutcome& outcome) {
  say(fmt::format("wrote {}: {}\n", settings.folder, fmt::join(outcome.files, ", ")));
}

}  // namespace armtune::internal::cli
