// The command `armtune sensitivity`, which shows which of a run's gains matter.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "armtune/error.hpp"
#include "tuner/cli/commands.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/on_ranks.hpp"
#include "tuner/cli/resume.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/sensitivity_report.hpp"
#include "tuner/cli/session_printer.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/session/changed_inputs.hpp"
#include "tuner/session/sensitivity_session.hpp"
#include "tuner/session/study_files.hpp"

namespace armtune::internal::cli {
namespace {

int run_sensitivity(SensitivitySettings settings, RankGroup& team) {
  settings.study = load_study(run_file(settings.run, "study.yaml"));
  const std::string changed = changed_input(inputs_of_run(settings.run), inputs_of(settings.study));
  if (!changed.empty())
    throw InputError(InputPlace{changed},
                     fmt::format("this file has changed since the run {}; tune again", settings.run));
  SessionPrinter printer;
  const auto outcome = SensitivitySession(settings, session_context(), printer).run(team);
  if (!outcome) return kDone;
  if (outcome->ending == Ending::kInterrupted) {
    fmt::print(stderr, "interrupted; nothing was written\n");
    return kInterrupted;
  }
  print_sensitivity(settings.study, outcome->sensitivity, settings.study.space.free.size());
  print_advice(settings.study, outcome->sensitivity);
  if (!outcome->files.empty())
    say(fmt::format("wrote {0}: {1}\nnext: {2} tune {0}/reduced_study.yaml\n", settings.folder,
                    fmt::join(outcome->files, ", "), program_name()));
  return kDone;
}

}  // namespace

void add_sensitivity_command(CLI::App& app, int& exit_code) {
  auto settings = std::make_shared<SensitivitySettings>();
  settings->workers = default_workers();
  CLI::App* command = app.add_subcommand("sensitivity", "Show which gains of a run matter, and which do not");
  command->add_option("RUN", settings->run, "the folder of a tuning run")->required();
  command->add_option(
      "--out", settings->folder,
      "new folder for sensitivity.csv and reduced_study.yaml (default: no files). In the reduced study, the "
      "less important half of the gains is fixed at the start values");
  command->add_option("--workers", settings->workers, kWorkersHelp)
      ->check(CLI::Range(1, 1024))
      ->default_str(kWorkersDefault);
  command->add_option("--rollout-deadline", settings->deadline, kDeadlineHelp)
      ->check(CLI::PositiveNumber)
      ->default_str(kDeadlineDefault);
  command->footer(
      "importance  increase of the merit of the best gains if only this gain returns to its start value\n"
      "local       largest relative change of the merit for a step of 2 % of the gain's range, up or down\n"
      "Further columns of sensitivity.csv:\n"
      "elasticity        relative change of the merit per relative change of the gain (central differences)\n"
      "rank_correlation  rank correlation between gain and merit over the run's evaluations\n\n"
      "The merit is objective + penalty * (sum of the relative constraint violations), with the penalty of\n"
      "the study's search. A smaller merit is better.\n\n"
      "Example:\n  armtune tune ur10_gaze --out runs/gaze\n  armtune sensitivity runs/gaze\n");
  command->callback([settings, &exit_code] { exit_code = run_sensitivity(*settings, team()); });
}

}  // namespace armtune::internal::cli
