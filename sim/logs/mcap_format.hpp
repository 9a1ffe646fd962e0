#pragma once
// The constants of the published MCAP format (https://mcap.dev/spec, major version 0), and the limits that
// armtune sets for MCAP files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace armtune::internal {

/// The first and the last eight bytes of every MCAP file.
inline constexpr std::array<std::byte, 8> kMcapMagic{std::byte{0x89}, std::byte{'M'}, std::byte{'C'},
                                                     std::byte{'A'},  std::byte{'P'}, std::byte{'0'},
                                                     std::byte{'\r'}, std::byte{'\n'}};

/// The kinds of records, by the byte with which each begins. Later versions may use all other values except
/// 0.
enum class McapRecord : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// Returns the name that the specification gives the kind, such as "MessageIndex"; "unknown" if it names
/// none.
std::string_view mcap_record_name(McapRecord kind);

inline constexpr std::size_t kMcapRecordHead = 9;    ///< bytes: the kind, and the length of the content
inline constexpr std::size_t kMcapMessageHead = 22;  ///< bytes: channel, sequence number and two times
inline constexpr std::size_t kMcapFooter = 20;  ///< bytes of its content, which later versions do not extend

/// Largest content of a record that is kept as a whole, and largest chunk after decompression [bytes].
/// Recorders write chunks of 0.8 to 4 MB; a chunk is larger only if it holds a single larger message.
inline constexpr std::size_t kLargestMcapRecord = 256U << 20;

/// Most bytes of all names, types and definitions of a file together.
inline constexpr std::size_t kMostMcapDefinitions = 64U << 20;

/// A file may decompress to this many times its own size, and to kFreeMcapExpansion bytes in any case. Logs
/// of numbers reach 50.
inline constexpr std::uint64_t kMostMcapExpansion = 1024;
inline constexpr std::uint64_t kFreeMcapExpansion = 64U << 20;

}  // namespace armtune::internal
