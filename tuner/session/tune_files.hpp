#pragma once
// What a tuning session writes of its result, and the fresh rollouts that it reports.

#include <string>
#include <vector>

#include "tuner/session/tune_session.hpp"

namespace armtune::internal {

/// Simulates the start, the result and, where others took their place, the start gains that the study gives,
/// with recordings where the run has a folder.
std::vector<ComparedSet> simulate_again(const Study& study, const TuneResult& result,
                                        const TuneSettings& settings);

/// Of a study on many arms: the measure of fresh rollouts of all of them, as robust_errors.csv where the run
/// has a folder. Throws FailedError if it is not what the search saw in Simbody.
std::vector<ComparedSet> simulate_arms_again(const Study& study, const TuneResult& result,
                                             const TuneSettings& settings, RankGroup& ranks);

/// Takes Simbody's fresh rollouts of the best gains for what they are, where an interrupted search ended with
/// another engine's. simulated: those the objective is of.
void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result);

void write_gains(const Study& study, const TuneResult& result, const std::string& folder);

/// The ROS parameter file that the start gains came from, with these gains in it and nothing else changed.
/// Returns its name in the folder; empty, and writes nothing, where they came from no such file. Throws
/// InputError if the file cannot hold the gains.
std::string write_controllers(const Study& study, const Gains& gains, const std::string& folder);

/// errors.csv of all sets, and columns.csv. yardsticks: one for the start and one for the result.
void write_errors(const Study& study, const std::vector<ComparedSet>& sets,
                  const std::vector<YardstickFiles>& yardsticks, const std::string& folder);

/// workers: of the search; seconds: of the whole run.
Provenance tune_provenance(const Study& study, const TuneResult& result, const Invocation& invocation,
                           int workers, double seconds, const std::string& folder);

}  // namespace armtune::internal
