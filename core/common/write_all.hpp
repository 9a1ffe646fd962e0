#pragma once
// Writes a whole text to a file descriptor.

#include <string_view>

namespace armtune::internal {

/// Writes all of the text. It continues after signals, and waits for a descriptor that another process has
/// made non-blocking. Returns false, with the reason in errno, if the descriptor takes no more; a descriptor
/// that accepts nothing without an error counts as EIO.
bool write_all(int descriptor, std::string_view text);

}  // namespace armtune::internal
