#pragma once
// Reads the folder that `armtune plan` wrote, and makes the data of a report page from its files.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data from motion.csv, limits.csv, scene.json and run.json. Files that are missing or cannot be
/// understood are left out, and `left_out` lists them. bytes: largest number of bytes of text that the data
/// may take.
ReportData plan_report_of(const std::string& folder, std::size_t bytes);

}  // namespace armtune::internal::report
