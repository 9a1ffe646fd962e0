#pragma once
// A run folder as the data of a page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::report {

/// From the folder alone: what it does not hold is left out of the data, and so is what a file spoils that
/// cannot be understood, which is said in `left_out` and the verdict's details. Older runs have no
/// scene.json; theirs is made from their study and the files that it names, or left out. recording_bytes: of
/// text that plots and replay may take, about. `live`: of a run that goes on. Throws InputError if it is no
/// folder of a run.
ReportData report_of(const std::string& folder, std::size_t recording_bytes = 4'000'000,
                     const std::optional<Live>& live = {});

}  // namespace armtune::report
