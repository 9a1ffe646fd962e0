#pragma once
// Lists the files of a rosbag2 recording, which is a folder.

#include <filesystem>
#include <vector>

namespace armtune::internal {

/// The file in the folder of a rosbag2 recording that lists its other files.
inline constexpr const char* kBagMetadata = "metadata.yaml";

/// True if the name ends with .db3 or .mcap, or with one of these and the ending of a compressed file, such
/// as .db3.zstd.
bool is_bag_file_name(const std::filesystem::path& file);

/// Returns the .db3 and .mcap files that metadata.yaml in the folder lists, in that order. Without
/// metadata.yaml, returns all such files, in the order of the numbers in their names. Throws InputError with
/// the folder, or with metadata.yaml and a line in it, if there is no such file, if a listed file is missing,
/// or if the files are compressed as a whole. In the last case, the message has the command that decompresses
/// them.
std::vector<std::filesystem::path> bag_files(const std::filesystem::path& folder);

/// Throws InputError with the command that decompresses the file if its name is that of a compressed one,
/// such as x.db3.zstd.
void refuse_compressed_file(const std::filesystem::path& file);

}  // namespace armtune::internal
