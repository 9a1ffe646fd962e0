#pragma once
// Simulates the result of `armtune tune` again, and writes the files about the result. The metrics in these
// files are those of the new rollouts.

#include <string>
#include <vector>

#include "tuner/run/run_record.hpp"
#include "tuner/session/tune_session.hpp"

namespace armtune::internal {

/// Simulates the start gains and the resulting gains. If armtune replaced the study's own start gains, also
/// simulates these (Study::given). Writes recordings if the run has a folder.
std::vector<ComparedSet> simulate_again(const Study& study, const TuneResult& result,
                                        const TuneSettings& settings);

/// For a study that tunes on several arms, simulates all of these arms again, with the start gains and with
/// the resulting gains. Returns the risk measures of the metrics over the arms, such as the worst values, for
/// both gain sets. If the run has a folder, writes these measures as robust_errors.csv. Throws FailedError if
/// they differ from those that the search computed in Simbody.
std::vector<ComparedSet> simulate_arms_again(const Study& study, const TuneResult& result,
                                             const TuneSettings& settings, RankGroup& ranks);

/// Replaces the simulation results of the best gains by new ones from Simbody, and computes their objective
/// and constraints again. This is needed if an interrupted search ended with results of another engine.
/// simulated: the new results; for a study on several arms, their risk measures.
void judge(const Objective& objective, const ComparedSet& simulated, TuneResult& result);

void write_gains(const Study& study, const TuneResult& result, const std::string& folder);

/// Writes a copy of the ROS parameter file from which the start gains were read. In the copy only the gains
/// are replaced. Returns the name of the copy in the folder. If the start gains were not read from such a
/// file, writes nothing and returns an empty text. Throws InputError if the file cannot contain the gains.
std::string write_controllers(const Study& study, const Gains& gains, const std::string& folder);

/// Writes errors.csv of every gain set, and columns.csv. sets: the start gains, the resulting gains and
/// perhaps the replaced start gains (Study::given); yardsticks: comparisons with the best possible motions,
/// one for the start gains and one for the resulting gains.
void write_errors(const Study& study, const std::vector<ComparedSet>& sets,
                  const std::vector<YardstickFiles>& yardsticks, const std::string& folder);

/// Returns the record of a tuning run. workers: number of the search's workers; seconds: wall time of the
/// whole run [s]; folder: the run folder, which has gains.yaml.
RunRecord record_of_tuning(const Study& study, const TuneResult& result, const Invocation& invocation,
                           int workers, double seconds, const std::string& folder);

}  // namespace armtune::internal
