#pragma once
// Writing of whole files so that a reader sees the old file or the new one, never a part of it.

#include <string>
#include <string_view>

namespace armtune::internal {

/// Writes a file beside the path and renames it. Throws InputError with path and reason.
void write_text_file(const std::string& path, std::string_view text);

/// Writes a file as write_text_file does, but refuses what refuse_existing refuses (path_state.hpp), also if
/// it appears in the meantime.
void write_new_text_file(const std::string& path, std::string_view text);

/// Returns the path of the file that is being written until it replaces the one at `path`:
/// PATH.armtune.partial, a name that nobody else gives to a file.
std::string partial_path(const std::string& path);
/// Creates that file for writing and returns its descriptor, or -1 with the reason in errno. Anything at that
/// path is removed, not opened, so that nothing is written to a link or a file that another user put there.
/// flags: further flags of open().
int make_partial_file(const std::string& path, int flags = 0);

/// Creates the folder and its parents. Throws InputError with path and reason.
void make_folder(const std::string& path);

/// Writes the entries of the path's folder to the disk, so that a file created or renamed in it survives a
/// power failure. Does nothing where the file system cannot do that.
void sync_folder_of(const std::string& path);

}  // namespace armtune::internal
