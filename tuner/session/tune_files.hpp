#pragma once
// Simulates the result of `armtune tune` again, and writes the files about it. The metrics in these files are
// those of the new rollouts.

#include <string>
#include <vector>

#include "tuner/session/tune_session.hpp"

namespace armtune::internal {

/// Simulates the start gains, the result and, if other gains replaced them, the start gains of the study's
/// file. Writes recordings if the run has a folder.
std::vector<ComparedSet> simulate_again(const Study& study, const TuneResult& result,
                                        const TuneSettings& settings);

/// Simulates all arms of a study on many arms again, with the start gains and with the result, and returns
/// the risk measure of each. Writes it as robust_errors.csv if the run has a folder. Throws FailedError if it
/// differs from what the search got in Simbody.
std::vector<ComparedSet> simulate_arms_again(const Study& study, const TuneResult& result,
                                             const TuneSettings& settings, RankGroup& ranks);

/// Replaces the results of the best gains by Simbody's fresh rollouts and judges them again. It is needed
/// when an interrupted search ended with results of another engine. simulated: the rollouts that the
/// objective is computed from.
void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result);

void write_gains(const Study& study, const TuneResult& result, const std::string& folder);

/// Writes the ROS parameter file that the start gains came from, with these gains in it and nothing else
/// changed. Returns its name in the folder. Returns an empty text and writes nothing if they came from no
/// such file. Throws InputError if the file cannot hold the gains.
std::string write_controllers(const Study& study, const Gains& gains, const std::string& folder);

/// Writes errors.csv of all sets, and columns.csv. yardsticks: one for the start and one for the result.
void write_errors(const Study& study, const std::vector<ComparedSet>& sets,
                  const std::vector<YardstickFiles>& yardsticks, const std::string& folder);

/// Returns the provenance of a tuning run. workers: number of the search's workers; seconds: wall time of the
/// whole run [s].
Provenance tune_provenance(const Study& study, const TuneResult& result, const Invocation& invocation,
                           int workers, double seconds, const std::string& folder);

}  // namespace armtune::internal
