#pragma once
// A run folder as one page.

#include <string>

namespace armtune {

/// Writes the page of a run folder to `path`, which must not exist. Throws InputError if the folder is not
/// that of a run or the path cannot be written, FailedError where armtune was built without the page.
void write_report(const std::string& folder, const std::string& path);

}  // namespace armtune
