#pragma once
// Prints the output of `armtune tune`: its progress while it searches for better gains, and its results.

#include "tuner/cli/session_printer.hpp"
#include "tuner/session/tune_session.hpp"

namespace armtune::internal::cli {

class TunePrinter : public SessionPrinter<TuneObserver> {
 public:
  /// Study and settings must outlive the printer. study_name: name of the study on the command line.
  TunePrinter(const Study& study, const TuneSettings& settings, std::string study_name)
      : study_(study), settings_(settings), study_name_(std::move(study_name)) {}

  void began(const Study& study, std::size_t recalled) override;
  void verified(const TuneOutcome& so_far) override;
  void found_margins(const std::vector<ComparedMargins>& sets) override;
  void found_sensitivity(const Sensitivity& sensitivity) override;
  void searched(const TuneOutcome& so_far) override;
  void extended(const std::vector<EnduranceResult>& results) override;
  /// Prints the result of the session.
  void ended(const TuneOutcome& outcome) const;

 private:
  const Study& study_;
  const TuneSettings& settings_;
  std::string study_name_;
};

}  // namespace armtune::internal::cli
