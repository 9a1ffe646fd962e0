#pragma once
// Reads the folder that `armtune calibrate` wrote, and makes the data of a report page from its files.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data from parameters.csv, held_out.csv and run.json. Files that cannot be understood are left
/// out, and `left_out` lists them.
ReportData calibration_report_of(const std::string& folder);

}  // namespace armtune::internal::report
