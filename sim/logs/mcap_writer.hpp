#pragma once
// Writes recordings as MCAP files (https://mcap.dev), which Foxglove, PlotJuggler, Rerun and rosbag2 open.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "sim/csv/partial_file.hpp"
#include "sim/logs/bag.hpp"
#include "sim/logs/chunk_compression.hpp"
#include "sim/logs/crc32.hpp"
#include "sim/logs/mcap_index.hpp"

namespace armtune::internal {

struct McapOptions {
  ChunkCompression compression = ChunkCompression::kZstd;
  std::size_t chunk_size = 1U << 20;  ///< bytes before compression, at which a chunk ends
  std::string profile = "ros2";       ///< a convention that the topics keep; empty: none
};

/// Writes one file, chunked and indexed, with all checksums of the format. Equal calls write byte-identical
/// files:
///
///     McapWriter bag("run.mcap");
///     const std::size_t joints = bag.add_topic({"/joint_states", "sensor_msgs/msg/JointState", "cdr",
///     definition, "ros2msg"}); bag.write(joints, time, bytes); bag.finish();
///
/// The file appears with finish(); without it nothing is left. Memory holds one chunk and the index.
/// Functions that write throw InputError with path and reason if that fails.
class McapWriter {
 public:
  explicit McapWriter(const std::filesystem::path& path, McapOptions options = {});

  /// Returns the index of the topic. Topics that share a type share its schema. Throws InputError if there
  /// are more than 65535.
  std::size_t add_topic(const BagTopic& topic);

  /// Writes a message of the topic. time: when it was recorded [ns]. Throws InputError if there is no such
  /// topic, if the time is negative, or if the message is longer than half of kLargestMcapRecord, because
  /// readers might refuse such a record.
  void write(std::size_t topic, std::int64_t time, std::span<const std::byte> bytes);

  /// Writes the index and puts the file in its place. Nothing may be written after it.
  void finish();

 private:
  std::uint16_t schema_of(const BagTopic& topic);
  void end_chunk();
  void flush();

  std::string path_;
  McapOptions options_;
  PartialFile file_;
  ByteBuffer out_;    // what is written next to the file
  ByteBuffer chunk_;  // the content of the chunk that is being filled
  McapIndex index_;
  Crc32 crc_;
  std::uint64_t offset_ = 0;  ///< bytes that are in the file
  std::map<std::tuple<std::string, std::string, std::string>, std::uint16_t> schemas_;
  std::vector<std::uint32_t> sequence_;  ///< of the next message of each topic
};

}  // namespace armtune::internal
