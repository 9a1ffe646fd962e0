#pragma once
// Writes the files that `armtune tune` and `armtune pareto` both leave in their run folder. Also describes
// the search in words, for these files and for the terminal.

#include <string>
#include <utility>
#include <vector>

#include "tuner/run/run_folder.hpp"
#include "tuner/sensitivity/sensitivity.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

/// Name of the file in a run folder that keeps the gains that a warm start began with.
inline constexpr const char* kWarmGains = "start/warm_gains.yaml";
/// Name of the file that keeps the start gains of the study's file, if other gains replaced them.
inline constexpr const char* kGivenGains = "given/gains.yaml";

/// Returns, for example, "CRS2, then BOBYQA from 4 starts".
std::string search_text(const Study& study);
/// Returns "simbody", or, for example, "native, then simbody".
std::string engine_text(Engine searched_in);
/// Returns, for example, " (worst of 5 arms in each scenario)" if the study tunes on samples, else an empty
/// text.
std::string robust_text(const Study& study);
/// Returns "300 evaluations" or, with a limit of time, "300 evaluations or 10 minutes".
std::string budget_text(long max_evaluations, double max_minutes);
/// Returns the time that is left of a budget [s]: the time that the remaining evaluations take at the pace so
/// far, or less if max_minutes ends sooner (0: no limit of time).
double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes);

/// Returns every file that the study was read from: its own file, its gains, the warm start's gains, and the
/// files of its scenarios.
std::vector<std::string> files_of(const Study& study);
/// Returns everything that a study's results depend on, except the files its scenarios are made from.
/// inputs_of returns those files.
std::vector<std::pair<std::string, std::string>> identity_of(const Study& study);
std::vector<std::string> inputs_of(const Study& study);

/// Returns the provenance of a search of the study. workers: number of the search's workers; found: further
/// keys of run.yaml, which follow the study and its start.
Provenance study_provenance(const Study& study, const Invocation& invocation, int workers, double seconds,
                            const std::vector<std::pair<std::string, std::string>>& found);

/// Writes the start of the search before anything else is simulated: start/ and study.yaml, and given/ with
/// the file's start gains if other gains replaced them.
void write_start(const Study& study, const std::string& folder);
/// Writes the warm start's gains into a run folder. Returns the file as study.yaml in that folder names it,
/// or an empty text without a warm start.
std::string write_warm(const Study& study, const std::string& folder);
/// Warns of every gain whose value in the warm start lies outside the study's bounds. The search begins on
/// the bound instead.
void warn_of_clamped(const Study& study, SessionObserver& observer);

/// Warns if the study begins with other gains than its file gives.
void warn_of_given(const Study& study, SessionObserver& observer);
/// Returns the text of that warning as a sentence; empty if the study begins with the gains of its file.
std::string given_note(const Study& study);

/// Writes sensitivity.csv and reduced_study.yaml into the folder. reduced_study.yaml refers to the start
/// gains in start/gains.yaml of the same folder.
void write_sensitivity(const Study& study, const Sensitivity& sensitivity, const std::string& folder);

}  // namespace armtune::internal
