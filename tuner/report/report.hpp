#pragma once
// Writes report.html, one page that shows the results in a run folder. A browser needs no other file for it.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tuner/report/report_data.hpp"

namespace armtune::internal::report {

/// True if armtune was built with the report page.
bool available();

struct Written {
  std::size_t bytes = 0;              ///< size of the written file
  std::vector<std::string> left_out;  ///< for each file that could not be understood, the reason
};

/// The treatment of a file that already exists at the path.
enum class Existing {
  kReplace,  ///< replaces it; for armtune's own file, report.html in a run folder
  kRefuse    ///< throws InputError, because the file may belong to the user
};

/// Writes the report of a run folder to `path`. The page has at most 6 MB. If needed, plots and replays are
/// made coarser, and sections are shortened. A note on the page lists this. live: given while the run has not
/// ended; the page then reloads itself. Throws InputError if the folder is not a run folder, if the path
/// cannot be written, or if the file exists and must not be replaced. Throws FailedError if armtune was built
/// without the page; the message explains how to get it.
Written write_report(const std::string& folder, const std::string& path,
                     Existing existing = Existing::kReplace, const std::optional<Live>& live = {});

}  // namespace armtune::internal::report
