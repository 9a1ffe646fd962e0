#include "tuner/cli/tune_analysis.hpp"

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/progress_line.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/sensitivity_report.hpp"
#include "tuner/evaluation/evaluations_reader.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/search/last_steps.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::cli {

bool analyse(const Study& study, const TuneResult& result, const Objective& objective,
             CandidateRunner& workers, const AnalysisOptions& how) {
  ProgressLine line;
  std::vector<ComparedMargins> sets(2);
  MarginOptions options;
  options.stepper = study.stepper;
  options.engine = engine_of_search(study);
  options.workers = how.workers;
  for (ComparedMargins& set : sets) {
    const bool start = &set == &sets.front();
    set.name = start ? "start" : name(outcome_of(result));
    options.progress = [&](std::size_t done, std::size_t all) {
      line.show(fmt::format("margins of the {} gains: {} of {}", set.name, done, all));
    };
    set.margins =
        margins(study.scenarios, start ? study.space.start : result.best.gains, options, stop_requested());
    if (stop_requested()) return false;
    write_text_file(how.folder + (start ? "/start/margins.csv" : "/margins.csv"),
                    margins_csv(study.scenarios, set.margins));
  }
  line.clear();
  say(fmt::format("{}\n", margins_table(study.scenarios, sets)));

  const auto found = sensitivity(study, objective, result.best.gains,
                                 read_evaluations(CsvTable::read(how.folder + "/evaluations.csv"), study),
                                 workers, stop_requested(), [&line](std::size_t done, std::size_t all) {
                                   line.show(fmt::format("sensitivity: {} of {} evaluations", done, all));
                                 });
  line.clear();
  if (!found) return false;
  write_sensitivity(study, *found, how.folder);
  print_sensitivity(study, *found, kMostShown);
  print_advice(study, *found);
  return true;
}

}  // namespace armtune::cli
