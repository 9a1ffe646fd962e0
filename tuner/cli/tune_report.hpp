#pragma once
// What `armtune tune` writes and prints of a study and its result.

#include <string>
#include <utility>
#include <vector>

#include "tuner/cli/yardstick_option.hpp"
#include "tuner/rollouts/comparison.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/search/tune.hpp"
#include "tuner/workers/rank_group.hpp"

namespace armtune::cli {

struct ReportOptions {
  std::string folder;
  int workers = 1;       ///< threads of the fresh rollouts
  int record_every = 5;  ///< control periods per row of the recordings
};

/// "CRS2, then BOBYQA from 4 starts"
std::string search_text(const Study& study);
/// "simbody", or "native, then simbody"
std::string engine_text(const Study& study);

/// "300 evaluations", or "300 evaluations or 10 minutes".
std::string budget_text(long max_evaluations, double max_minutes);

/// What is left [s] of a budget, by evaluations at the pace so far or by its minutes (0: none).
double seconds_left(long evaluations, long max_evaluations, double seconds, double max_minutes);
/// " (worst of 5 arms each)" where a study tunes on samples.
std::string robust_text(const Study& study);

/// Returns every file that the study was read from: its own, its gains and those of its scenarios.
std::vector<std::string> files_of(const Study& study);

/// Of a search of the study, by whichever command. workers: of the search; found: further keys of run.yaml,
/// after the study and its start.
Provenance study_provenance(const Study& study, int workers, double seconds,
                            const std::vector<std::pair<std::string, std::string>>& found);

/// Fresh rollouts of both gain sets, start and tuned: the figures that are reported, and the recordings.
std::vector<ComparedSet> verify(const Study& study, const TuneResult& result, const ReportOptions& options);
/// Of a study on many arms: the measure of fresh rollouts of all of them, as robust_errors.csv and for the
/// table. Throws std::runtime_error if it is not what the search saw in Simbody.
std::vector<ComparedSet> verify_robust(const Study& study, const TuneResult& result,
                                       const ReportOptions& options, RankGroup& team);

/// Takes Simbody's fresh rollouts of the best gains for what they are, where an interrupted search ended with
/// another engine's. simulated: those the objective is of.
void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result);

/// What the start was, before anything else is simulated: an interrupted run can be judged by it too.
void write_start(const Study& study, const std::string& folder);
void write_gains(const Study& study, const TuneResult& result, const std::string& folder);
/// Both sets' rollouts in `folder` against the best that the arm's limits allow: start, then tuned.
std::vector<YardstickFiles> measure_sets(const Study& study, const TuneResult& result,
                                         const std::string& folder);
/// errors.csv of both, columns.csv, run.yaml. yardsticks: one per set. workers: of the search.
void write_reports(const Study& study, const TuneResult& result, const std::vector<ComparedSet>& sets,
                   const std::vector<YardstickFiles>& yardsticks, const ReportOptions& options, int workers,
                   double seconds);

void print_gains(const Study& study, const TuneResult& result);
/// What the search did, and what the objective came to.
void print_search(const Study& study, const TuneResult& result, const Objective& objective);

}  // namespace armtune::cli
