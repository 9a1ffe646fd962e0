#pragma once
// Reads the files of a run folder, and makes the data of a report page from them.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data of a run. All data come from the run folder. A section whose file is missing is left out.
/// A section whose file cannot be understood is left out too, and is listed in `left_out` and in the
/// verdict's details. Without scene.json, as in older runs, there is no replay. bytes: largest number of
/// bytes of text that the data may take. If needed, sections are shortened and recordings are left out, and
/// `thinned` and the verdict's details list them. live: given while the run has not ended. Throws InputError
/// if the folder is not a run folder.
ReportData report_of(const std::string& folder, std::size_t bytes = 5'000'000,
                     const std::optional<Live>& live = {});

/// Adds the lines of `left_out` and `thinned` to the verdict's details.
void add_notes(ReportData& data);

}  // namespace armtune::internal::report
