#pragma once
// What compared gain sets are called: in tables, in columns, and in names of files.

#include <string>
#include <vector>

namespace armtune::cli {

/// One label for each set, all different: the folder's or the file's name, and "_2", "_3", ... behind it
/// where one before has it already. Throws InputError for a name that files cannot be called after.
std::vector<std::string> set_labels(const std::vector<std::string>& sets);

}  // namespace armtune::cli
