#pragma once
// A run folder as the data of a page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::report {

/// What kind of run left the folder, by the files in it. Throws InputError if it is none that a report is
/// made of.
RunKind kind_of(const std::string& folder);

/// From the folder alone: what it does not hold is left out of the data. Older runs have no scene.json;
/// theirs is made from their study and the files that it names, or left out. Throws InputError naming a file
/// that cannot be understood.
ReportData report_of(const std::string& folder);

}  // namespace armtune::report
