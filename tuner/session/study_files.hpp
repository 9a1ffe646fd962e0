#pragma once
// Writes the files that both `armtune tune` and `armtune pareto` write into their run folders. Also returns
// texts that describe the search, for these files and for the terminal.

#include <string>
#include <utility>
#include <vector>

#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/sensitivity/sensitivity.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

/// File in a run folder with the gains of the warm start (warm_start.hpp).
inline constexpr const char* kWarmGains = "start/warm_gains.yaml";
/// File in a run folder with the study's own start gains, if armtune replaced them (Study::given).
inline constexpr const char* kGivenGains = "given/gains.yaml";

/// Returns, for example, "CRS2, then BOBYQA from 4 starts".
std::string search_text(const Study& study);
/// Returns "simbody" or, if the search used another engine, for example "native, then simbody".
std::string engine_text(Engine searched_in);
/// Returns, for example, " (worst of 5 arms in each scenario)" if the study tunes on several arms, else an
/// empty text.
std::string robust_text(const Study& study);
/// Returns, for example, "300 evaluations" or, with a time limit, "300 evaluations or 10 minutes".
std::string budget_text(long max_evaluations, double max_minutes);
/// Returns the estimated time until a search ends [s]. The remaining evaluations are assumed to take as long
/// as those so far on average. seconds: time used so far [s]; max_minutes: time limit of the search, which
/// may end it earlier [min], or 0.
double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes);

/// Returns every file from which the study was read: its own file, its gains, the warm start's gains, and the
/// files of its scenarios.
std::vector<std::string> files_of(const Study& study);
/// Returns everything on which a study's results depend, except the contents of the files of inputs_of().
std::vector<std::pair<std::string, std::string>> identity_of(const Study& study);
/// Returns the files of the study's scenarios and, if it has one, that of the distribution of its arms.
std::vector<std::string> inputs_of(const Study& study);

/// Returns the record of a search, with everything that its study determines. The caller sets the kind of the
/// run, and what the search found. workers: number of workers of the search; seconds: wall time [s].
RunRecord record_of_search(const Study& study, const Invocation& invocation, int workers, double seconds);

/// Writes what the search starts from: the start gains into start/, and study.yaml. If armtune replaced the
/// study's own start gains, also writes them into given/. Call it before the search simulates anything but
/// the start gains.
void write_start(const Study& study, const std::string& folder);
/// Writes the warm start's gains into a run folder. Returns the file's name for study.yaml of that folder, or
/// an empty text if there is no warm start.
std::string write_warm(const Study& study, const std::string& folder);
/// Warns about every gain whose value in the warm start lies outside the study's bounds. The search starts
/// with this gain at the nearer bound.
void warn_of_clamped(const Study& study, SessionObserver& observer);

/// Warns if armtune replaced the study's own start gains.
void warn_of_given(const Study& study, SessionObserver& observer);
/// Returns the text of that warning as a sentence; empty if the start gains were not replaced.
std::string given_note(const Study& study);

/// Writes sensitivity.csv and reduced_study.yaml into the folder. reduced_study.yaml is the study with the
/// less important half of the gains fixed. It refers to the start gains in start/gains.yaml of the same
/// folder.
void write_sensitivity(const Study& study, const Sensitivity& sensitivity, const std::string& folder);

}  // namespace armtune::internal
