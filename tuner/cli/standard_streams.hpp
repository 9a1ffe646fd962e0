#pragma once
// The three files that a program takes for granted.

namespace armtune::cli {

/// Opens /dev/null for those that are closed, as detached programs' may be: else the next files that are
/// opened, a journal say, would be taken for them and written into.
void open_standard_streams();

/// Writes out what was printed. False, with the reason in errno, if it did not all arrive: on a full disk,
/// say.
bool flush_standard_output();

}  // namespace armtune::cli
