#include "tuner/cli/yardstick_option.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/yardstick_printer.hpp"
#include "tuner/planning/session/add_yardstick.hpp"

namespace armtune::internal::cli {
namespace {

YardstickFiles compare(const std::string& folder, const std::vector<Scenario>& scenarios,
                       const GainsOf& gains) {
  say(fmt::format("comparison of {} with optimal motions within the arm's limits:\n", folder));
  YardstickPrinter printer;
  return add_yardstick(folder, scenarios, gains, stop_requested(), printer);
}

}  // namespace

void add_yardstick_option(CLI::App& command, bool& wanted) {
  command.add_flag(
      "--yardstick", wanted,
      "also compare every target switch, every return to the path and every lap with an optimal motion "
      "within the arm's limits; writes yardstick.csv, and the column 'reacquisition/limit' in errors.csv "
      "(see armtune yardstick)");
}

Yardstick yardstick_if(bool wanted) {
  return wanted ? Yardstick(compare) : Yardstick();
}

}  // namespace armtune::internal::cli
