#pragma once
// Makes the list of entries by which a report page shows how a run was made, from the record of the run.

#include <string>

#include "tuner/report/report_data.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {

/// Returns the command, and every declared member of the record as an entry for people: its path and its
/// value as text. The path of an item of a list has the item's first text, such as "versions/eigen/version",
/// or the number of the item, counted from 1.
Provenance provenance_of(const RunRecord& record);

/// Throws InputError if the folder has no run.json, but the run.yaml that older versions of armtune wrote.
void refuse_old_record(const std::string& folder);

}  // namespace armtune::internal::report
