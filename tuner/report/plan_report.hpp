#pragma once
// Reads the folder of `armtune plan` into the data of a report page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Returns the data from motion.csv, limits.csv, scene.json and run.yaml. Files that are missing or cannot be
/// understood are left out and reported, as in report_of. bytes: as in report_of.
ReportData plan_report_of(const std::string& folder, std::size_t bytes);

}  // namespace armtune::internal::report
