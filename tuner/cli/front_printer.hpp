#pragma once
// Prints the progress and the results of `armtune pareto`. This command searches for the Pareto front of a
// study: the best compromises between several criteria, such as accuracy and joint velocity.

#include "tuner/cli/session_printer.hpp"
#include "tuner/session/front_session.hpp"

namespace armtune::internal::cli {

class FrontPrinter : public SessionPrinter<FrontObserver> {
 public:
  /// The settings must outlive the printer.
  explicit FrontPrinter(const FrontSettings& settings) : settings_(settings) {}

  void began(const Study& study, const ParetoOptions& options, std::size_t recalled) override;

 private:
  const FrontSettings& settings_;
};

/// Prints the Pareto front, or why none was found.
void print_front(const FrontOutcome& outcome, const Study& study, const std::string& folder);

}  // namespace armtune::internal::cli
