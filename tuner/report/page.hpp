#pragma once
// The page that shows a report, built from web/ with Node and compiled in.

#include <string>
#include <string_view>

namespace armtune::internal::report {

/// The page without its data; empty where armtune was built without it (ARMTUNE_REPORT).
std::string_view page_text();

/// The page with the data in place of its one mark. json: as report_json writes it. Throws FailedError
/// if the page does not hold the mark exactly once.
std::string filled_page(std::string_view page, std::string_view json);

}  // namespace armtune::internal::report
