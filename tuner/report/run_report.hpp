#pragma once
// A run folder as the data of a page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// From the folder alone: what it does not hold is left out of the data, and so is what a file spoils that
/// cannot be understood, which is said in `left_out` and the verdict's details. Without scene.json, as of
/// older runs, there is no replay. bytes: what the data may take as text; where they would take more,
/// sections are shortened and recordings left out, and `thinned` and the verdict's details say which. `live`:
/// of a run that has not ended. Throws InputError if it is no folder of a run.
ReportData report_of(const std::string& folder, std::size_t bytes = 5'000'000,
                     const std::optional<Live>& live = {});

/// Adds lines about what the page leaves out to the verdict's details.
void add_notes(ReportData& data);

}  // namespace armtune::internal::report
