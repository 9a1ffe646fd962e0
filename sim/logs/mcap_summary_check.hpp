#pragma once
// Compares the end of an MCAP file, its summary and Footer, with what was read before it.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "sim/logs/mcap_place.hpp"

namespace armtune::internal {

/// The content of a Footer record; offsets in bytes from the beginning of the file. 0: there is none.
struct McapFooter {
  std::uint64_t summary_start = 0;
  std::uint64_t summary_offset_start = 0;
  std::uint32_t summary_crc = 0;
};

/// Reads the content of a Footer record. Throws InputError at its place if it does not have kMcapFooter
/// bytes.
McapFooter mcap_footer(std::span<const std::byte> content, const McapPlace& place);

/// Throws InputError at the place if a stated checksum is neither 0, which means none, nor the computed one.
/// `what` names the bytes.
void check_mcap_crc(const McapPlace& place, std::uint32_t stated, std::uint32_t computed,
                    std::string_view what);

/// Returns the error for a record whose content is longer than kLargestMcapRecord.
InputError too_long_mcap_record(const McapPlace& place, std::uint64_t length);

/// Counts the messages and remembers where the summary begins. check() compares this with what the Footer and
/// the Statistics state.
class McapSummaryCheck {
 public:
  void count_message() noexcept { ++messages_; }

  /// Remembers the offset behind the DataEnd record. Without that record the summary's checksum cannot be
  /// checked.
  void begin_at(std::uint64_t offset) noexcept { begin_ = offset; }

  /// Takes the content of a Statistics record. Throws InputError at its place if it is too short.
  void set_statistics(std::span<const std::byte> content, const McapPlace& place);

  /// Throws InputError at the Footer's place if the summary begins elsewhere than the Footer states or
  /// without a DataEnd record before it, if its checksum is wrong, or if the Statistics state another number
  /// of messages than were counted. crc: of all bytes from the offset of begin_at() to the Footer's own
  /// checksum.
  void check(const McapFooter& footer, std::uint32_t crc, const McapPlace& place) const;

 private:
  std::uint64_t messages_ = 0;
  std::optional<std::uint64_t> begin_;
  std::optional<std::uint64_t> stated_messages_;
};

}  // namespace armtune::internal
