#pragma once
// Prints the progress and the results of `armtune excite`. This command designs a trajectory from which an
// arm's dynamics can be identified. It also simulates this trajectory, and writes logs like those of a real
// arm.

#include "tuner/cli/session_printer.hpp"
#include "tuner/identification/session/excite_session.hpp"

namespace armtune::internal::cli {

class ExcitePrinter : public SessionPrinter<ExciteObserver> {
 public:
  void designed(const ExciteOutcome& so_far) override;
  void logged(const Scenario& scenario, const ExcitationLog& log) override;
  void ended(const ExciteSettings& settings, const ExciteOutcome& outcome);
};

}  // namespace armtune::internal::cli
