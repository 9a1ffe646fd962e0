#pragma once
// The origin of gains, and how near to its limits the arm came with them in simulation. It is written into
// gain files, for people who find them on a robot.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Returns the origin of the gains of a run folder, as rows (key, words). The rows are:
/// - armtune's version, the command, study, seed, date and what the search found;
/// - from errors.csv the largest use of velocity and torque limits, and the smallest distance to a position
///   limit;
/// - from margins.csv the stability margins, such as delays and gain factors;
/// - every input with its hash.
/// Leaves out what the run does not have. Leaves out figures if gains.yaml was changed since, or if
/// `with_figures` is false. Throws InputError if a file of the run cannot be read.
std::vector<std::pair<std::string, std::string>> origin_of_run(const std::string& folder,
                                                               bool with_figures = true);

/// Returns the folder of the run that a gain set belongs to: the set is the folder of the run, or a file or
/// folder in it (RUN/start, RUN/points/01.yaml). Empty if there is no such run, or if it has no study.
std::string run_above(const std::string& path);

/// Returns the origin of a gains file: armtune's version, and the files with their hashes.
std::vector<std::pair<std::string, std::string>> origin_of_files(const std::vector<std::string>& files);

}  // namespace armtune::internal
