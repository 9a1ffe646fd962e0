#pragma once
// report.html: a run folder as one page that needs nothing else.

#include <cstddef>
#include <string>

namespace armtune::report {

/// Whether armtune was built with the page.
bool available();

/// Writes the report of a run folder to `path`; returns its size [byte]. Throws InputError naming a file of
/// the folder that cannot be understood or the path if it cannot be written, std::runtime_error, which says
/// how to get it, where the page is not built in.
std::size_t write_report(const std::string& folder, const std::string& path);

}  // namespace armtune::report
