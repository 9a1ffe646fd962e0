#pragma once
// Opens a bag of any kind that armtune reads.

#include <filesystem>
#include <memory>

#include "sim/logs/bag.hpp"

namespace armtune::internal {

/// True if the path looks like a bag: its name ends with .db3 or .mcap, or with one of these and the ending
/// of a compressed file, or it is a folder with a metadata.yaml.
bool is_bag(const std::filesystem::path& path);

/// Opens a bag: a file .db3 (rosbag2, SQLite) or .mcap, recognised by its first bytes, or the folder of a
/// rosbag2 recording. The files of a folder are read one after the other, in the order of its metadata.yaml,
/// or in the order of their numbers if it has none. Topics of the same name and type in several files are one
/// topic. Throws InputError with the path if it is not a bag. Also throws InputError if the file is
/// compressed as a whole (.db3.zstd); the message then has the command that decompresses it.
std::unique_ptr<BagReader> open_bag(const std::filesystem::path& path);

}  // namespace armtune::internal
