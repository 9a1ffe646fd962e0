#pragma once
// The HTML page that shows a report. The page is built from web/ with Node, and compiled into armtune as a
// string. To make a report, armtune inserts the run's data into this string.

#include <string>
#include <string_view>

namespace armtune::internal::report {

/// Returns the page without data. The text is empty if armtune was built without the page (ARMTUNE_REPORT).
std::string_view page_text();

/// Returns the page with the data in place of the mark <!--report-data-->. json: text from
/// report_json. Throws FailedError if the page does not contain the mark exactly once.
std::string filled_page(std::string_view page, std::string_view json);

}  // namespace armtune::internal::report
