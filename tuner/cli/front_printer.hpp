#pragma once
// What `armtune pareto` prints of its session, while it works and at its end.

#include "tuner/cli/session_printer.hpp"
#include "tuner/session/front_session.hpp"

namespace armtune::internal::cli {

class FrontPrinter : public SessionPrinter<FrontObserver> {
 public:
  /// The settings outlive it.
  explicit FrontPrinter(const FrontSettings& settings) : settings_(settings) {}

  void began(const Study& study, const ParetoOptions& options, std::size_t recalled) override;

 private:
  const FrontSettings& settings_;
};

/// Prints how it all ended.
void print_front(const FrontOutcome& outcome, const Study& study, const std::string& folder);

}  // namespace armtune::internal::cli
