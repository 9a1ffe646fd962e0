#pragma once
// Whole files, written so that a reader sees the old one or the new one, never half of it.

#include <string>
#include <string_view>

namespace armtune::internal {

/// Writes beside the path and renames. Throws InputError with path and reason.
void write_text_file(const std::string& path, std::string_view text);

/// The same as write_text_file, but refuses what refuse_existing does (path_state.hpp), also where it appears
/// meanwhile.
void write_new_text_file(const std::string& path, std::string_view text);

/// Where a file grows until it takes the place of the one at `path`: PATH.armtune.partial, a name that nobody
/// else gives to a file.
std::string partial_path(const std::string& path);
/// Makes that file anew, to be written to, and gives its descriptor, or -1 with the reason in errno. Whatever
/// stands there is taken away, not opened: what another user put there, a link or a file of his own, is not
/// written to. flags: further ones of open().
int make_partial_file(const std::string& path, int flags = 0);

/// Makes the folder and its parents. Throws InputError with path and reason.
void make_folder(const std::string& path);

/// Hands the folder's entries to the disk, so that a file made or renamed in it is there after a power cut.
/// Where the file system cannot do that, nothing happens.
void sync_folder_of(const std::string& path);

}  // namespace armtune::internal
