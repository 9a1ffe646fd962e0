#pragma once
// What compared gain sets are called: in tables, in columns, and in names of files.

#include <string>
#include <vector>

namespace armtune::internal::cli {

/// One label for each set, all different: the folder's or the file's name, and "_2", "_3", ... behind it
/// where one before has it already.
std::vector<std::string> set_labels(const std::vector<std::string>& sets);

/// Throws InputError, naming the set, for a label that files and columns of results cannot be called after.
void check_labels(const std::vector<std::string>& labels, const std::vector<std::string>& sets);

}  // namespace armtune::internal::cli
