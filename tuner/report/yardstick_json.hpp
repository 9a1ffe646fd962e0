#pragma once
// An event and its limit as web/src/data.ts has it.

#include "tuner/report/json.hpp"
#include "tuner/report/yardstick_rows.hpp"

namespace armtune::report {

void write_yardstick(Json& json, const YardstickRow& row);

}  // namespace armtune::report
