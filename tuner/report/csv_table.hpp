#pragma once
// Tables are read in sim/csv; the report knows them by this name.

#include "sim/csv/csv_table.hpp"

namespace armtune::report {

using armtune::CsvTable;

}  // namespace armtune::report
