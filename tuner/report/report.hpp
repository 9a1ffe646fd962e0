#pragma once
// Writes report.html, which shows a run folder as one page that needs no other file.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// True if armtune was built with the page.
bool available();

struct Written {
  std::size_t bytes = 0;
  std::vector<std::string> left_out;  ///< reasons why files could not be understood
};

/// The treatment of a file that exists already at the path.
enum class Existing {
  kReplace,  ///< the file is armtune's own: report.html of a run's folder
  kRefuse    ///< the file may be the user's
};

/// Writes the report of a run folder to `path`. To keep the page within 6 MB, plots and replay are made
/// coarser and sections are shortened if needed, and the page says so. live: given while the run has not
/// ended; the page then reloads itself. Throws InputError if the folder is not that of a run, if the path
/// cannot be written, or if the file exists and must not be replaced. Throws FailedError if the page is not
/// built in; the message says how to get it.
Written write_report(const std::string& folder, const std::string& path,
                     Existing existing = Existing::kReplace, const std::optional<Live>& live = {});

}  // namespace armtune::internal::report
