#pragma once
// Reads a run folder into the data of a report page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data of a run, read from its folder alone. Missing files are left out. So is everything that
/// depends on a file that cannot be understood; `left_out` and the verdict's details say so. Without
/// scene.json, as in older runs, there is no replay. bytes: text that the data may take. If needed, sections
/// are shortened and recordings left out, and `thinned` and the verdict's details say which. live: given
/// while the run has not ended. Throws InputError if the folder is not that of a run.
ReportData report_of(const std::string& folder, std::size_t bytes = 5'000'000,
                     const std::optional<Live>& live = {});

/// Adds lines about the parts that the page leaves out to the verdict's details.
void add_notes(ReportData& data);

}  // namespace armtune::internal::report
