// Prints the TypeScript types of a report page's data, web/src/data.ts. The build runs it before npm bundles
// the page.

#include <iostream>

#include "tuner/record/type_printer.hpp"
#include "tuner/report/report_data.hpp"

int main() {
  armtune::internal::record::TypePrinter printer;
  printer.type_of<armtune::internal::report::ReportData>();
  std::cout
      << "// Printed by print_types from tuner/report/report_data.hpp. A page has the data as one JSON object in\n"
         "// <script id=\"report-data\" type=\"application/json\">.\n\n"
         "export type Vec3 = [number, number, number];\n"
         "/** w, x, y, z. */\n"
         "export type Quaternion = [number, number, number, number];\n"
      << printer.text() << std::flush;
  return std::cout.good() ? 0 : 1;
}
