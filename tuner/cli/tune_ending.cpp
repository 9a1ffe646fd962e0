// Prints how `armtune tune` ended: what to do next, the files, and the verdict.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/common/input_file.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/document.hpp"
#include "tuner/cli/conclusion.hpp"
#include "tuner/cli/interrupt.hpp"
#include "tuner/cli/say.hpp"
#include "tuner/cli/tune_printer.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal::cli {
namespace {

/// Prints what to do next, if the search found nothing better than the start gains or nothing feasible.
/// constraints: the check of the constraints, whose text says which are violated.
void print_recommendation(const TuneResult& result, const Check& constraints, const std::string& folder) {
  const SearchOutcome outcome = outcome_of(result);
  if (outcome == SearchOutcome::kTuned) return;
  if (outcome == SearchOutcome::kStart) {
    say(fmt::format(
        "The search found nothing better than the start gains, so {0}/gains.yaml holds the start gains.\n"
        "{1}Allow more evaluations, or change the bounds of the parameters.\n",
        folder,
        constraints.passed
            ? ""
            : fmt::format("They break a constraint: do not load them on the robot. Failed check: {}.\n"
                          "Recommended start of a further search: the start gains. ",
                          to_text(constraints))));
    return;
  }
  say(fmt::format("Nothing feasible was found. Failed check: {}.\n", to_text(constraints)));
  if (result.best.objective <= 1.0) {
    say(fmt::format(
        "{0}/gains.yaml holds the gains with the least violation. They break a constraint: do not load them "
        "on the robot. Recommended start of a further search: these gains (--warm-start {0}).\n",
        folder));
  } else {
    say(fmt::format(
        "{0}/gains.yaml holds the gains with the least violation. Their objective is {1:.3g} times the "
        "objective of the start gains. The start gains ({0}/start/gains.yaml) break a constraint too: load "
        "neither on the robot. Recommended start of a further search, with more evaluations: the start "
        "gains.\n",
        folder, result.best.objective));
  }
}

/// Returns the parameter file of the robot's controller that has the start gains. Returns an empty text if
/// there is none, or if another kind of controller is tuned.
std::string parameter_file_of(const Study& study) {
  if (study.gains.empty()) return {};
  const std::vector<std::string> joints = joint_names(*study.scenarios.front().robot);
  const auto file = read_parameter_file(study.gains, study.node, study.distro, joints);
  if (!file) return {};
  const Gains in_file = controller_gains(file->controller, file->path, joints);
  return in_file.controller == study.space.start.controller ? file->path : std::string();
}

}  // namespace

void TunePrinter::ended(const TuneOutcome& outcome) const {
  const std::string& folder = settings_.place.folder;
  if (outcome.was_finished) {
    say(fmt::format(
        "{}: this run is finished; there is nothing to resume. To search further from its best gains: {} "
        "tune {} --warm-start {}\n",
        folder, program_name(), study_name_, folder));
    return;
  }
  if (outcome.result.evaluations == 0) {
    fmt::print(stderr, "interrupted before the start gains were simulated; nothing to report\n");
    return;
  }
  if (!outcome.sets.empty()) {
    print_recommendation(outcome.result, outcome.verdict.checks.front(), folder);
    const bool seen = std::find(outcome.files.begin(), outcome.files.end(), kReport) != outcome.files.end();
    say(fmt::format(
        "wrote {} in {:.0f} s: {}; files of the start gains are in start/\nnext: {}{} compare {}/start {}\n",
        folder, outcome.seconds, fmt::join(outcome.files, ", "),
        seen ? fmt::format("open {}/report.html in a browser; or ", folder) : "", program_name(), folder,
        folder));
  }
  if (!outcome.controllers.empty()) {
    say(fmt::format(
        "{0}/{1} is a copy of {2} in which only the gains are changed. Read docs/ros.md before the robot "
        "moves with the tuned gains.\n",
        folder, outcome.controllers, shown_path(parameter_file_of(study_))));
  } else if (const std::string file = parameter_file_of(study_);
             outcome.ending != Ending::kInterrupted && !file.empty()) {
    say(fmt::format(
        "A copy of {} with the tuned gains was not written. Either a check failed or was skipped, or the "
        "file cannot hold the gains. If it can hold them, 'armtune export {} --into {} --out NEW' writes "
        "the copy.\n",
        shown_path(file), folder, shown_path(study_.gains)));
  }
  if (outcome.ending == Ending::kInterrupted) {
    say(fmt::format("interrupted: {}; to resume: {} tune --resume {}\n",
                    outcome.result.interrupted ? "the search was not finished"
                                               : "the search was finished, but the analysis after it was not",
                    program_name(), folder));
    return;
  }
  conclude(outcome.verdict);
}

}  // namespace armtune::internal::cli
