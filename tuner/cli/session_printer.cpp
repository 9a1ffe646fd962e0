#include "tuner/cli/session_printer.hpp"

#include <fmt/format.h>

#include "core/common/message_text.hpp"
#include "tuner/cli/interrupt.hpp"

namespace armtune::internal::cli {

std::string to_text(const Progress& progress) {
  std::string text = progress.work;
  if (progress.all > 0) text += fmt::format(": {} of {}", progress.done, progress.all);
  if (!progress.detail.empty()) text += ", " + progress.detail;
  if (!std::isnan(progress.seconds_left)) text += fmt::format(", {:.0f} s left", progress.seconds_left);
  return text;
}

void print_warning(const std::string& sentence) {
  fmt::print(stderr, "armtune: warning: {}\n", one_line(sentence));
}

void print_can_resume(const std::string& folder) {
  fmt::print(stderr,
             "the finished part of the run is in {}; remove the cause of the error, then resume: {} {} "
             "--resume {}\n",
             folder, program_name(), command_words()[1], folder);
}

}  // namespace armtune::internal::cli
