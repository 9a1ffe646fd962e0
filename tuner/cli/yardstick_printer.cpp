#include "tuner/cli/yardstick_printer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

#include "tuner/cli/say.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/report/yardstick_rows.hpp"

namespace armtune::internal::cli {

void YardstickPrinter::progressed(const Progress& progress) {
  const double left = progress.seconds_left;
  SessionPrinter::progressed(
      {fmt::format("{}: {} of {} events{}; {}", progress.work, progress.done, progress.all,
                   std::isnan(left) ? "" : fmt::format(", {:.0f} s left", left), progress.detail)});
}

void YardstickPrinter::noted(const std::string& scenario, const std::string& note) {
  say(fmt::format("{}: {}\n", scenario, note));
}

void YardstickPrinter::measured(const Measure& measure, std::size_t scenario) {
  if (shown_ != scenario) say(fmt::format("{}:\n", measure.scenario));
  shown_ = scenario;
  const auto rows = report::yardstick_of({CsvTable::parse(yardstick_csv({measure}), "yardstick.csv")});
  say(fmt::format("  {} at {:.4g} s: {}\n", rows.front().event, rows.front().time, rows.front().words));
  std::fflush(stdout);
}

}  // namespace armtune::internal::cli
