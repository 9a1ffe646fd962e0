#pragma once
// The output of `armtune excite` about its session, during the work and at its end.

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
