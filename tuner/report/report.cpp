#include "tuner/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "sim/csv/text_file.hpp"
#include "tuner/report/page.hpp"
#include "tuner/report/run_report.hpp"

namespace armtune::report {
namespace {

constexpr std::size_t kMostBytes = 6'000'000;  // that every mailbox takes

}  // namespace

bool available() {
  return !page_text().empty();
}

Written write_report(const std::string& folder, const std::string& path, const std::optional<Live>& live) {
  if (!available()) {
    throw std::runtime_error(
        "this armtune was built without the report's page; install node and npm (scripts/setup does) and "
        "build it "
        "again with -DARMTUNE_REPORT=ON");
  }
  // With very many scenarios, or meshes beside them, the first try is too large.
  std::size_t recording_bytes = 4'000'000;
  for (;;) {
    ReportData data = report_of(folder, recording_bytes, live);
    const std::string html = filled_page(page_text(), report_json(data));
    if (html.size() <= kMostBytes || recording_bytes < 100'000) {
      write_text_file(path, html);
      if (html.size() > kMostBytes) {
        data.left_out.push_back(
            fmt::format("nothing, but it is {:.1f} MB: meshes and evaluations alone take more than {:.0f} MB",
                        1e-6 * static_cast<double>(html.size()), 1e-6 * static_cast<double>(kMostBytes)));
      }
      return {html.size(), std::move(data.left_out)};
    }
    const std::size_t excess = html.size() - kMostBytes;
    recording_bytes = std::min(recording_bytes / 2, recording_bytes - std::min(recording_bytes, excess));
  }
}

}  // namespace armtune::report
