#pragma once
// Reads the SQLite files (.db3) in which rosbag2 records.

#include <filesystem>
#include <memory>

#include "sim/logs/bag.hpp"

namespace armtune::internal {

/// Opens a .db3 file read-only and without any lock or journal. Its messages come one by one in the order of
/// their ids, which is that of recording, through a cache of at most 16 MB. Topics have a schema if the file
/// has a table message_definitions (ROS 2 Iron and later).
///
/// Throws InputError with the path if the file is missing, is not a SQLite database, lacks the tables topics
/// and messages, or still has a write-ahead log (FILE-wal) beside it. For such a log, the message has the
/// command that merges it. next() throws InputError if the file is damaged, or if it delivers more bytes than
/// it has.
std::unique_ptr<BagReader> open_sqlite_bag(const std::filesystem::path& path);

}  // namespace armtune::internal
