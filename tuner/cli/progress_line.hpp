#pragma once
// One line that is written over and over on a terminal; silent when stderr is none.

#include <string>

namespace armtune::internal::cli {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text);
  /// Takes the line away, before something else is printed.
  void clear();

 private:
  bool terminal_;
  bool shown_ = false;
};

}  // namespace armtune::internal::cli
