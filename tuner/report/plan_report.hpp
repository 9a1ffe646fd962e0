#pragma once
// The folder of `armtune plan` as the data of a page.

#include <string>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// From motion.csv, limits.csv, scene.json and run.yaml. What of them is missing or cannot be understood is
/// left out and said, as report_of does. bytes: as there.
ReportData plan_report_of(const std::string& folder, std::size_t bytes);

}  // namespace armtune::internal::report
