#pragma once
// report.html: a run folder as one page that needs nothing else.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// Whether armtune was built with the page.
bool available();

struct Written {
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  ///< why, of files that could not be understood
};

/// What becomes of a file that is at the path already.
enum class Existing {
  kReplace,  ///< it is armtune's own: the report.html of a run's folder
  kRefuse    ///< it may be the user's
};

/// Writes the report of a run folder to `path`: 6 MB at most, for which plots and replay are made coarser,
/// and sections shortened, where it takes that; the page says so. Throws InputError if it is no folder of a
/// run, if the path cannot be written or is there and not to be replaced, FailedError, which says how
/// to get it, where the page is not built in. `live`: the run has not ended, and the page loads itself again.
Written write_report(const std::string& folder, const std::string& path,
                     Existing existing = Existing::kReplace, const std::optional<Live>& live = {});

}  // namespace armtune::internal::report
