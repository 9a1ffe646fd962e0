#pragma once
// report.html: a run folder as one page that needs nothing else.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::report {

/// Whether armtune was built with the page.
bool available();

struct Written {
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  ///< why, of files that could not be understood
};

/// Writes the report of a run folder to `path`: 6 MB at most, for which plots and replay are made coarser
/// where it takes that. Throws InputError if it is no folder of a run or if the path cannot be written,
/// std::runtime_error, which says how to get it, where the page is not built in. `live`: the run goes on, and
/// the page loads itself again.
Written write_report(const std::string& folder, const std::string& path,
                     const std::optional<Live>& live = {});

}  // namespace armtune::report
