#pragma once
// Reads the folder that `armtune validate` wrote, and makes the data of a report page from its files.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data from residuals.csv, horizons.csv and run.json. Files that are missing because the log had
/// no torques or no commands are passed over. Files that cannot be understood are left out, and `left_out`
/// lists them. bytes: largest number of bytes of text that the data may take.
ReportData validation_report_of(const std::string& folder, std::size_t bytes);

}  // namespace armtune::internal::report
