#pragma once
// A scenario with its runs as JSON: one of the `scenarios` of a page's data.

#include "tuner/report/json.hpp"
#include "tuner/report/report_data.hpp"

namespace armtune::report {

void write_scenario(Json& json, const ReportScenario& scenario);

}  // namespace armtune::report
