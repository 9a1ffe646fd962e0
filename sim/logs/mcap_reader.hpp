#pragma once
// Opens MCAP files (https://mcap.dev), the default of rosbag2 since ROS 2 Iron, with a reader of armtune's
// own.

#include <filesystem>
#include <memory>

#include "sim/logs/bag.hpp"

namespace armtune::internal {

/// Opens the file for reading from front to back. Memory holds one chunk, of at most kLargestMcapRecord
/// bytes; the index is not needed. Chunks may be uncompressed, LZ4 or Zstandard. All checksums that the file
/// states are checked, and so is the number of messages. Messages come in the order of the file.
///
/// A file that ends before its Footer, because the recorder was killed, is read up to its last whole record;
/// then unfinished() of the reader is true. A chunk is one record.
///
/// Throws InputError with the path if the file cannot be opened or does not begin like an MCAP file. next()
/// throws InputError with the path, and with "byte N" as the key, where the file is damaged or exceeds a
/// limit of mcap_format.hpp.
std::unique_ptr<BagReader> open_mcap(const std::filesystem::path& path);

}  // namespace armtune::internal
