#pragma once
// Writes whole files atomically: another program sees either the old file or the complete new one.

#include <string>
#include <string_view>

namespace armtune::internal {

/// Writes the text to a temporary file in the same folder and renames it to `path`. Throws InputError with
/// path and reason.
void write_text_file(const std::string& path, std::string_view text);

/// Writes a file as write_text_file does, but never replaces an existing one. Throws InputError if something
/// exists at the path (refuse_existing in path_state.hpp), also if it appears during the writing.
void write_new_text_file(const std::string& path, std::string_view text);

/// Returns the path of the temporary file that later replaces the file at `path`: PATH.armtune.partial. No
/// other program uses this ending.
std::string partial_path(const std::string& path);
/// Creates the temporary file for writing and returns its descriptor, or -1 with the reason in errno. If
/// something exists at its path, it is removed and not opened, so that nothing is written to a link or a file
/// that another user put there. flags: further flags of open().
int make_partial_file(const std::string& path, int flags = 0);

/// Creates the folder and its parents. Throws InputError with path and reason.
void make_folder(const std::string& path);

/// Writes the entries of the path's folder to the disk, so that a file created or renamed in it survives a
/// power failure. Does nothing where the file system cannot do that.
void sync_folder_of(const std::string& path);

}  // namespace armtune::internal
