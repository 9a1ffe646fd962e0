#pragma once
// Prints the progress and the warnings of a session on stderr. A session does the work of one command, such
// as tuning or comparing gains. It prints nothing itself, but reports to an observer.

#include <string>

#include "tuner/cli/progress_line.hpp"
#include "tuner/session/observer.hpp"

namespace armtune::internal::cli {

/// Returns, for example, "margins of the start gains: 3 of 8, 12 s left".
std::string to_text(const Progress& progress);
void print_warning(const std::string& sentence);
/// Prints on stderr that a run that failed can be resumed, and how.
void print_can_resume(const std::string& folder);

/// An observer that prints the reports of one kind of session. Observer: SessionObserver or a class derived
/// from it, whose other functions can be overridden.
template <class Observer = SessionObserver>
class SessionPrinter : public Observer {
 public:
  void progressed(const Progress& progress) override { line_.show(to_text(progress)); }
  void part_is_over() override { line_.clear(); }
  void warned(const std::string& sentence) override { print_warning(sentence); }
  void can_resume(const std::string& folder) override {
    line_.clear();
    print_can_resume(folder);
  }

 private:
  ProgressLine line_;
};

}  // namespace armtune::internal::cli
