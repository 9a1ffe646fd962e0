#pragma once
// Prints the progress and the results of `armtune robustness`, which simulates gains on many randomly changed
// models of the arm.

#include "tuner/cli/session_printer.hpp"
#include "tuner/session/monte_carlo_session.hpp"

namespace armtune::internal::cli {

class MonteCarloPrinter : public SessionPrinter<MonteCarloObserver> {
 public:
  /// The settings must outlive the printer.
  explicit MonteCarloPrinter(const MonteCarloSettings& settings) : settings_(settings) {}

  void resumed(std::size_t recalled) override;
  /// Prints the result of the session. Returns the exit code.
  int ended(const MonteCarloOutcome& outcome) const;

 private:
  const MonteCarloSettings& settings_;
};

}  // namespace armtune::internal::cli
