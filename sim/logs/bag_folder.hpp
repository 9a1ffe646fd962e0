#pragma once
// Lists the files of a folder in which rosbag2 recorded.

#include <filesystem>
#include <vector>

namespace armtune::internal {

/// The file with the names of the others in a recording of rosbag2.
inline constexpr const char* kBagMetadata = "metadata.yaml";

/// True if the name ends with .db3 or .mcap, or with these and the ending of a compressed file.
bool is_bag_file_name(const std::filesystem::path& file);

/// Returns the .db3 and .mcap files of the folder: those that its metadata.yaml lists, in that order, or
/// without it all of them, in the order of the numbers in their names. Throws InputError with the folder, or
/// with metadata.yaml and a line in it, if there is none, if a listed file is missing, or if the files are
/// compressed as a whole; the message then has the command that decompresses them.
std::vector<std::filesystem::path> bag_files(const std::filesystem::path& folder);

/// Throws InputError with the command that decompresses the file if its name is that of a compressed one,
/// such as x.db3.zstd.
void refuse_compressed_file(const std::filesystem::path& file);

}  // namespace armtune::internal
