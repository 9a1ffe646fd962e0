#pragma once
// Writes the report of a run as one HTML page that needs no other file. A run folder is the folder into which
// an armtune function, such as tune, wrote its results.

#include <string>

namespace armtune {

/// Writes the page of a run folder to `path`, which must not exist. Throws InputError if the folder does not
/// hold a run or the path cannot be written; FailedError if armtune was built without the page.
void write_report(const std::string& folder, const std::string& path);

}  // namespace armtune
