#pragma once
// What `armtune robustness` prints of its session, while it works and at its end.

#include "tuner/cli/session_printer.hpp"
#include "tuner/session/monte_carlo_session.hpp"

namespace armtune::internal::cli {

class MonteCarloPrinter : public SessionPrinter<MonteCarloObserver> {
 public:
  /// The settings outlive it.
  explicit MonteCarloPrinter(const MonteCarloSettings& settings) : settings_(settings) {}

  void resumed(std::size_t recalled) override;
  /// Prints how it all ended. Returns the exit code.
  int ended(const MonteCarloOutcome& outcome) const;

 private:
  const MonteCarloSettings& settings_;
};

}  // namespace armtune::internal::cli
