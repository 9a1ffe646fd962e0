#pragma once
// Finds out which armtune command wrote a run folder. The contents of a report page depend on the command.

#include <string>

#include "tuner/run/run_kind.hpp"

namespace armtune::internal::report {

/// Returns the command that wrote the folder. It is read from the run's record or, while the run has not
/// ended, from its journal. If neither can be read, the files in the folder decide. Throws InputError if no
/// report can be made from the folder.
RunKind kind_of(const std::string& folder);

}  // namespace armtune::internal::report
