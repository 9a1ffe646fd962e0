#pragma once
// One line of progress that is rewritten in place on a terminal. Nothing is printed if stderr is not a
// terminal.

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
