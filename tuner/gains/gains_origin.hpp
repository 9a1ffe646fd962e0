#pragma once
// Describes where gains come from, and how close to its limits the arm came with them in simulation. The
// description is written into exported gains files, for people who find such a file on a robot.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Returns the origin of the gains of a run folder, as rows (key, words). The rows are:
/// - armtune's version, the command, study, seed, date and what the search found;
/// - from verdict.yaml: whether the simulation checks passed, and which failed;
/// - from errors.csv: the largest use of velocity and torque limits, and the smallest distance to a position
///   limit;
/// - from margins.csv: the stability margins, such as delays and gain factors;
/// - the hashes of gains.yaml and of every input.
/// If verdict.yaml or errors.csv is missing, a row says so. Other rows without data are left out. Objective,
/// feasibility, checks, limits and margins are left out if gains.yaml was changed after the run, or if
/// `with_figures` is false. Throws InputError if a file of the run cannot be read.
std::vector<std::pair<std::string, std::string>> origin_of_run(const std::string& folder,
                                                               bool with_figures = true);

/// Returns the names of the simulation checks that failed in a run, such as "yield, endurance"; empty if all
/// passed, or if the run has no verdict.yaml. Throws InputError if that file cannot be read.
std::string failed_checks(const std::string& folder);

/// Returns the folder of the run that the gains at `path` belong to. `path` is the folder of the run itself,
/// or a file or folder in it, such as RUN/start or RUN/points/01.yaml. Returns an empty text if there is no
/// such run, or if it has no study.
std::string run_above(const std::string& path);

/// Returns a row for each input file, with its hash, as origin_of_run() does for the inputs of a run.
std::vector<std::pair<std::string, std::string>> origin_of_inputs(const std::vector<std::string>& files);

/// Returns the origin of a gains file: armtune's version, and the files with their hashes.
std::vector<std::pair<std::string, std::string>> origin_of_files(const std::vector<std::string>& files);

}  // namespace armtune::internal
