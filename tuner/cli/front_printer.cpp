#include "tuner/cli/front_printer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/trade_off/pareto_file.hpp"

namespace armtune::internal::cli {

void FrontPrinter::began(const Study& study, const ParetoOptions& options, std::size_t recalled) {
  say(fmt::format("Pareto front of study {}: {}. {} gains, {} scenarios; budget: {}. Results go to {}\n",
                  study.name, fmt::join(settings_.criteria, " against "), study.space.free.size(),
                  study.scenarios.size(), budget_text(options.max_evaluations, study.max_minutes),
                  settings_.place.folder));
  if (settings_.place.resume) say(fmt::format("resuming after {} finished evaluations\n", recalled));
  std::fflush(stdout);
}

void print_front(const FrontOutcome& outcome, const Study& study, const std::string& folder) {
  if (outcome.was_finished) {
    say(fmt::format("{}: this run is finished; there is nothing to resume\n", folder));
    return;
  }
  if (outcome.result.evaluations == 0) {
    fmt::print(stderr, "interrupted before the start gains were simulated; nothing to report\n");
    return;
  }
  say(pareto_table(study, outcome.options, outcome.result));
  if (outcome.result.out_of_time) {
    say(
        fmt::format("the time limit max_minutes was reached after {} evaluations; parts of the front may be "
                    "missing or not fully searched\n",
                    outcome.result.evaluations));
  }
  say(fmt::format("{}\nwrote {} in {:.0f} s: {}{}\n",
                  !outcome.verified ? "interrupted: the points of the front were not simulated again"
                  : study.engine == Engine::kSimbody
                      ? "every point was simulated again and gave the same values"
                      : "every point was simulated again in simbody; the table has these values",
                  folder, outcome.seconds, fmt::join(outcome.files, ", "),
                  outcome.verified ? "; recordings for the report are in start/ and shown/" : ""));
  if (!outcome.verified) say(fmt::format("to resume: {} pareto --resume {}\n", program_name(), folder));
}

}  // namespace armtune::internal::cli
