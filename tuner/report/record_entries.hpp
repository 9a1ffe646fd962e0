#pragma once
// Lists the entries of a run's record with which a report page shows how the run was made.

#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {

/// Returns the command, and every declared member of the record as an entry for people: its path and its
/// value as text. In such a path, an item of a list is named by its first text, as in
/// "versions/eigen/version", or by its number, counted from 1.
Provenance provenance_of(const RunRecord& record);

/// Throws InputError if the folder has no run.json, but the run.yaml that older versions of armtune wrote.
void refuse_old_record(const std::string& folder);

}  // namespace armtune::internal::report
