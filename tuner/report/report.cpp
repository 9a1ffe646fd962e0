#include "tuner/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "armtune/error.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/report/page.hpp"
#include "tuner/report/run_report.hpp"

namespace armtune::internal::report {
namespace {

constexpr std::size_t kMostBytes = 6'000'000;  // a size that every mailbox accepts

}  // namespace

bool available() {
  return !page_text().empty();
}

Written write_report(const std::string& folder, const std::string& path, Existing existing,
                     const std::optional<Live>& live) {
  if (!available()) {
    throw FailedError(
        "this armtune was built without the report page; install node and npm with scripts/setup, and build "
        "again with -DARMTUNE_REPORT=ON");
  }
  constexpr std::size_t kAroundData = 1000;  // the HTML element around the data
  const std::size_t room = kMostBytes - std::min(kMostBytes, page_text().size() + kAroundData);
  ReportData data = report_of(folder, room, live);
  const std::string html = filled_page(page_text(), report_json(data));
  if (html.size() > kMostBytes) {
    data.left_out.push_back(
        fmt::format("nothing else, although the page still has {:.1f} MB: its names and texts cannot be "
                    "shortened to {:.0f} MB",
                    1e-6 * static_cast<double>(html.size()), 1e-6 * static_cast<double>(kMostBytes)));
  }
  existing == Existing::kReplace ? write_text_file(path, html) : write_new_text_file(path, html);
  return {html.size(), std::move(data.left_out)};
}

}  // namespace armtune::internal::report
