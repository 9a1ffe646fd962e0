#pragma once
// Where gains came from and how near to the limits they were simulated, for whoever meets them on a robot.

#include <string>
#include <utility>
#include <vector>

namespace armtune::internal {

/// Rows (what, words). Of a run folder: armtune's version, the command, study, seed, date, what the search
/// found, from errors.csv the largest use of velocity and torque limits and the least way to a position
/// limit, from margins.csv the delays and factors its loops stand, and every input with its hash; what the
/// run has not is left out, and so are figures where gains.yaml was changed since, or `with_figures` is
/// false. Throws InputError for files of it that cannot be read.
std::vector<std::pair<std::string, std::string>> origin_of_run(const std::string& folder,
                                                               bool with_figures = true);

/// The folder of the run that a gain set belongs to: it is a run's own, or a file or folder of it (RUN/start,
/// RUN/points/01.yaml). Empty: of none that has a study.
std::string run_above(const std::string& path);

/// Of a gains file: armtune's version, and the files with their hashes.
std::vector<std::pair<std::string, std::string>> origin_of_files(const std::vector<std::string>& files);

}  // namespace armtune::internal
