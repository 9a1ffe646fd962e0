#pragma once
// Prints the progress and the results of a comparison of rollouts with the best motions that the arm's limits
// allow, for `armtune yardstick` and the option --yardstick.

#include <optional>

#include "tuner/cli/session_printer.hpp"
#include "tuner/planning/session/rollout_measures.hpp"

namespace armtune::internal::cli {

class YardstickPrinter : public SessionPrinter<YardstickObserver> {
 public:
  void progressed(const Progress& progress) override;
  void noted(const std::string& scenario, const std::string& note) override;
  /// Prints the result in the words of the report, below the name of its scenario.
  void measured(const Measure& measure, std::size_t scenario) override;

 private:
  std::optional<std::size_t> shown_;  ///< scenario of the result printed last
};

}  // namespace armtune::internal::cli
