#include "tuner/report/report.hpp"

#include <stdexcept>

#include "sim/csv/text_file.hpp"
#include "tuner/report/page.hpp"
#include "tuner/report/run_report.hpp"

namespace armtune::report {

bool available() {
  return !page_text().empty();
}

std::size_t write_report(const std::string& folder, const std::string& path) {
  const std::string json = report_json(report_of(folder));
  if (!available()) {
    throw std::runtime_error(
        "this armtune was built without the report's page; install node and npm (scripts/setup does) and "
        "build it "
        "again with -DARMTUNE_REPORT=ON");
  }
  const std::string html = filled_page(page_text(), json);
  write_text_file(path, html);
  return html.size();
}

}  // namespace armtune::report
