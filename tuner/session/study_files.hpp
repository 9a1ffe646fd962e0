#pragma once
// What every run of a study (tune, front) leaves in its folder, and how its files name what it did.

#include <string>
#include <utility>
#include <vector>

#include "tuner/run/run_folder.hpp"
#include "tuner/sensitivity/sensitivity.hpp"
#include "tuner/session/observer.hpp"
#include "tuner/session/session_context.hpp"

namespace armtune::internal {

/// Where a run folder keeps the gains a warm start began with.
inline constexpr const char* kWarmGains = "start/warm_gains.yaml";
/// And the start gains of the study's file, where others took their place.
inline constexpr const char* kGivenGains = "given/gains.yaml";

/// "CRS2, then BOBYQA from 4 starts"
std::string search_text(const Study& study);
/// "simbody", or "native, then simbody"
std::string engine_text(Engine searched_in);
/// " (worst of 5 arms each)" where a study tunes on samples.
std::string robust_text(const Study& study);
/// "300 evaluations", or "300 evaluations or 10 minutes".
std::string budget_text(long max_evaluations, double max_minutes);
/// What is left [s] of a budget, by evaluations at the pace so far or by its minutes (0: none).
double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes);

/// Returns every file that the study was read from: its own, its gains and those of its scenarios.
std::vector<std::string> files_of(const Study& study);
/// All that a study's results depend on but the files its scenarios are made from, and those files.
std::vector<std::pair<std::string, std::string>> identity_of(const Study& study);
std::vector<std::string> inputs_of(const Study& study);

/// Of a search of the study. workers: of the search; found: further keys of run.yaml, after the study and its
/// start.
Provenance study_provenance(const Study& study, const Invocation& invocation, int workers, double seconds,
                            const std::vector<std::pair<std::string, std::string>>& found);

/// Writes what the start was, before anything else is simulated: start/ and study.yaml, and given/ with the
/// file's start gains where others took their place.
void write_start(const Study& study, const std::string& folder);
/// Keeps the warm start's gains in a run folder. Returns the file, as study.yaml there names it; empty
/// without a warm start.
std::string write_warm(const Study& study, const std::string& folder);
/// Warns of every gain that the study's bounds do not let begin where its warm start was.
void warn_of_clamped(const Study& study, SessionObserver& observer);

/// Warns where the study begins with other gains than its file gives.
void warn_of_given(const Study& study, SessionObserver& observer);
/// What that warning says, as a sentence; empty: the study begins as its file says.
std::string given_note(const Study& study);

/// Writes sensitivity.csv and reduced_study.yaml into the folder; the study's start gains are in
/// start/gains.yaml there.
void write_sensitivity(const Study& study, const Sensitivity& sensitivity, const std::string& folder);

}  // namespace armtune::internal
