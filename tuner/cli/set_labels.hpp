#pragma once
// Labels of compared gain sets, used in tables, columns and file names.

#include <string>
#include <vector>

namespace armtune::internal::cli {

/// Returns one label for each set, all different: the name of its folder or file, followed by "_2", "_3", ...
/// if an earlier set or another column of the results has that name.
std::vector<std::string> set_labels(const std::vector<std::string>& sets);

/// Throws InputError, naming the set, if a label cannot be used in names of files and columns of results.
void check_labels(const std::vector<std::string>& labels, const std::vector<std::string>& sets);

}  // namespace armtune::internal::cli
