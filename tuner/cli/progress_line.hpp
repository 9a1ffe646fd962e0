#pragma once
// Shows the progress of a long computation on one line of the terminal, which is rewritten in place. Prints
// nothing if stderr is not a terminal.

#include <string>

namespace armtune::internal::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text);
  /// Removes the line. Call it before other text is printed.
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
};

}  // namespace armtune::internal::cli
